#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# One branch of the hysteresis: each point starts from the cell that its neighbour ended with.
#   studies/hysteresis/chain.sh up.ini DIR START.h5     START.h5: a checkpoint of the first cell. Run it again after any
#                                                       interruption: what is done stays
# The study's line `fluid.lambda = ...` gives the branch. Point k enters the campaign when point k - 1 has ended; its
# start is that point's last checkpoint, copied to DIR.starts.
set -euo pipefail
study=$1 dir=$2 start=$3
rouleau=${ROULEAU:-build/bin/rouleau}
starts=$dir.starts

mkdir -p "$starts"
IFS=', ' read -ra branch <<< "$(sed -n 's/^fluid\.lambda *= *//p' "$study")"
[[ -e $starts/0.h5 ]] || cp "$start" "$starts/0.h5"

lambdas='' files=''
for k in "${!branch[@]}"; do
  lambdas+="${lambdas:+, }${branch[k]}" files+="${files:+, }$k.h5"
  sed -e "s/^fluid\.lambda *=.*/fluid.lambda = $lambdas/" -e "s/^cell\.mesh_file *=.*/cell.mesh_file = $files/" \
    "$study" > "$starts/study.ini"
  "$rouleau" init -q "$starts/study.ini" "$dir"
  "$rouleau" run "$dir"
  key=$("$rouleau" query -q -C "$dir" --format csv --columns key --where "fluid.lambda = ${branch[k]}" | tail -n 1 | tr -d '\r')
  last=$(find "$dir/points/$key/checkpoints" -name '*.h5' | sort | tail -n 1)
  cp "$last" "$starts/$((k + 1)).h5.tmp" && mv "$starts/$((k + 1)).h5.tmp" "$starts/$((k + 1)).h5"
done
"$rouleau" query -C "$dir"
