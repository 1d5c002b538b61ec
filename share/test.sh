#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds everything, runs every test through ctest. Further arguments go to ctest (-R Skalak).
more_packages=(slurm-wlm munge iproute2    # tests/slurm starts a Slurm of its own
  gnuplot-nox librsvg2-bin tidy            # tests/campaign/report draws figures and holds the page against HTML
  python3                                  # share/examples
  man-db zsh)                              # tests/install reads the manual, and completes in zsh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
build all
cd build
exec ctest --output-on-failure --parallel "$(nproc)" "$@"
