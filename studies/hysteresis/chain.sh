#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# One branch of the hysteresis: each point starts from the cell that its neighbour ended with.
#   studies/hysteresis/chain.sh up.ini DIR START.h5     START.h5: a checkpoint of the first cell. Run it again after any
#                                                       interruption: what is done stays
# The study's line `fluid.lambda = ...` gives the branch. Point k enters the campaign when point k - 1 has ended; its
# start is that point's last checkpoint, copied to DIR.starts.
set -euo pipefail
[[ $# -eq 3 ]] || { echo "usage: $0 STUDY.ini DIR START.h5" >&2; exit 2; }
study=$1 dir=${2%/} start=$3
rouleau=${ROULEAU:-build/bin/rouleau}
starts=$dir.starts

# keep FILE NAME: a copy that is whole or not there
keep() { cp "$1" "$starts/$2.tmp" && mv "$starts/$2.tmp" "$starts/$2"; }
# value_of COLUMN LAMBDA
value_of() {
  "$rouleau" query -q -C "$dir" --format csv --no-header --columns "$1" --where "fluid.lambda = $2" | tr -d '\r'
}
stop() { echo "$1" >&2; exit "$2"; }

mkdir -p "$starts"
[[ -e $starts/0.h5 ]] || keep "$start" 0.h5
cmp -s "$start" "$starts/0.h5" || stop "$dir began from another cell than $start ($starts/0.h5): give another DIR" 2
IFS=', ' read -ra branch <<< "$(sed -n 's/^fluid\.lambda *= *//p' "$study")"

lambdas='' files=''
for k in "${!branch[@]}"; do
  lambdas+="${lambdas:+, }${branch[k]}" files+="${files:+, }$k.h5"
  [[ ! -e $starts/$((k + 1)).h5 ]] || continue
  sed -e "s/^fluid\.lambda *=.*/fluid.lambda = $lambdas/" -e "s/^cell\.mesh_file *=.*/cell.mesh_file = $files/" \
    "$study" > "$starts/study.ini"
  "$rouleau" init -q "$starts/study.ini" "$dir"
  if ! "$rouleau" run "$dir" || [[ $(value_of state "${branch[k]}") != "done" ]]; then
    stop "lambda = ${branch[k]} did not end (\`rouleau status $dir\`, \`rouleau retry\`); then call this again" 4
  fi
  keep "$(find "$dir/points/$(value_of key "${branch[k]}")/checkpoints" -name '*.h5' | sort | tail -n 1)" $((k + 1)).h5
done
"$rouleau" query -C "$dir"
