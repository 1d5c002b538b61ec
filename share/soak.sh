#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Faults on purpose, the long form: kills, failing calls, damage, hostile input. Figures on stdout and in build/soak.json.
#   share/soak.sh             all of it: some 14 000 faults and 10 000 losses of power, half a day to a day on two cores
#   FAULTS=60 share/soak.sh   60 places in each test of the faults, spread evenly over its calls (a number, no
#                             percentage), every kind of fault at each of them: one to two hours
# Ends with 1 if a test failed or was skipped (small disks need root), or a figure is missing. Each part prints a line of
# figures, {"kills": 160, ...}; the same figure of several parts is added up:
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

figures=build/soak.lines
: > "$figures"
failed=()
write_figures() {  # the sums so far, so that an interrupted soak leaves what it has shown
  {
    echo '{'
    sed 's/[{}" ]//g; s/,/\n/g' "$figures" | awk -F: '
      NF == 2 { if (!($1 in sum)) order[++n] = $1; sum[$1] += $2 }
      END { for (i = 1; i <= n; ++i) printf "  \"%s\": %.0f%s\n", order[i], sum[order[i]], i < n ? "," : "" }'
    echo '}'
  } > build/soak.json
}
part() {
  echo "== $1" >&2
  "${@:2}" > build/soak.part 2>&1 || { failed+=("$1"); cat build/soak.part >&2; }
  if grep -q '^\[  SKIPPED \]' build/soak.part; then
    failed+=("$1 (tests were skipped)")
    grep -B 1 '^\[  SKIPPED \]' build/soak.part >&2
  fi
  grep '^{"' build/soak.part | tee -a "$figures" >&2 || true
  write_figures
}
part 'random kills' build/tests/crash/campaign/campaign_crash_test
for test in solver_faults_test campaign_faults_test fencing_test power_loss_test disk_full_test; do
  part "$test" "build/tests/crash/faults/$test"
done
part 'damage to a run' build/tests/crash/damage/damage_solver_test
part 'damage to a campaign' build/tests/crash/damage/damage_campaign_test
part 'hostile input' share/fuzz.sh

rm -f "$figures" build/soak.part
cat build/soak.json
for figure in kills faults_injected damage_positions fuzz_executions lost_samples wrong_resumes manual_steps; do
  grep -q "\"$figure\": " build/soak.json || failed+=("$figure: nothing counted it")
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "failed: ${failed[*]}" >&2
  exit 1
fi
