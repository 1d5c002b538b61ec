// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/mesh_mobility.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace rouleau {
namespace {

/// Sum over the neighbours w of v of (F_v - F_w), in the order of the triangles around v.
double laplacian(const Array<double>& F, std::size_t v, std::span<const std::int32_t> neighbours) {
  double sum = 0;
  for (const std::int32_t w : neighbours) sum += F[v] - F[static_cast<std::size_t>(w)];
  return sum;
}

}  // namespace

MeshMobility::MeshMobility(const Cells& cells, double mobility, double viscosity_sum)
    : begin_(cells.around.begin), m_(cells.vertices()), needed_(cells.vertices()) {
  // On a closed surface every neighbour of v follows v in exactly one triangle.
  const std::array<const Array<std::int32_t>*, 3> corners{&cells.triangles.a, &cells.triangles.b, &cells.triangles.c};
  neighbour_.resize(cells.around.triangle.size());
  for (std::size_t e = 0; e < neighbour_.size(); ++e) {
    const auto next = static_cast<std::size_t>(cells.around.corner[e] + 1) % 3;
    neighbour_[e] = (*corners[next])[static_cast<std::size_t>(cells.around.triangle[e])];
  }
  for (const CellRange& cell : cells.ranges) {
    double edges = 0;
    std::int32_t count = 0;
    for (auto v = static_cast<std::size_t>(cell.vertex_begin); v < static_cast<std::size_t>(cell.vertex_end); ++v)
      for (std::int32_t e = begin_[v]; e < begin_[v + 1]; ++e, ++count) {
        const auto w = static_cast<std::size_t>(neighbour_[static_cast<std::size_t>(e)]);
        edges += (at(cells.X_reference, v) - at(cells.X_reference, w)).norm();
      }
    const double mean_edge = edges / count;
    std::fill(m_.begin() + cell.vertex_begin, m_.begin() + cell.vertex_end,
              mobility / (16 * std::numbers::pi * viscosity_sum * mean_edge));
  }
}

std::span<const std::uint8_t> MeshMobility::needs(const Stencils& stencils) {
  if (stencils.owned.size() == needed_.size()) return stencils.spreads_here;  // all of them
  std::copy(stencils.spreads_here.begin(), stencils.spreads_here.end(), needed_.begin());
  for (const std::int32_t v : stencils.owned)
    for (std::int32_t e = begin_[static_cast<std::size_t>(v)]; e < begin_[static_cast<std::size_t>(v) + 1]; ++e)
      needed_[static_cast<std::size_t>(neighbour_[static_cast<std::size_t>(e)])] = 1;
  return needed_;
}

void MeshMobility::add(Cells& cells, std::span<const std::int32_t> owned) const {
  for (const std::int32_t vertex : owned) {
    const auto v = static_cast<std::size_t>(vertex);
    const std::span neighbours(neighbour_.data() + begin_[v], neighbour_.data() + begin_[v + 1]);
    cells.U.x[v] += m_[v] * laplacian(cells.F.x, v, neighbours);
    cells.U.y[v] += m_[v] * laplacian(cells.F.y, v, neighbours);
    cells.U.z[v] += m_[v] * laplacian(cells.F.z, v, neighbours);
  }
}

}  // namespace rouleau
