#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Faults on purpose, the long form: kills, failing calls, damage, hostile input. Figures on stdout and in build/soak.json.
#   share/soak.sh             all of it: some 23 000 faults and 10 000 losses of power, half a day to a day on two cores
#   FAULTS=60 share/soak.sh   60 places in each test of the faults, spread evenly over its calls (a number, no
#                             percentage), every kind of fault at each of them: about two hours
# Ends with 1 if a test failed, hung (PART_LIMIT, 24h a part) or was skipped (small disks need root), or a figure is not
# what it must be. Called again after an interruption or a failure, it leaves out the parts that have passed, as long as
# the commit is the same and nothing in the tree has changed. Each part prints a line of figures, {"kills": 160, ...};
# the same figure of several parts is added up:
#   kills            kill -9 of solvers, mpirun and managers at random moments
#   faults_injected  calls that failed, wrote half or killed their program (injected_kills of them), and full disks
#   damage_positions places of files that were damaged               fuzz_executions  inputs to the readers of files
#   lost_samples     samples that are gone, or ends whose samples are others
#   wrong_resumes    ends, states or checkpoints that are not those of the undisturbed run
#   manual_steps     times that the plain command was not enough
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

echo "== building" >&2
build all >&2
export SOAK=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1  # as root the solver's MPI would refuse to start

# A part that has passed leaves its figures here, for this commit; of a tree that has changes nothing is taken over.
kept=build/soak/$(git rev-parse HEAD)${FAULTS:+-$FAULTS}
[ -z "$(git status --porcelain)" ] || { kept=build/soak/changed; rm -rf "$kept"; }
mkdir -p "$kept"
rm -f "$kept"/*.failed
limit=${PART_LIMIT:-24h}
failed=()
write_figures() {  # the sums so far, so that an interrupted soak leaves what it has shown
  {
    echo '{'
    cat "$kept"/* | sed 's/[{}" ]//g; s/,/\n/g' | awk -F: '
      NF == 2 { if (!($1 in sum)) order[++n] = $1; sum[$1] += $2 }
      END { for (i = 1; i <= n; ++i) printf "  \"%s\": %.0f%s\n", order[i], sum[order[i]], i < n ? "," : "" }'
    echo '}'
  } > build/soak.json
}
part() {
  local figures="$kept/${1// /_}" trouble="" status=0
  if [ -e "$figures" ]; then
    echo "== $1: has passed before" >&2
    return
  fi
  echo "== $1" >&2
  timeout --kill-after=1m "$limit" "${@:2}" > build/soak.part 2>&1 || status=$?
  case $status in
    0) grep -q '^\[  SKIPPED \]' build/soak.part && trouble="tests were skipped" ;;
    124) trouble="hung, was ended after $limit" ;;
    137) trouble="hung or was killed; its limit is $limit" ;;
    *) trouble="ended with $status" ;;
  esac
  if [ -n "$trouble" ]; then
    failed+=("$1 ($trouble)")
    figures+=.failed
    cat build/soak.part >&2
  fi
  grep '^{"' build/soak.part > build/soak.line || true
  cat build/soak.line >&2
  mv build/soak.line "$figures"
  write_figures
}
part 'random kills' build/tests/crash/campaign/campaign_crash_test
for test in solver_faults_test campaign_faults_test fencing_test power_loss_test disk_full_test readers_test; do
  part "$test" "build/tests/crash/faults/$test"
done
part 'damage to a run' build/tests/crash/damage/damage_solver_test
part 'damage to a campaign' build/tests/crash/damage/damage_campaign_test
part 'hostile input' share/fuzz.sh

rm -f build/soak.part
write_figures
cat build/soak.json
# FAULTS makes the tests of the faults smaller, and nothing else.
while read -r figure least most; do
  value=$(sed -n "s/^  \"$figure\": \([0-9]*\),*$/\1/p" build/soak.json)
  if [ -z "$value" ]; then
    failed+=("$figure: nothing counted it")
  elif [ "$value" -lt "$least" ] || [ "$value" -gt "${most:-$value}" ]; then
    failed+=("$figure: $value, expected ${most:-at least $least}")
  fi
done <<'END'
kills 300
faults_injected 1
damage_positions 2000
fuzz_executions 10000000
lost_samples 0 0
wrong_resumes 0 0
manual_steps 0 0
END
if [ ${#failed[@]} -gt 0 ]; then
  printf 'failed: %s\n' "${failed[@]}" >&2
  exit 1
fi
rm -rf "$kept"  # the next soak begins anew
