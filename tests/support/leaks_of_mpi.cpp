// SPDX-License-Identifier: BSD-3-Clause
// Leaks are not looked for in programs that start MPI: Open MPI unloads its plugins before the end, and what they leave
// cannot be told from ours. Linked into these programs when they are built with AddressSanitizer.

extern "C" const char* __asan_default_options();
const char* __asan_default_options() { return "detect_leaks=0"; }
