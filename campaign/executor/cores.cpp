// SPDX-License-Identifier: BSD-3-Clause
// Affinity masks as lists of cores.
#include "executor/cores.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace rouleau::campaign {

Cores cores_of(pid_t pid) {
  cpu_set_t set;
  CPU_ZERO(&set);
  Cores cores;
  if (::sched_getaffinity(pid, sizeof set, &set) != 0) return cores;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  }
  return cores;
}

Cores allowed_cores() { return cores_of(0); }

Cores free_cores(const Cores& allowed, const std::vector<Occupant>& occupants) {
  Cores free = allowed;
  std::size_t unpinned_ranks = 0;
  for (const Occupant& occupant : occupants) {
    if (occupant.cores.size() > static_cast<std::size_t>(occupant.ranks)) {
      unpinned_ranks += static_cast<std::size_t>(occupant.ranks);
      continue;
    }
    std::erase_if(free, [&](int core) {
      return std::find(occupant.cores.begin(), occupant.cores.end(), core) != occupant.cores.end();
    });
  }
  free.resize(free.size() - std::min(free.size(), unpinned_ranks));
  return free;
}

Cores cores_of_solvers() {
  const std::size_t all = std::max(1U, std::thread::hardware_concurrency());
  Cores busy;
  std::error_code unseen;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", unseen)) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::string program;
    std::getline(std::ifstream(entry.path() / "comm"), program);
    if (program != "rouleau-solver") continue;
    const Cores cores = cores_of(std::atoi(name.c_str()));
    if (cores.size() < all) busy.insert(busy.end(), cores.begin(), cores.end());
  }
  return busy;
}

Cores quiet_first(Cores cores, const Cores& busy) {
  std::stable_partition(cores.begin(), cores.end(),
                        [&](int core) { return std::find(busy.begin(), busy.end(), core) == busy.end(); });
  return cores;
}

std::string to_text(const Cores& cores) { return fmt::format("{}", fmt::join(cores, ",")); }

bool pin_to(const Cores& cores) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int core : cores) CPU_SET(core, &set);
  return ::sched_setaffinity(0, sizeof set, &set) == 0;
}

}  // namespace rouleau::campaign
