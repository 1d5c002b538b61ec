// SPDX-License-Identifier: BSD-3-Clause
// `rouleau retry POINT...`: lets points that failed, were cancelled or used up their retries start again.
#include <ostream>

#include "commands/verbs.hpp"
#include "commands/wish.hpp"
#include "store/store.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

void describe(po::options_description& options) {
  options.add_options()("all-failed", po::bool_switch(),
                        "all points that are failed, refused, crashed or exhausted (not the cancelled ones)");
}

bool has_failed(State state) {
  return state == State::failed || state == State::refused || state == State::crashed || state == State::exhausted;
}

std::vector<PointRow> all_failed(const CommandLine& line) {
  if (!line.words.empty()) fail(Exit::usage, "rouleau retry: give points or --all-failed, not both.");
  std::vector<PointRow> points = Store::open_reader(line.directory / "campaign.db").points();
  std::erase_if(points, [](const PointRow& point) { return !has_failed(point.state); });
  if (points.empty()) fail(Exit::not_found, "no point has failed; there is nothing to retry.");
  return points;
}

int retry(const CommandLine& line) {
  std::vector<PointRow> points = line.is_set("all-failed") ? all_failed(line) : named_points(line, "retry");
  bool all_can = true;
  std::erase_if(points, [&](const PointRow& point) {
    const bool can = has_failed(point.state) || point.state == State::cancelled || point.state == State::running;
    if (can) return false;
    line.io.err << fmt::format("point #{} ({}) is {}; there is nothing to retry.\n", point.ordinal, point.key,
                               word_of(point.state));
    all_can = false;
    return true;
  });
  wish(line, Wish::retry, points);
  return static_cast<int>(all_can ? Exit::ok : Exit::failed);
}

}  // namespace

const Verb retry_verb = {
    "retry",
    "let failed, exhausted or cancelled points start again",
    "POINT... | --all-failed [-C DIR]",
    "  rouleau retry '#3'             the third point, from its last checkpoint\n"
    "  rouleau retry --all-failed     after the cause was corrected\n",
    "The next `rouleau run` starts them. A running point is retried only if its host cannot be seen any more;\n"
    "its old attempt is fenced off and cannot write.\n",
    Words::points,
    false,
    describe,
    retry,
};

}  // namespace rouleau::campaign
