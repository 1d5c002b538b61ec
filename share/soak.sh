#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Faults on purpose, the long form: kills, failing calls, damage, hostile input. Figures on stdout and in build/soak.json.
#   share/soak.sh             every call of every program: some hours on two cores; ends with 1 if anything was lost
#   FAULTS=60 share/soak.sh   60 of the calls: about an hour
# Each part prints a line of figures, {"kills": 160, ...}; the same figure of several parts is added up.
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
if [ ${#failed[@]} -gt 0 ]; then
  echo "failed: ${failed[*]}" >&2
  exit 1
fi
