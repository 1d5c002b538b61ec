// SPDX-License-Identifier: BSD-3-Clause
// What a surface must fulfil to enclose a cell.
#include "membrane/check_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "base/error.hpp"
#include "membrane/edges.hpp"
#include "membrane/v3.hpp"
#include "membrane/volume.hpp"

namespace rouleau {
namespace {

/// A triangle is degenerate if its doubled area is below this part of its longest edge squared: cotangents lose half
/// their digits.
constexpr double degenerate_ratio = 1e-8;

std::array<std::int32_t, 3> corners(const Triangles& triangles, std::size_t t) {
  return {triangles.a[t], triangles.b[t], triangles.c[t]};
}

void check_indices(const Surface& surface, const std::string& name) {
  const auto vertices = static_cast<std::int32_t>(surface.X.size());
  if (surface.triangles.size() < 4) {
    fail(Exit::bad_input, "{}: {} triangles; a closed surface has at least 4.", name, surface.triangles.size());
  }
  std::vector<bool> is_used(surface.X.size(), false);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [a, b, c] = corners(surface.triangles, t);
    for (const std::int32_t v : {a, b, c}) {
      if (v < 0 || v >= vertices) {
        fail(Exit::bad_input, "{}: triangle {} names vertex {}; there are {}.", name, t, v, vertices);
      }
      is_used[v] = true;
    }
    if (a == b || b == c || c == a) {
      fail(Exit::bad_input, "{}: triangle {} ({}, {}, {}) names a vertex twice. Remove it and merge its sides.", name,
           t, a, b, c);
    }
  }
  const auto unused = std::find(is_used.begin(), is_used.end(), false);
  if (unused != is_used.end()) {
    fail(Exit::bad_input, "{}: vertex {} belongs to no triangle. Remove it.", name, unused - is_used.begin());
  }
}

void check_positions(const Surface& surface, const std::string& name) {
  const VectorArray& X = surface.X;
  for (std::size_t v = 0; v < X.size(); ++v) {
    if (!at(X, v).allFinite()) {
      fail(Exit::bad_input, "{}: vertex {} is not finite: ({}, {}, {}).", name, v, X.x[v], X.y[v], X.z[v]);
    }
  }
  std::vector<std::size_t> order(X.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t v) { return std::make_tuple(X.x[v], X.y[v], X.z[v], v); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (at(X, order[i - 1]) == at(X, order[i])) {
      fail(Exit::bad_input, "{}: vertices {} and {} are both at ({}, {}, {}). Merge them.", name, order[i - 1],
           order[i], X.x[order[i]], X.y[order[i]], X.z[order[i]]);
    }
  }
}

void check_triangles(const Surface& surface, const std::string& name) {
  const ConstV3s X(surface.X);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [a, b, c] = corners(surface.triangles, t);
    const V3 u = X[b] - X[a], v = X[c] - X[a], w = v - u, N = cross(u, v);
    const double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
    if (!(std::sqrt(dot(N, N)) > degenerate_ratio * longest)) {
      fail(Exit::bad_input, "{}: triangle {} ({}, {}, {}) is degenerate: area {}, longest edge {}. Remesh there.", name,
           t, a, b, c, 0.5 * std::sqrt(dot(N, N)), std::sqrt(longest));
    }
  }
}

/// Disjoint sets of small integers; a set's name is its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::int32_t find(std::int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::int32_t i, std::int32_t j) {
    const std::int32_t one = find(i), other = find(j);
    parent_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::int32_t> parent_;
};

void check_connected(const Surface& surface, const Edges& edges, const std::string& name) {
  DisjointSets parts(surface.triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) parts.unite(edges.left[e], edges.right[e]);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (parts.find(static_cast<std::int32_t>(t)) != 0) {
      fail(Exit::bad_input, "{}: triangle {} is not connected to triangle 0; one file holds one cell. Split the file.",
           name, t);
    }
  }
}

/// All triangles of a vertex must be reachable from each other across edges at that vertex: no two cones that touch in
/// it.
void check_fans(const Surface& surface, const Edges& edges, const std::string& name) {
  const auto corner_at = [&](std::int32_t t, std::int32_t v) {
    const auto corner = corners(surface.triangles, static_cast<std::size_t>(t));
    return 3 * t + static_cast<std::int32_t>(std::find(corner.begin(), corner.end(), v) - corner.begin());
  };
  DisjointSets fans(3 * surface.triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const std::int32_t v : {edges.a[e], edges.b[e]}) {
      fans.unite(corner_at(edges.left[e], v), corner_at(edges.right[e], v));
    }
  }
  std::vector<std::int32_t> fan_of(surface.X.size(), -1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const std::int32_t v : corners(surface.triangles, t)) {
      const std::int32_t fan = fans.find(corner_at(static_cast<std::int32_t>(t), v));
      if (fan_of[v] < 0) fan_of[v] = fan;
      if (fan_of[v] != fan) {
        fail(Exit::bad_input,
             "{}: triangles {} and {} touch in vertex {} without a fan between them. Separate the parts.", name,
             fan_of[v] / 3, t, v);
      }
    }
  }
}

}  // namespace

void check_surface(const Surface& surface, const std::string& name) {
  check_indices(surface, name);
  check_positions(surface, name);
  check_triangles(surface, name);
  const Edges edges = find_edges(surface.triangles, name);
  check_connected(surface, edges, name);
  check_fans(surface, edges, name);
  const double enclosed = volume(surface);
  if (!(enclosed > 0)) {
    fail(Exit::bad_input,
         "{}: the enclosed volume is {}: triangle 0 and all others have their normals inwards. Reverse the order of "
         "each "
         "triangle's vertices.",
         name, enclosed);
  }
}

}  // namespace rouleau
