#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs every test under AddressSanitizer and UBSan, in a build of its own. Further arguments go to ctest.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# Preloaded libraries come before ASan's. Leaks are looked for in every program but those that start MPI
# (tests/support/leaks_of_mpi.cpp); of what Open MPI and HDF5 keep, the file of suppressions speaks.
export ASAN_OPTIONS=verify_asan_link_order=0:detect_stack_use_after_return=1
export LSAN_OPTIONS=suppressions=$PWD/tests/support/leaks_of_others.txt:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1

# Warnings are judged in the ordinary build: of sanitized code g++ 12 warns without cause.
cmake -S . -B build/sanitize -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" -DROULEAU_SANITIZE=ON -DROULEAU_WERROR=OFF > /dev/null
cmake --build build/sanitize --parallel "$(nproc)"
cd build/sanitize
exec ctest --output-on-failure --parallel "$(nproc)" --timeout 1800 "$@"
