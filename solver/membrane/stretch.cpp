// SPDX-License-Identifier: BSD-3-Clause
// Point forces that pull the two ends of a cell apart, as beads held by optical tweezers do.
#include "membrane/stretch.hpp"

#include <algorithm>
#include <cmath>

namespace rouleau {
namespace {

const Array<double>& component(const VectorArray& X, std::size_t axis) {
  const std::array<const Array<double>*, 3> components{&X.x, &X.y, &X.z};
  return *components[axis];
}

}  // namespace

std::array<std::vector<std::int32_t>, 2> end_vertices(const VectorArray& X, std::int32_t vertex_begin,
                                                      std::int32_t vertex_end, std::size_t axis, double share) {
  const Array<double>& x = component(X, axis);
  std::vector<double> sorted(x.begin() + vertex_begin, x.begin() + vertex_end);
  std::sort(sorted.begin(), sorted.end());
  const auto last = static_cast<std::ptrdiff_t>(sorted.size()) - 1;
  const std::ptrdiff_t count = std::max<std::ptrdiff_t>(1, std::lround(share * static_cast<double>(sorted.size())));
  // Far above the round-off of a placed mesh, far below the distance of its vertices.
  const double slack = 1e-9 * (sorted.back() - sorted.front());
  const double low = sorted[static_cast<std::size_t>(count - 1)] + slack;
  const double high = sorted[static_cast<std::size_t>(last - (count - 1))] - slack;
  std::array<std::vector<std::int32_t>, 2> ends;
  for (std::int32_t v = vertex_begin; v < vertex_end; ++v) {
    if (x[v] <= low) ends[0].push_back(v);
    if (x[v] >= high) ends[1].push_back(v);
  }
  return ends;
}

Stretch::Stretch(const Cells& start, std::size_t axis, double share) : axis_(axis) {
  for (const CellRange& range : start.ranges)
    ends_.push_back(end_vertices(start.X, range.vertex_begin, range.vertex_end, axis, share));
}

void Stretch::add(VectorArray& F, double force) const {
  const std::array<Array<double>*, 3> components{&F.x, &F.y, &F.z};
  Array<double>& along = *components[axis_];
  for (const auto& [low, high] : ends_) {
    const double pull_low = force / static_cast<double>(low.size());
    const double pull_high = force / static_cast<double>(high.size());
    for (const std::int32_t v : low) along[v] -= pull_low;
    for (const std::int32_t v : high) along[v] += pull_high;
  }
}

}  // namespace rouleau
