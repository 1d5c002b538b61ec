#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the readers with clang's sanitizers and feeds each with libFuzzer; ends with one line of JSON, and 1 on a find.
#   share/fuzz.sh [RUNS] [FORMAT ...]   inputs of a fast format, default 2500000; a hundredth for slower ones
# Seeds: tests/fuzz/corpus. What is found stays in build/fuzz/found; mend it, then add the file to the corpus.
more_packages=(clang-14 libclang-rt-14-dev)
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
runs=${1:-2500000}
shift || true
formats=("$@")
[ ${#formats[@]} -gt 0 ] || formats=($(ls tests/fuzz/corpus))

echo "== building" >&2
mkdir -p build/fuzz/found
cmake -S . -B build/fuzz -DROULEAU_FUZZ=ON -DROULEAU_NATIVE=OFF -DROULEAU_WERROR=OFF -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_CXX_FLAGS="-O1 -Wno-unknown-warning-option" \
  >build/fuzz/configure.log 2>&1 || { cat build/fuzz/configure.log >&2; exit 1; }
cmake --build build/fuzz --parallel "$(nproc)" --target fuzz >&2

export LSAN_OPTIONS=suppressions=$PWD/tests/support/leaks_of_others.txt:print_suppressions=0
json=""
total=0
failed=0
for format in "${formats[@]}"; do
  wanted=$runs
  longest=2048  # bytes
  case $format in
    off | stl | solver_log) ;;
    checkpoint) longest=16384 ;;
    checkpoint_texts) longest=8192 wanted=$((runs / 500)) ;;  # through HDF5
    *) wanted=$((runs / 100)) ;;
  esac
  grown=build/fuzz/corpus/$format
  log=build/fuzz/$format.log
  mkdir -p "$grown"
  result=clean
  build/fuzz/tests/fuzz/fuzz --format="$format" -runs="$wanted" -max_len="$longest" -timeout=5 -rss_limit_mb=512 \
    -malloc_limit_mb=256 -use_value_profile=1 -print_final_stats=1 -artifact_prefix="build/fuzz/found/$format-" \
    "$grown" "tests/fuzz/corpus/$format" >"$log" 2>&1 || {
    result=found
    failed=$((failed + 1))
    tail -n 30 "$log" >&2
  }
  done_runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  echo "$format: ${done_runs:-0} inputs, $result" >&2
  total=$((total + ${done_runs:-0}))
  json+="\"fuzz_$format\": ${done_runs:-0}, "
done
echo "{$json\"fuzz_executions\": $total, \"fuzz_finds\": $failed}"
[ $failed = 0 ]
