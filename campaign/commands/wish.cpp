// SPDX-License-Identifier: BSD-3-Clause
// Request first, then the lock if it is free.
#include "commands/wish.hpp"

#include <algorithm>
#include <ostream>

#include "commands/manager.hpp"
#include "report/find_points.hpp"

namespace rouleau::campaign {

std::vector<PointRow> named_points(const CommandLine& line, const char* verb) {
  if (line.words.empty())
    fail(Exit::usage, "rouleau {0}: names no point. Try `rouleau {0} '#3'` or `rouleau {0} lambda=5`.", verb);
  const Store store = Store::open_reader(line.directory / "campaign.db");
  std::vector<PointRow> points;
  for (const std::string& word : line.words) {
    for (const PointRow& point : find_points(store, word)) {
      if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
    }
  }
  return points;
}

void wish(const CommandLine& line, Wish wish, const std::vector<PointRow>& points) {
  if (points.empty()) return;
  for (const PointRow& point : points) leave_request(line.directory, wish, point.key);
  const auto say = [&](const std::string& message) {
    if (!line.quiet) line.io.err << message << std::endl;
  };
  try {
    Manager manager(line.directory, wish == Wish::cancel ? "cancel" : "retry", say);
    manager.reconcile(true);
    // Another rouleau may have carried the wish out, and ended, while we waited for the lock.
    if (std::none_of(points.begin(), points.end(),
                     [&](const PointRow& point) { return is_left(line.directory, point.key); }))
      say("carried out by the rouleau that was running this campaign");
    manager.take_requests();
  } catch (const Error& error) {
    if (error.code() != Exit::locked) throw;
    say("handed to the rouleau that is running this campaign; it acts within a second");
  }
}

}  // namespace rouleau::campaign
