#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs every test under AddressSanitizer and UBSan, in a build of its own. Further arguments go to ctest.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# Leaks are looked for by share/fuzz.sh, without MPI: Open MPI unloads its plugins before the end, and what they leave cannot
# be told from ours. (The build runs the programs, too: they write their manual.) Preloaded libraries come before ASan's.
export ASAN_OPTIONS=verify_asan_link_order=0:detect_stack_use_after_return=1:detect_leaks=0
export UBSAN_OPTIONS=print_stacktrace=1

# Warnings are judged in the ordinary build: of sanitized code g++ 12 warns without cause.
cmake -S . -B build/sanitize -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -DROULEAU_SANITIZE=ON -DROULEAU_WERROR=OFF > /dev/null
cmake --build build/sanitize --parallel "$(nproc)"
cd build/sanitize
exec ctest --output-on-failure --parallel "$(nproc)" --timeout 1800 "$@"
