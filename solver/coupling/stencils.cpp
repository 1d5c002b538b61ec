// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/stencils.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/simd.hpp"
#include "coupling/positions.hpp"

namespace rouleau {
namespace {

/// A few vertices on their way through the three axes. Answers are doubles and not bytes or bools: mixed types would
/// keep the loop from being vectorised, or have it vectorised over so many vertices that it runs out of registers.
struct Group {
  static constexpr std::ptrdiff_t most = 64;
  std::ptrdiff_t begin, count;
  std::array<double, most> overlap;  ///< > 0: the stencil has nodes in the block, by the axes so far
  std::array<double, most> depth;    ///< > 0: the nearest node is in the block, by the axes so far
};

/// One axis of a group: first nodes, weights, and which vertices this block must know.
template <class Phi>
void find_axis(int axis, const Array<double>& X, Stencils& s, Group& group) {
  const double n = s.lattice.size[axis];
  const double period = s.lattice.periodic[axis] ? n : 0.0;
  const double per_period = s.lattice.periodic[axis] ? 1.0 / n : 0.0;
  const double begin = s.block.begin[axis], end = s.block.begin[axis] + s.block.size[axis];
  const PositionRange range(s.lattice, axis);
  const double* const position = X.data() + group.begin;
  std::int32_t* const first = s.first[axis].data() + group.begin;
  double* const weight = s.weight[axis].data() + group.begin * Phi::width;
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < group.count; ++i) {
    const double safe = range.nearest(position[i]);  // a conversion of NaN to an integer would be undefined
    const double unfolded = Phi::first_node(safe);
    // Half a node off the integers, so that the product's rounding cannot reach the next period.
    const double node = unfolded - period * std::floor((unfolded + 0.5) * per_period);
    // The stencil may lie across the seam: its image one period below counts, too.
    const double here = std::min(end, node + Phi::width) - std::max(begin, node);
    const double below = std::min(end, node - period + Phi::width) - std::max(begin, node - period);
    double nearest = std::floor(safe + 0.5);
    nearest -= period * std::floor((nearest + 0.5) * per_period);
    nearest = std::min(nearest, n - 1.0);  // a vertex exactly on the high wall
    first[i] = static_cast<std::int32_t>(node);
    group.overlap[i] = std::min(group.overlap[i], std::max(here, below));
    group.depth[i] = std::min(group.depth[i], std::min(nearest + 1.0 - begin, end - nearest));
    const auto weights = Phi::weights(safe - unfolded);
    unrolled<Phi::width>([&](auto a) ROW_INLINE { weight[i * Phi::width + a] = weights[a]; });
  }
}

/// Whether all positions are somewhere on the lattice.
bool are_inside(const Array<double>& X, const PositionRange& range) {
  return std::ranges::count_if(X, [&](double x) { return !range.contains(x); }) == 0;
}

/// All axes of all vertices.
template <class Phi>
void find_all(const Cells& cells, Stencils& s) {
  const auto vertices = static_cast<std::ptrdiff_t>(cells.vertices());
  Group group;
  for (group.begin = 0; group.begin < vertices; group.begin += Group::most) {
    group.count = std::min(Group::most, vertices - group.begin);
    group.overlap.fill(1.0);
    group.depth.fill(1.0);
    find_axis<Phi>(0, cells.X.x, s, group);
    find_axis<Phi>(1, cells.X.y, s, group);
    find_axis<Phi>(2, cells.X.z, s, group);
    std::transform(group.overlap.begin(), group.overlap.begin() + group.count, s.spreads_here.begin() + group.begin,
                   [](double overlap) { return static_cast<std::uint8_t>(overlap > 0.0); });
    std::transform(group.depth.begin(), group.depth.begin() + group.count, s.owned_here.begin() + group.begin,
                   [](double depth) { return static_cast<std::uint8_t>(depth > 0.0); });
  }
}

/// The bits of the segments with the local nodes [i, i + width) of a row, all of them owned.
std::uint8_t segments(const Stencils& s, int i) {
  return static_cast<std::uint8_t>(1U << (i >> s.segment_shift) | 1U << ((i + s.width - 1) >> s.segment_shift));
}

/// Marks the owned nodes of a stencil that something cuts, where they are.
void mark_cut(Stencils& s, std::size_t v) {
  constexpr int widest = 4;
  std::array<std::array<int, widest>, 3> local;  // [axis] < 0: beyond a wall, or of another block
  for (int axis = 0; axis < 3; ++axis)
    for (int a = 0; a < s.width; ++a) local[axis][a] = s.owned_or_none(axis, s.first[axis][v] + a);
  unsigned bits = 0;
  for (int a = 0; a < s.width; ++a)
    if (local[0][a] >= 0) bits |= 1U << (local[0][a] >> s.segment_shift);
  for (int c = 0; c < s.width; ++c)
    for (int b = 0; b < s.width; ++b)
      if (local[1][b] >= 0 && local[2][c] >= 0)
        s.rows[s.row(local[1][b], local[2][c])] |= static_cast<std::uint8_t>(bits);
}

/// Marks what the stencils touch of each row of this block.
void mark_rows(Stencils& s) {
  std::ranges::fill(s.rows, std::uint8_t{0});
  std::ranges::fill(s.starts, std::uint8_t{0});
  for (const std::int32_t v : s.spreading) {
    const Int3 local = s.local_first(static_cast<std::size_t>(v));
    if (s.is_whole(local))
      s.starts[s.row(local[1], local[2])] |= segments(s, local[0]);
    else
      mark_cut(s, static_cast<std::size_t>(v));
  }
  // A whole stencil does not leave its block: its rows stand at the same distances behind the one it starts in.
  const std::uint8_t* const starts = s.starts.data();
  std::uint8_t* const rows = s.rows.data();
  const std::size_t count = s.rows.size();
  for (int c = 0; c < s.width; ++c)
    for (int b = 0; b < s.width; ++b) {
      const std::size_t distance = s.row(b, c);
#pragma GCC ivdep
      for (std::size_t r = distance; r < count; ++r) rows[r] |= starts[r - distance];
    }
}

void list_vertices(const Array<std::uint8_t>& mask, std::vector<std::int32_t>& list) {
  list.resize(mask.size());
  std::size_t count = 0;
  for (std::size_t v = 0; v < mask.size(); ++v) {
    list[count] = static_cast<std::int32_t>(v);
    count += mask[v];
  }
  list.resize(count);
}

}  // namespace

Stencils::Stencils(Kernel which, const Lattice& whole, const Block& own, std::size_t vertices)
    : kernel(which),
      width(kernel_width(which)),
      lattice(whole),
      block(own),
      spreads_here(vertices),
      owned_here(vertices) {
  constexpr int velocity_halo = 2;
  for (int axis = 0; axis < 3; ++axis) {
    if (lattice.size[axis] < width)
      fail(Exit::bad_input,
           "the lattice has {} nodes along {}, the {} kernel needs at least {}. Make the box larger or choose a "
           "narrower kernel.",
           lattice.size[axis], "xyz"[axis], kernel_name(kernel), width);
    if (block.size[axis] < std::min(velocity_halo, lattice.size[axis]))
      fail(Exit::bad_input,
           "a rank has {} node along {}, the {} kernel needs at least {} nodes a rank. Use fewer ranks along {}.",
           block.size[axis], "xyz"[axis], kernel_name(kernel), velocity_halo, "xyz"[axis]);
    first[axis].resize(vertices);
    weight[axis].resize(vertices * static_cast<std::size_t>(width));
  }
  spreading.reserve(vertices);
  owned.reserve(vertices);
  rows.resize(static_cast<std::size_t>(block.size[1]) * static_cast<std::size_t>(block.size[2]));
  written_rows.resize(rows.size());
  starts.resize(rows.size());
  while (block.size[0] > 8 << segment_shift) ++segment_shift;
}

void find_stencils(const Cells& cells, Stencils& stencils) {
  require(cells.vertices() == stencils.spreads_here.size(), "stencils were made for another number of vertices");
  if (!(are_inside(cells.X.x, {stencils.lattice, 0}) && are_inside(cells.X.y, {stencils.lattice, 1}) &&
        are_inside(cells.X.z, {stencils.lattice, 2})))
    check_positions(cells, stencils.lattice);
  with_kernel(stencils.kernel, [&](auto phi) { find_all<decltype(phi)>(cells, stencils); });
  list_vertices(stencils.spreads_here, stencils.spreading);
  list_vertices(stencils.owned_here, stencils.owned);
  mark_rows(stencils);
}

}  // namespace rouleau
