#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Draws d(t) and asphericity(t) of a campaign, one curve a lambda:  studies/lambda-transition/figure.sh DIR  (needs gnuplot)
# Beside this script: series.csv, every fourth sample of all points, and figure.svg.
set -euo pipefail
rouleau=$(realpath "${ROULEAU:-build/bin/rouleau}")
campaign=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")"

"$rouleau" export "$campaign" --samples | tr -d '\r' | awk -F, -v OFS=, '
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; print "lambda,time_s,d_um,asphericity"; next }
  $1 != point { point = $1; n = 0 }
  n++ % 4 == 0 { printf "%s,%.4f,%.5f,%.5f\n", $column["lambda"], $column["time_s"], $column["d_um"], $column["asphericity"] }
' > series.csv

gnuplot <<'END'
set terminal svg size 760,620 font "sans,13" background "white"
set output "figure.svg"
set datafile separator ","
lambdas = system("tail -n +2 series.csv | cut -d, -f1 | sort -gu | tr '\n' ' '")
set multiplot layout 2,1
set key outside right title "λ"
set grid lc "#dddddd"
set yrange [0:*]
array colours[8] = ["#440154", "#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d", "#a0da39", "#fd8d3c"]
set ylabel "d, µm"
plot for [i = 1:words(lambdas)] "series.csv" using 2:($1 == word(lambdas, i) + 0 ? $3 : 1/0) with lines lw 1.6 lc rgb colours[i] title word(lambdas, i)
set xlabel "t, s"
set ylabel "asphericity"
plot for [i = 1:words(lambdas)] "series.csv" using 2:($1 == word(lambdas, i) + 0 ? $4 : 1/0) with lines lw 1.6 lc rgb colours[i] title word(lambdas, i)
END
