#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and runs the validation suite: a table on stdout, the checks in build/validation.json. Ends with 1 if one fails.
#   share/validate.sh [--only duct,membrane] [--list]
# Without arguments the report is also looked at in a browser, at the end (chromium, gnuplot and poppler-utils are
# installed for it).
# What is simulated stays in build/validation: called again, it goes on where it was, and repeats nothing.
[ $# -gt 0 ] || more_packages=(gnuplot-nox chromium poppler-utils)
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

echo "== building" >&2
[ $# -gt 0 ] || build report_browser_test >&2
build validate >&2

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1  # as root the solver's MPI would refuse to start
looks_at_report=$([ $# -gt 0 ] || echo yes)
[ "${1:-}" = --list ] || set -- --studies studies/validation "$@"
status=0
build/bin/validate "$@" || status=$?
[ -z "$looks_at_report" ] || build/bin/report_browser_test >&2 || status=1
exit $status
