// SPDX-License-Identifier: BSD-3-Clause
#include "interior/tracker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "base/error.hpp"
#include "base/lanes.hpp"
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

/// x, y, z, 0 of a vertex in one register.
using Packed = Lanes<double, 4>;

/// (A) of the paper: the mean of the triangles' normals weighted by area, which is the plain sum of their cross
/// products. `opposite`: the edges that face the vertex, two vertices each.
V3 vertex_normal(const Array<double>& packed_X, std::size_t v, std::span<const std::int32_t> opposite) {
  const auto X = [&](std::size_t i) { return load_lanes<double, 4>(packed_X.data() + 4 * i); };
  const Packed own = X(v);
  constexpr auto y_z_x = [](const Packed& a) { return __builtin_shufflevector(a, a, 1, 2, 0, 3); };
  Packed sum{};  // of z, x, y: turned once at the end
  for (std::size_t e = 0; e < opposite.size(); e += 2) {
    const Packed a = X(static_cast<std::size_t>(opposite[e])) - own;
    const Packed b = X(static_cast<std::size_t>(opposite[e + 1])) - own;
    sum += a * y_z_x(b) - y_z_x(a) * b;
  }
  return {sum[1], sum[2], sum[0]};
}

std::size_t shell_size(Tracking variant) { return variant == Tracking::vertex_normals_wide ? 64 : 8; }

/// A few points and where the nodes around them start: found for all of them at once, in loops that vectorise.
struct Group {
  static constexpr std::size_t most = 32;
  using Doubles = std::array<double, most>;

  std::size_t begin, count;                            ///< points [begin, begin + count)
  std::array<Doubles, 3> position;                     ///< [axis]
  std::array<Doubles, 3> distance;                     ///< [axis] from the point to its lowest node, signed
  std::array<std::array<std::int32_t, most>, 3> node;  ///< [axis] local coordinate of that node's image on the lattice

  [[nodiscard]] Int3 first_node(std::size_t i) const { return {node[0][i], node[1][i], node[2][i]}; }
};

bool is_place(double x) { return std::abs(x) < far_away; }  // false for what is not a number

void require_places(const Group& group, std::string_view what) {
  std::size_t places = 0;
  for (const Group::Doubles& x : group.position)
    places += static_cast<std::size_t>(std::count_if(x.begin(), x.begin() + group.count, is_place));
  if (places == 3 * group.count) return;
  const auto& [x, y, z] = group.position;
  std::size_t i = 0;
  while (is_place(x[i]) && is_place(y[i]) && is_place(z[i])) ++i;
  fail(Exit::physics, "the membrane is lost at {} {}: ({:.6g}, {:.6g}, {:.6g}) node spacings. Try a smaller time step.",
       what, group.begin + i, x[i], y[i], z[i]);
}

template <int width>
void find_lowest_nodes(Group& group, const Lattice& lattice, const Block& block, std::size_t axis) {
  const double n = lattice.size[axis], begin = block.begin[axis];
  const double period = lattice.periodic[axis] ? n : 0.0;
  const double per_period = lattice.periodic[axis] ? 1.0 / n : 0.0;
#pragma GCC ivdep
  for (std::size_t i = 0; i < group.count; ++i) {
    const double x = group.position[axis][i];
    // Floor: a cast would round towards zero, and take the wrong nodes below it.
    const double lowest = std::floor(x) - (width / 2 - 1);
    group.distance[axis][i] = lowest - x;
    // Half a node off the integers, so that the product's rounding cannot reach the next period.
    const double image = lowest - period * std::floor((lowest + 0.5) * per_period);
    group.node[axis][i] = static_cast<std::int32_t>(image - begin);
  }
}

/// Which nodes this block owns. Coordinates are local; those of a shell begin on the lattice and may pass its end.
struct Ownership {
  const Lattice& lattice;
  const Block& block;

  /// The node itself, or its image on the lattice, if the block owns it; else -1.
  [[nodiscard]] int owned_or_none(std::size_t axis, int node) const {
    if (lattice.periodic[axis] && node + block.begin[axis] >= lattice.size[axis]) node -= lattice.size[axis];
    return node >= 0 && node < block.size[axis] ? node : -1;
  }
  /// Whether the block owns all nodes from `first` to `first` + width - 1, side by side.
  [[nodiscard]] bool has_all(const Int3& first, int width) const {
    bool is_whole = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      is_whole = is_whole && first[axis] >= 0 && first[axis] + width <= block.size[axis];
    return is_whole;
  }
  [[nodiscard]] bool has_any(const Int3& first, int width) const {
    const auto has_one = [&](std::size_t axis) {
      for (int a = 0; a < width; ++a)
        if (owned_or_none(axis, first[axis] + a) >= 0) return true;
      return false;
    };
    return has_one(0) && has_one(1) && has_one(2);
  }
};

/// The nodes around a point along one axis: what each adds to the squared distance from the point, and to the distance
/// along the normal.
template <int width>
struct ShellAxis {
  std::array<double, width> squared, along_normal;

  ShellAxis(double distance, double normal) {
    for (std::size_t a = 0; a < width; ++a) {
      const double d = distance + static_cast<double>(a);
      squared[a] = d * d;
      along_normal[a] = d * normal;
    }
  }
};

/// What a node remembers after it has heard a point: for numbers as for lanes. Without branches, since nobody can
/// predict them. Points come in ascending order: of two equally close the first stays.
template <class T>
T closer(const T& closest, const T& squared, const T& along_normal) {
  const T candidate = along_normal < 0.0 ? -squared : squared;
  const T so_far = closest < 0.0 ? -closest : closest;
  return squared < so_far ? candidate : closest;
}

/// The nodes that a point speaks to, and what it says.
template <int width>
struct Shell {
  ShellAxis<width> x, y, z;
};

/// Tells the nodes of a shell that no seam, wall or other block cuts; the lowest of them has index `first`. Appends the
/// nodes that hear of a point for the first time to `shell_nodes`, and returns how many.
template <int width>
std::size_t tell_whole(const Shell<width>& shell, const Layout& layout, std::ptrdiff_t first, double* closest,
                       std::int64_t* shell_nodes) {
  const std::ptrdiff_t stride_y = layout.stride_y, stride_z = layout.stride_z;
  const auto squared_x = load_lanes<double, width>(shell.x.squared),
             along_x = load_lanes<double, width>(shell.x.along_normal);
  std::size_t count = 0;
  for (int c = 0; c < width; ++c)
    for (int b = 0; b < width; ++b) {
      const std::ptrdiff_t row = first + b * stride_y + c * stride_z;
      const auto before = load_lanes<double, width>(closest + row);
      const auto after = closer(before, squared_x + (shell.y.squared[b] + shell.z.squared[c]),
                                along_x + (shell.y.along_normal[b] + shell.z.along_normal[c]));
      store_lanes<width>(after, closest + row);
      const auto is_new = before == infinitely_far;
      for (int a = 0; a < width; ++a) {
        shell_nodes[count] = row + a;
        count += is_new[a] != 0;
      }
    }
  return count;
}

/// The same for the owned nodes of any other shell.
template <int width>
std::size_t tell_owned(const Shell<width>& shell, const Layout& layout, const Ownership& ownership, const Int3& first,
                       double* closest, std::int64_t* shell_nodes) {
  std::size_t count = 0;
  for (int c = 0; c < width; ++c)
    for (int b = 0; b < width; ++b)
      for (int a = 0; a < width; ++a) {
        const Int3 node{ownership.owned_or_none(0, first[0] + a), ownership.owned_or_none(1, first[1] + b),
                        ownership.owned_or_none(2, first[2] + c)};
        if (node[0] < 0 || node[1] < 0 || node[2] < 0) continue;
        const std::ptrdiff_t index = layout.index(node[0], node[1], node[2]);
        if (closest[index] == infinitely_far) shell_nodes[count++] = index;
        closest[index] = closer(closest[index], shell.x.squared[a] + (shell.y.squared[b] + shell.z.squared[c]),
                                shell.x.along_normal[a] + (shell.y.along_normal[b] + shell.z.along_normal[c]));
      }
  return count;
}

}  // namespace

Tracker::Tracker(Tracking variant, const Lattice& lattice, const Block& block, const Cells& cells)
    : variant_(variant), lattice_(lattice), block_(block), layout_(block.size, 1) {
  closest_.assign(static_cast<std::size_t>(layout_.count), infinitely_far);
  const std::size_t points = variant == Tracking::face_normals ? cells.triangles.size() : cells.vertices();
  const std::size_t nodes = static_cast<std::size_t>(block.size[0]) * static_cast<std::size_t>(block.size[1]) *
                            static_cast<std::size_t>(block.size[2]);
  shell_.resize(std::min(nodes, points * shell_size(variant)) + 1);  // the last is written before it is known to count
  if (variant == Tracking::face_normals) return;
  packed_X_.assign(4 * cells.vertices(), 0.0);
  for (std::size_t e = 0; e < cells.around.triangle.size(); ++e) {
    const auto t = static_cast<std::size_t>(cells.around.triangle[e]);
    const std::array<std::int32_t, 3> corners{cells.triangles.a[t], cells.triangles.b[t], cells.triangles.c[t]};
    const auto own = static_cast<std::size_t>(cells.around.corner[e]);
    opposite_.push_back(corners[(own + 1) % 3]);
    opposite_.push_back(corners[(own + 2) % 3]);
  }
}

template <int radius, class PointOf, class NormalOf>
std::size_t Tracker::collect(std::size_t points, PointOf point_of, NormalOf normal_of) {
  constexpr int width = 2 * radius;
  std::int64_t* const shell_begin = shell_.data();
  std::int64_t* shell_end = shell_begin;
  double* const closest = closest_.data();
  const Ownership ownership{lattice_, block_};
  Group group;
  for (group.begin = 0; group.begin < points; group.begin += Group::most) {
    group.count = std::min(Group::most, points - group.begin);
    for (std::size_t i = 0; i < group.count; ++i) {
      const V3 point = point_of(group.begin + i);
      group.position[0][i] = point.x;
      group.position[1][i] = point.y;
      group.position[2][i] = point.z;
    }
    require_places(group, variant_ == Tracking::face_normals ? "triangle" : "vertex");
    for (std::size_t axis = 0; axis < 3; ++axis) find_lowest_nodes<width>(group, lattice_, block_, axis);
    for (std::size_t i = 0; i < group.count; ++i) {
      const Int3 first = group.first_node(i);
      if (!ownership.has_all(first, width)) continue;
      for (int c = 0; c < width; ++c)
        for (int b = 0; b < width; ++b)
          __builtin_prefetch(closest + layout_.index(first[0], first[1] + b, first[2] + c), 1);
    }
    for (std::size_t i = 0; i < group.count; ++i) {
      const Int3 first = group.first_node(i);
      const bool is_whole = ownership.has_all(first, width);
      if (!is_whole && !ownership.has_any(first, width)) continue;
      const V3 normal = normal_of(group.begin + i);
      const Shell<width> shell{
          {group.distance[0][i], normal.x}, {group.distance[1][i], normal.y}, {group.distance[2][i], normal.z}};
      shell_end += is_whole
                       ? tell_whole(shell, layout_, layout_.index(first[0], first[1], first[2]), closest, shell_end)
                       : tell_owned(shell, layout_, ownership, first, closest, shell_end);
    }
  }
  return static_cast<std::size_t>(shell_end - shell_begin);
}

std::int64_t Tracker::settle(std::size_t shell_nodes, Flags& flags) {
  std::int64_t flips = 0;
  for (std::size_t i = 0; i < shell_nodes; ++i) {
    double& closest = closest_[static_cast<std::size_t>(shell_[i])];
    std::uint8_t& flag = flags.data[static_cast<std::size_t>(shell_[i])];
    const std::uint8_t inside = closest < 0.0;
    flips += flag != inside;
    flag = inside;
    closest = infinitely_far;
  }
  return flips;
}

std::int64_t Tracker::update(const Cells& cells, Flags& flags) {
  require(flags.layout.size == layout_.size && flags.layout.halo == layout_.halo, "flags of another block");
  const ConstV3s X(cells.X);
  for (std::size_t i = 0; i < packed_X_.size(); i += 4) {
    const V3 position = X[i / 4];
    packed_X_[i] = position.x;
    packed_X_[i + 1] = position.y;
    packed_X_[i + 2] = position.z;
  }
  const auto vertex = [&](std::size_t v) { return X[v]; };
  const auto normal_at_vertex = [&](std::size_t v) {
    const auto begin = static_cast<std::size_t>(cells.around.begin[v]);
    const auto end = static_cast<std::size_t>(cells.around.begin[v + 1]);
    return vertex_normal(packed_X_, v, std::span(opposite_).subspan(2 * begin, 2 * (end - begin)));
  };
  switch (variant_) {
    case Tracking::vertex_normals:
      return settle(collect<1>(cells.vertices(), vertex, normal_at_vertex), flags);
    case Tracking::vertex_normals_wide:
      return settle(collect<2>(cells.vertices(), vertex, normal_at_vertex), flags);
    case Tracking::face_normals:
      break;
  }
  return settle(collect<1>(
                    cells.triangles.size(), [&](std::size_t t) { return triangle_centre(cells, t); },
                    [&](std::size_t t) { return triangle_normal(cells, t); }),
                flags);
}

}  // namespace rouleau
