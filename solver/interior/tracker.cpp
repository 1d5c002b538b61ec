// SPDX-License-Identifier: BSD-3-Clause
#include "interior/tracker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "membrane/v3.hpp"

namespace rouleau {
namespace {

/// Nothing that a lattice could hold; still an int.
constexpr double far_away = 1 << 30;
constexpr double infinitely_far = std::numeric_limits<double>::infinity();

/// Twice the triangle's area times its outward normal.
V3 triangle_normal(const Cells& cells, std::size_t t) {
  const ConstV3s X(cells.X);
  const V3 a = X[cells.triangles.a[t]];
  return cross(X[cells.triangles.b[t]] - a, X[cells.triangles.c[t]] - a);
}

V3 triangle_centre(const Cells& cells, std::size_t t) {
  const ConstV3s X(cells.X);
  return (1.0 / 3.0) * ((X[cells.triangles.a[t]] + X[cells.triangles.b[t]]) + X[cells.triangles.c[t]]);
}

/// (A) of the paper: the mean of the triangles' normals weighted by area, which is the plain sum of their cross
/// products.
V3 vertex_normal(const Cells& cells, std::size_t v) {
  V3 sum;
  for (std::int32_t e = cells.around.begin[v]; e < cells.around.begin[v + 1]; ++e)
    sum = sum + triangle_normal(cells, static_cast<std::size_t>(cells.around.triangle[static_cast<std::size_t>(e)]));
  return sum;
}

std::size_t shell_size(Tracking variant) { return variant == Tracking::vertex_normals_wide ? 64 : 8; }

/// The nodes around a point along one axis.
template <int width>
struct ShellAxis {
  std::array<int, width> node;         ///< local; < 0 where the block does not own it, or beyond a wall
  std::array<double, width> distance;  ///< from the point to the node, signed
  bool touches = false;                ///< a node is owned
};

template <int width>
ShellAxis<width> shell_axis(double x, const Lattice& lattice, const Block& block, int axis) {
  ShellAxis<width> shell;
  // Floor: a cast would round towards zero, and take the wrong nodes below it.
  const double lowest = std::floor(x) - (width / 2 - 1);
  for (int a = 0; a < width; ++a) {
    const double node = lowest + a;
    const int local = lattice.wrap(axis, static_cast<int>(node)) - block.begin[axis];
    const bool is_owned = local >= 0 && local < block.size[axis];
    shell.node[static_cast<std::size_t>(a)] = is_owned ? local : -1;
    shell.distance[static_cast<std::size_t>(a)] = node - x;
    shell.touches |= is_owned;
  }
  return shell;
}

}  // namespace

Tracker::Tracker(Tracking variant, const Lattice& lattice, const Block& block, const Cells& cells)
    : variant_(variant), lattice_(lattice), block_(block), layout_(block.size, 1) {
  closest_.assign(static_cast<std::size_t>(layout_.count), infinitely_far);
  const std::size_t points = variant == Tracking::face_normals ? cells.triangles.size() : cells.vertices();
  const std::size_t nodes = static_cast<std::size_t>(block.size[0]) * static_cast<std::size_t>(block.size[1]) *
                            static_cast<std::size_t>(block.size[2]);
  shell_.reserve(std::min(nodes, points * shell_size(variant)));
}

template <int radius, class PointOf, class NormalOf>
void Tracker::collect(std::size_t points, PointOf point_of, NormalOf normal_of) {
  constexpr int width = 2 * radius;
  for (std::size_t p = 0; p < points; ++p) {
    const V3 point = point_of(p);
    if (!(std::abs(point.x) < far_away && std::abs(point.y) < far_away && std::abs(point.z) < far_away))
      fail(Exit::physics,
           "the membrane is lost at {} {}: ({:.6g}, {:.6g}, {:.6g}) node spacings. Try a smaller time step.",
           variant_ == Tracking::face_normals ? "triangle" : "vertex", p, point.x, point.y, point.z);
    const auto z = shell_axis<width>(point.z, lattice_, block_, 2);
    if (!z.touches) continue;
    const auto y = shell_axis<width>(point.y, lattice_, block_, 1);
    if (!y.touches) continue;
    const auto x = shell_axis<width>(point.x, lattice_, block_, 0);
    if (!x.touches) continue;
    const V3 normal = normal_of(p);
    for (std::size_t c = 0; c < width; ++c)
      for (std::size_t b = 0; b < width; ++b) {
        if (z.node[c] < 0 || y.node[b] < 0) continue;
        const std::ptrdiff_t row = layout_.index(0, y.node[b], z.node[c]);
        for (std::size_t a = 0; a < width; ++a) {
          if (x.node[a] < 0) continue;
          const V3 to_node{x.distance[a], y.distance[b], z.distance[c]};
          const double squared = dot(to_node, to_node);
          double& closest = closest_[static_cast<std::size_t>(row + x.node[a])];
          // Points come in ascending order: of two equally close the first stays.
          if (squared >= std::abs(closest)) continue;
          if (closest == infinitely_far) shell_.push_back(row + x.node[a]);
          closest = dot(to_node, normal) < 0.0 ? -squared : squared;
        }
      }
  }
}

std::int64_t Tracker::settle(Flags& flags) {
  std::int64_t flips = 0;
  for (const std::int64_t node : shell_) {
    double& closest = closest_[static_cast<std::size_t>(node)];
    std::uint8_t& flag = flags.data[static_cast<std::size_t>(node)];
    const std::uint8_t inside = closest < 0.0;
    flips += flag != inside;
    flag = inside;
    closest = infinitely_far;
  }
  shell_.clear();
  return flips;
}

std::int64_t Tracker::update(const Cells& cells, Flags& flags) {
  require(flags.layout.size == layout_.size && flags.layout.halo == layout_.halo, "flags of another block");
  const ConstV3s X(cells.X);
  const auto vertex = [&](std::size_t v) { return X[v]; };
  const auto normal_at_vertex = [&](std::size_t v) { return vertex_normal(cells, v); };
  switch (variant_) {
    case Tracking::vertex_normals:
      collect<1>(cells.vertices(), vertex, normal_at_vertex);
      break;
    case Tracking::vertex_normals_wide:
      collect<2>(cells.vertices(), vertex, normal_at_vertex);
      break;
    case Tracking::face_normals:
      collect<1>(
          cells.triangles.size(), [&](std::size_t t) { return triangle_centre(cells, t); },
          [&](std::size_t t) { return triangle_normal(cells, t); });
      break;
  }
  return settle(flags);
}

}  // namespace rouleau
