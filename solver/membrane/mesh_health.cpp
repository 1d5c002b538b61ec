// SPDX-License-Identifier: BSD-3-Clause
// Has a moving mesh lost its meaning? Folded or collapsed triangles, coordinates that are not finite.
#include "membrane/mesh_health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "membrane/v3.hpp"

namespace rouleau {
namespace {

V3 doubled_area_vector(const Triangles& triangles, const ConstV3s& X, std::size_t t) {
  const V3 a = X[triangles.a[t]];
  return cross(X[triangles.b[t]] - a, X[triangles.c[t]] - a);
}

double length(V3 a) { return std::sqrt(dot(a, a)); }

std::string place(const Cells& cells, std::size_t t) {
  const auto v = static_cast<std::size_t>(cells.triangles.a[t]);
  return fmt::format("near ({:.4g}, {:.4g}, {:.4g})", cells.X.x[v], cells.X.y[v], cells.X.z[v]);
}

}  // namespace

MeshHealth::MeshHealth(const Cells& cells)
    : edges_(find_edges(cells.triangles, "cells")),
      reference_area_(cells.triangles.size()),
      normal_(cells.triangles.size()) {
  const ConstV3s X(cells.X_reference);
  for (std::size_t t = 0; t < cells.triangles.size(); ++t) {
    reference_area_[t] = 0.5 * length(doubled_area_vector(cells.triangles, X, t));
  }
  // Edges ascend by vertex and cells follow each other, so each cell has one run of edges.
  for (const CellRange& range : cells.ranges) {
    const auto first = std::lower_bound(edges_.a.begin(), edges_.a.end(), range.vertex_begin);
    edge_begin_.push_back(static_cast<std::size_t>(first - edges_.a.begin()));
  }
  edge_begin_.push_back(edges_.size());
}

std::optional<MeshFault> MeshHealth::find_fault(const Cells& cells, const MeshLimits& limits) {
  for (std::size_t cell = 0; cell < cells.ranges.size(); ++cell) {
    if (auto fault = find_in_cell(cells, cell, limits)) return fault;
  }
  return std::nullopt;
}

std::optional<MeshFault> MeshHealth::find_in_cell(const Cells& cells, std::size_t cell, const MeshLimits& limits) {
  const CellRange& range = cells.ranges[cell];
  for (std::int32_t v = range.vertex_begin; v < range.vertex_end; ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (std::isfinite(cells.X.x[i]) && std::isfinite(cells.X.y[i]) && std::isfinite(cells.X.z[i])) continue;
    const auto t = static_cast<std::size_t>(cells.around.triangle[cells.around.begin[i]]);
    return MeshFault{cell, t - range.triangle_begin,
                     fmt::format("vertex {} is not finite: ({}, {}, {})", v - range.vertex_begin, cells.X.x[i],
                                 cells.X.y[i], cells.X.z[i])};
  }
  const ConstV3s X(cells.X);
  for (std::int32_t triangle = range.triangle_begin; triangle < range.triangle_end; ++triangle) {
    const auto t = static_cast<std::size_t>(triangle);
    const V3 N = doubled_area_vector(cells.triangles, X, t);
    const double norm = length(N);
    const double ratio = 0.5 * norm / reference_area_[t];
    if (!(ratio >= limits.collapse_area_ratio)) {
      return MeshFault{
          cell, t - range.triangle_begin,
          fmt::format("triangle {} collapsed to {:.3g} of its reference area, limit {} ({})",
                      triangle - range.triangle_begin, ratio, limits.collapse_area_ratio, place(cells, t))};
    }
    V3s(normal_).set(t, (1 / norm) * N);
  }
  const ConstV3s normal(normal_);
  for (std::size_t e = edge_begin_[cell]; e < edge_begin_[cell + 1]; ++e) {
    const double cosine = dot(normal[edges_.left[e]], normal[edges_.right[e]]);
    if (cosine < limits.fold_cosine) {
      const auto t = static_cast<std::size_t>(std::min(edges_.left[e], edges_.right[e]));
      const std::int32_t other = std::max(edges_.left[e], edges_.right[e]);
      return MeshFault{cell, t - range.triangle_begin,
                       fmt::format("triangles {} and {} are folded: cosine between their normals {:.3g}, limit {} ({})",
                                   t - range.triangle_begin, other - range.triangle_begin, cosine, limits.fold_cosine,
                                   place(cells, t))};
    }
  }
  return std::nullopt;
}

}  // namespace rouleau
