#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# From an empty machine to a phase table: install, build, run the small λ sweep of studies/quick, print its result.
#   share/quickstart.sh [DIRECTORY]     the campaign's folder, default build/quick; run again to resume
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
campaign=${1:-build/quick}

echo "== building"
build rouleau rouleau-solver
rouleau=build/bin/rouleau

echo "== $campaign: $(grep -c . studies/quick/study.ini) lines of study, two jobs at a time (Ctrl-C stops; run again to go on)"
"$rouleau" init studies/quick/study.ini "$campaign"
"$rouleau" run "$campaign"

echo
echo "== phase table"
"$rouleau" query "$campaign"
echo
echo "The database: $campaign/campaign.db"
echo "More:         $rouleau status $campaign; $rouleau query $campaign --help"
