// SPDX-License-Identifier: BSD-3-Clause
// The plan, and the line of counts at the end of the program.
#include "crash/faults/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <span>

namespace rouleau::testing {

namespace {

constexpr std::array<Injection, 3> kinds_of_reads = {{
    {0, Fault::error, EIO, false, Watch::reads},
    {0, Fault::brief, 0, false, Watch::reads},
    {0, Fault::error, EIO, true, Watch::reads},
}};
constexpr std::array<Injection, 7> kinds_of_changes = {{
    {0, Fault::error, EIO, false},
    {0, Fault::kill, 0, false},
    {0, Fault::error, ENOSPC, false},
    {0, Fault::torn, 0, false},
    {0, Fault::error, ENOSPC, true},
    {0, Fault::brief, 0, false},
    {0, Fault::error, EDQUOT, false},
}};

class PrintTally : public ::testing::Environment {
  void TearDown() override {
    const Tally& t = tally();
    fmt::print(
        "{{\"faults_injected\": {}, \"injected_kills\": {}, \"power_losses\": {}, \"freezes\": {}, \"lost_samples\": "
        "{}, "
        "\"wrong_resumes\": {}, \"manual_steps\": {}}}\n",
        t.faults_injected, t.injected_kills, t.power_losses, t.freezes, t.lost_samples, t.wrong_resumes,
        t.manual_steps);
    std::fflush(stdout);
  }
};
const auto* const printer = ::testing::AddGlobalTestEnvironment(new PrintTally);

}  // namespace

bool is_long_form() { return std::getenv("SOAK") != nullptr; }

std::vector<std::int64_t> planned_places(std::int64_t count, std::int64_t sample) {
  const char* text = std::getenv("FAULTS");
  const std::int64_t wanted = text != nullptr ? std::atoll(text) : is_long_form() ? count : sample;
  const std::int64_t planned = std::min(count, wanted);
  std::vector<std::int64_t> places;
  for (std::int64_t i = 0; i < planned; ++i) places.push_back(1 + i * count / planned);
  return places;
}

std::vector<Injection> planned_faults(const std::vector<RecordedCall>& calls, std::int64_t sample, Watch watch) {
  const std::span<const Injection> kinds =
      watch == Watch::reads ? std::span<const Injection>(kinds_of_reads) : std::span<const Injection>(kinds_of_changes);
  std::vector<Injection> faults;
  std::size_t turn = 0;
  for (const std::int64_t place : planned_places(static_cast<std::int64_t>(calls.size()), sample)) {
    for (const Injection& kind : kinds) {
      if (!is_long_form() && &kind != &kinds[turn % kinds.size()]) continue;
      auto call = calls.begin() + (place - 1);
      if (kind.fault == Fault::brief || kind.fault == Fault::torn) {
        const auto is_transfer = [](const RecordedCall& c) {
          return c.bytes.size() > 1 || (c.name == "read" && c.result > 1);
        };
        call = is_long_form() && !is_transfer(*call) ? calls.end() : std::find_if(call, calls.end(), is_transfer);
      }
      if (call == calls.end()) continue;
      faults.push_back(kind);
      faults.back().at = call->number;
    }
    ++turn;
  }
  return faults;
}

Tally& tally() {
  static Tally the_tally;
  return the_tally;
}

void count(const Injection& injection) {
  ++tally().faults_injected;
  if (injection.fault == Fault::kill || injection.fault == Fault::torn) ++tally().injected_kills;
}

}  // namespace rouleau::testing
