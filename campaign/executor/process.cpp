// SPDX-License-Identifier: BSD-3-Clause
// Reading /proc.
#include "executor/process.hpp"

#include <unistd.h>

#include <chrono>
#include <climits>
#include <fstream>
#include <iterator>
#include <sstream>

#include "study/record.hpp"

namespace rouleau::campaign {

std::string host_name() {
  char name[HOST_NAME_MAX + 1] = {};
  ::gethostname(name, sizeof name - 1);
  return name;
}

std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

std::optional<ProcessIdentity> identity_of(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  const std::string stat{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  // Field 2 is the program's name in brackets and may hold anything: the fields are counted from the last bracket.
  const std::size_t bracket = stat.rfind(')');
  if (bracket == std::string::npos) return std::nullopt;
  std::istringstream fields(stat.substr(bracket + 1));
  std::string state, skipped;
  fields >> state;
  if (state == "Z" || state == "X") return std::nullopt;
  constexpr int start_ticks_field = 22;
  for (int field = 4; field < start_ticks_field; ++field) fields >> skipped;
  ProcessIdentity process{host_name(), boot_id(), pid, 0};
  if (!(fields >> process.start_ticks)) return std::nullopt;
  return process;
}

Life life_of(const ProcessIdentity& process) {
  if (process.pid <= 0) return Life::none;
  if (process.host != host_name()) return Life::unknown;
  if (process.boot_id != boot_id()) return Life::dead;
  return identity_of(static_cast<pid_t>(process.pid)) == process ? Life::alive : Life::dead;
}

std::string process_json(const ProcessIdentity& process, int ranks, std::int64_t checkpoint_step) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const nlohmann::ordered_json json = {{"contract", 1},
                                       {"host", process.host},
                                       {"pid", process.pid},
                                       {"start_ticks", process.start_ticks},
                                       {"boot_id", process.boot_id},
                                       {"ranks", ranks},
                                       {"checkpoint_step", checkpoint_step},
                                       {"started_unix_s", std::chrono::duration<double>(now).count()}};
  return record_text(json);
}

}  // namespace rouleau::campaign
