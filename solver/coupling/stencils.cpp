// SPDX-License-Identifier: BSD-3-Clause
#include "coupling/stencils.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "coupling/positions.hpp"

namespace rouleau {
namespace {

/// One axis of all vertices: first nodes, and which vertices this block must know (ands its answer into the masks).
/// Returns false if a vertex is nowhere on the lattice.
template <class Phi>
bool find_axis(int axis, const Array<double>& X, Stencils& s) {
  const double n = s.lattice.size[axis];
  const double period = s.lattice.periodic[axis] ? n : 0.0;
  const double per_period = s.lattice.periodic[axis] ? 1.0 / n : 0.0;
  const double begin = s.block.begin[axis], end = s.block.begin[axis] + s.block.size[axis];
  const PositionRange range(s.lattice, axis);
  const auto vertices = static_cast<std::ptrdiff_t>(X.size());
  const double* const position = X.data();
  std::int32_t* const first = s.first[axis].data();
  std::uint8_t* const spreads_here = s.spreads_here.data();
  std::uint8_t* const owned_here = s.owned_here.data();
  int outside = 0;
#pragma omp simd reduction(+ : outside)
  for (std::ptrdiff_t v = 0; v < vertices; ++v) {
    const double x = position[v];
    const bool is_inside = range.contains(x);
    outside += !is_inside;
    const double safe = is_inside ? x : 0.0;  // a conversion of anything else to an integer would be undefined
    const double unfolded = Phi::first_node(safe);
    // Half a node off the integers, so that the product's rounding cannot reach the next period.
    const double shift = period * std::floor((unfolded + 0.5) * per_period);
    const double node = unfolded - shift;
    const double last = node + Phi::width;
    // The stencil may lie across the seam: its image one period below counts, too.
    const bool reaches = (node < end && last > begin) || (node - period < end && last - period > begin);
    double nearest = std::floor(safe + 0.5);
    nearest -= period * std::floor((nearest + 0.5) * per_period);
    nearest = std::min(nearest, n - 1.0);  // a vertex exactly on the high wall
    first[v] = static_cast<std::int32_t>(node);
    spreads_here[v] &= static_cast<std::uint8_t>(reaches);
    owned_here[v] &= static_cast<std::uint8_t>(nearest >= begin && nearest < end);
  }
  return outside == 0;
}

template <class Phi>
void set_weights(const Cells& cells, Stencils& s) {
  const std::array<const double*, 3> X{cells.X.x.data(), cells.X.y.data(), cells.X.z.data()};
  for (int axis = 0; axis < 3; ++axis)
    for (const std::int32_t v : s.spreading) {
      const double x = X[axis][v];
      const auto weights = Phi::weights(x - Phi::first_node(x));
      std::copy(weights.begin(), weights.end(), s.weight[axis].data() + std::ptrdiff_t{Phi::width} * v);
    }
}

/// Marks the rows of this block that each stencil touches.
void mark_rows(Stencils& s) {
  std::ranges::fill(s.rows, std::uint8_t{0});
  const auto local = [&](int axis, int node) {
    return s.lattice.wrap(axis, node) - s.block.begin[axis];  // beyond a wall: outside the block, too
  };
  for (const std::int32_t v : s.spreading)
    for (int c = 0; c < s.width; ++c) {
      const int k = local(2, s.first[2][v] + c);
      if (k < 0 || k >= s.block.size[2]) continue;
      for (int b = 0; b < s.width; ++b) {
        const int j = local(1, s.first[1][v] + b);
        if (j >= 0 && j < s.block.size[1]) s.rows[s.row(j, k)] = 1;
      }
    }
}

void list_vertices(const Array<std::uint8_t>& mask, std::vector<std::int32_t>& list) {
  list.clear();
  for (std::size_t v = 0; v < mask.size(); ++v)
    if (mask[v]) list.push_back(static_cast<std::int32_t>(v));
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
}

void find_stencils(const Cells& cells, Stencils& stencils) {
  require(cells.vertices() == stencils.spreads_here.size(), "stencils were made for another number of vertices");
  std::ranges::fill(stencils.spreads_here, std::uint8_t{1});
  std::ranges::fill(stencils.owned_here, std::uint8_t{1});
  with_kernel(stencils.kernel, [&](auto phi) {
    using Phi = decltype(phi);
    const bool x = find_axis<Phi>(0, cells.X.x, stencils);
    const bool y = find_axis<Phi>(1, cells.X.y, stencils);
    const bool z = find_axis<Phi>(2, cells.X.z, stencils);
    if (!(x && y && z)) check_positions(cells, stencils.lattice);
    list_vertices(stencils.spreads_here, stencils.spreading);
    list_vertices(stencils.owned_here, stencils.owned);
    set_weights<Phi>(cells, stencils);
  });
  mark_rows(stencils);
}

}  // namespace rouleau
