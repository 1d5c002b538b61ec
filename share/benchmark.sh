#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and measures: tables on stdout, all figures in build/benchmark.json. Leave the machine alone meanwhile.
#   share/benchmark.sh [--quick] [--only fluid,coupled,ranks,jobs,checkpoint,sweep]
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

echo "== building" >&2
build benchmark >&2

# Ranks pin themselves. On a single core they must yield to each other.
options=(--oversubscribe --bind-to none -n 2)
[ "$(nproc)" -ge 2 ] || options+=(--mca mpi_yield_when_idle 1)
[ "$(id -u)" -ne 0 ] || options+=(--allow-run-as-root)
exec mpirun "${options[@]}" build/bin/benchmark "$@"
