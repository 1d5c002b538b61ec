// SPDX-License-Identifier: BSD-3-Clause
#include "pair.hpp"

#include <sched.h>

#include <chrono>
#include <thread>

#include "base/error.hpp"

namespace rouleau::speed {

namespace {

void pin_to_own_core(int rank, int ranks) {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (::sched_getaffinity(0, sizeof allowed, &allowed) != 0 || CPU_COUNT(&allowed) < ranks) return;
  int seen = 0;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &allowed) || seen++ != rank) continue;
    cpu_set_t own;
    CPU_ZERO(&own);
    CPU_SET(core, &own);
    ::sched_setaffinity(0, sizeof own, &own);
  }
}

}  // namespace

Pair::Pair(const Communicator& both) : both_(both) {
  if (both.size() != 2) fail(Exit::usage, "the benchmark needs two ranks, not {}. Use share/benchmark.sh", both.size());
  pin_to_own_core(both.rank(), both.size());
}

void Pair::meet() const {
  MPI_Request request;
  MPI_Ibarrier(both_.raw(), &request);
  for (;;) {
    int has_come = 0;
    MPI_Test(&request, &has_come, MPI_STATUS_IGNORE);
    if (has_come != 0) return;
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
}

}  // namespace rouleau::speed
