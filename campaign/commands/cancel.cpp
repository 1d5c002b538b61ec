// SPDX-License-Identifier: BSD-3-Clause
// `rouleau cancel POINT...`: takes points out of the campaign; running ones stop behind a checkpoint.
#include <ostream>

#include "commands/verbs.hpp"
#include "commands/wish.hpp"

namespace rouleau::campaign {

namespace {

int cancel(const CommandLine& line) {
  std::vector<PointRow> points = named_points(line, "cancel");
  bool all_can = true;
  std::erase_if(points, [&](const PointRow& point) {
    if (point.state != State::done) return false;
    line.io.err << fmt::format("point #{} ({}) is done; there is nothing to cancel.\n", point.ordinal, point.key);
    all_can = false;
    return true;
  });
  wish(line, Wish::cancel, points);
  return static_cast<int>(all_can ? Exit::ok : Exit::failed);
}

}  // namespace

const Verb cancel_verb = {
    "cancel",
    "take points out; a running job writes a checkpoint and stops",
    "POINT... [-C DIR]",
    "  rouleau cancel '#3'                    the third point of the campaign in this directory\n"
    "  rouleau cancel lambda=5 -C my-campaign all points with this value\n",
    "Nothing is deleted; `rouleau retry` brings the points back, from their last checkpoint. Works while\n"
    "`rouleau run` is running.\n",
    Words::points,
    false,
    nullptr,
    cancel,
};

}  // namespace rouleau::campaign
