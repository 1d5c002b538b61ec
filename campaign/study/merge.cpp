// SPDX-License-Identifier: BSD-3-Clause
// Merging by identity.
#include "study/merge.hpp"

#include <algorithm>
#include <map>

namespace rouleau::campaign {

Merge merge(const std::vector<Point>& existing, const Expansion& expansion) {
  std::map<std::string, const Point*> by_identity;
  std::set<std::string> keys;
  int last_ordinal = 0;
  for (const Point& point : existing) {
    by_identity[point.identity] = &point;
    keys.insert(point.key);
    last_ordinal = std::max(last_ordinal, point.ordinal);
  }
  Merge result;
  std::set<std::string> named;
  for (const Candidate& candidate : expansion.candidates) {
    Candidate point = candidate;
    named.insert(point.point.identity);
    if (const auto found = by_identity.find(point.point.identity); found != by_identity.end()) {
      const Point& before = *found->second;
      point.point.key = before.key;
      point.point.ordinal = before.ordinal;
      point.point.cancelled = before.cancelled;
      point.point.retried_after = before.retried_after;
      result.kept.push_back({before, std::move(point)});
      continue;
    }
    point.point.key = key_of(point.point.identity, keys);
    point.point.ordinal = ++last_ordinal;
    keys.insert(point.point.key);
    result.added.push_back(std::move(point));
  }
  for (const Point& point : existing) {
    if (point.in_study && !named.contains(point.identity)) result.dropped.push_back(point);
  }
  return result;
}

}  // namespace rouleau::campaign
