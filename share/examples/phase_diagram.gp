# SPDX-License-Identifier: BSD-3-Clause
# Displacement against viscosity contrast with error bars, by class: gnuplot -c phase_diagram.gp points.csv picture.svg
set datafile separator comma
set datafile columnheaders
set terminal svg size 640,420 background "white"
set output ARG2
set xlabel "viscosity contrast λ"
set ylabel "mean displacement, µm"
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set key above
is(name, x) = stringcolumn("class") eq name ? x : NaN
bar(error) = error == error ? error : 0   # a point without an error has no bar
plot for [i=1:3] ARG1 using (is(word("croissant slipper undecided", i), column("lambda"))):"d_mean_um" \
  :(bar(column("d_error_um"))) with yerrorbars pointtype 2 * i + 3 title word("croissant slipper undecided", i)
