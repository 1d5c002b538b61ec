#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Follows one branch of the hysteresis: each point starts from the cell its neighbour ended with.
#   studies/hysteresis/chain.sh up.ini DIR       again after any interruption: what is done is kept
# The study holds two lists of equal length, side by side: lambda, and the checkpoint each value starts from. Value k is
# added when value k-1 has ended and its last checkpoint lies in DIR/starts.
set -eu
study=$1 dir=$2
rouleau=${ROULEAU:-rouleau}
