// SPDX-License-Identifier: BSD-3-Clause
#include "machine.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "parallel/version.hpp"
#include "run/version.hpp"
#include "storage/version.hpp"

namespace rouleau::speed {

using nlohmann::ordered_json;

namespace {

std::string first_line(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// The value of the first line `key<blanks>: value`; empty if there is none.
std::string value_in(const std::filesystem::path& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const auto colon = line.find(':');
    if (!line.starts_with(key) || colon == std::string::npos) continue;
    const auto begin = line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

/// As "L1 Data 32K, L2 Unified 1024K", those of one core.
std::string caches() {
  std::string text;
  for (int index = 0;; ++index) {
    const auto cache = std::filesystem::path("/sys/devices/system/cpu/cpu0/cache") / fmt::format("index{}", index);
    if (!std::filesystem::exists(cache)) return text;
    text += fmt::format("{}L{} {} {}", text.empty() ? "" : ", ", first_line(cache / "level"),
                        first_line(cache / "type"), first_line(cache / "size"));
  }
}

std::array<double, 3> load_averages() {
  std::array<double, 3> load{};
  static_cast<void>(::getloadavg(load.data(), 3));
  return load;
}

double seconds(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

}  // namespace

ordered_json machine_facts() {
  utsname system{};
  ::uname(&system);
  return {{"cpu", value_in("/proc/cpuinfo", "model name")},
          {"cores", ::sysconf(_SC_NPROCESSORS_ONLN)},
          {"caches", caches()},
          {"memory", value_in("/proc/meminfo", "MemTotal")},
          {"kernel", fmt::format("{} {} {}", system.sysname, system.release, system.machine)},
          {"date_utc", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))}};
}

ordered_json version_facts() {
  return {{"rouleau", version()},
          {"git", git_hash()},
          {"compiler", "g++ " __VERSION__},
          {"compiler_options", ROULEAU_COMPILE_OPTIONS},
          {"mpi", mpi_version()},
          {"hdf5", hdf5_version()},
          {"all", version_text(hdf5_version(), mpi_version())}};
}

ForeignLoad::ForeignLoad(const Communicator& comm) : comm_(comm), load_at_begin_(load_averages()), begin_(now()) {}

ForeignLoad::Moment ForeignLoad::now() const {
  Moment moment;
  moment.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  std::istringstream fields(first_line("/proc/stat"));
  std::string name;
  std::array<double, 8> ticks{};  // user, nice, system, idle, iowait, irq, softirq, steal
  fields >> name;
  for (double& t : ticks) fields >> t;
  const auto per_s = static_cast<double>(::sysconf(_SC_CLK_TCK));
  moment.busy_s = (ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6]) / per_s;
  moment.stolen_s = ticks[7] / per_s;
  rusage own{};
  ::getrusage(RUSAGE_SELF, &own);
  const double own_s = seconds(own.ru_utime) + seconds(own.ru_stime);
  moment.own_s = 1e-6 * static_cast<double>(comm_.sum(static_cast<std::int64_t>(1e6 * own_s)));
  return moment;
}

ordered_json ForeignLoad::facts() const {
  const Moment end = now();
  const double wall_s = end.wall_s - begin_.wall_s;
  const double others_s = (end.busy_s - begin_.busy_s) - (end.own_s - begin_.own_s);
  return {{"load_average_at_begin", load_at_begin_},
          {"load_average_at_end", load_averages()},
          {"cores_busy_with_others", std::max(0.0, others_s / wall_s)},
          {"cores_stolen", (end.stolen_s - begin_.stolen_s) / wall_s},
          {"wall_s", wall_s}};
}

}  // namespace rouleau::speed
