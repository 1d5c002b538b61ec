// SPDX-License-Identifier: BSD-3-Clause
#include "interior/ray_cast.hpp"

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "interior/image_nodes.hpp"
#include "interior/ray_search.hpp"

namespace rouleau {
namespace {

/// Periods to add to a node's coordinates so that its images cover the box: [first, last]; 0 along walled axes.
struct Shifts {
  Int3 first{}, last{};
};

Shifts shifts_over(const ImageBox& box, const Lattice& lattice) {
  Shifts shifts;
  for (int axis = 0; axis < 3; ++axis) {
    if (!lattice.periodic[axis]) continue;
    const double n = lattice.size[axis];
    shifts.first[axis] = static_cast<int>(std::ceil((box.low[axis] - (n - 1)) / n));
    shifts.last[axis] = static_cast<int>(std::floor(box.high[axis] / n));
  }
  return shifts;
}

bool contains_an_image(const CellForRays& cell, const Shifts& shifts, const Lattice& lattice, const Int3& node) {
  for (int c = shifts.first[2]; c <= shifts.last[2]; ++c)
    for (int b = shifts.first[1]; b <= shifts.last[1]; ++b)
      for (int a = shifts.first[0]; a <= shifts.last[0]; ++a)
        if (cell.contains(
                Vec3(node[0] + a * lattice.size[0], node[1] + b * lattice.size[1], node[2] + c * lattice.size[2])))
          return true;
  return false;
}

Int3 global_node(const Block& block, const Int3& local) {
  return {block.begin[0] + local[0], block.begin[1] + local[1], block.begin[2] + local[2]};
}

/// A position far out would mean a search over as many nodes; find what is wrong before that.
void require_sane(const Cells& cells, const Lattice& lattice) {
  constexpr double periods = 1000;
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    const Vec3 X = at(cells.X, v);
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(X[axis]) < periods * lattice.size[axis]))
        fail(Exit::physics,
             "vertex {} is at ({:.6g}, {:.6g}, {:.6g}) node spacings, the lattice has {} x {} x {} nodes: cannot tell "
             "inside from outside. Check the mesh and its position.",
             v, X[0], X[1], X[2], lattice.size[0], lattice.size[1], lattice.size[2]);
  }
}

/// The owned nodes among the eight around each vertex, each once, local.
std::vector<Int3> nodes_near_membrane(const Cells& cells, const Lattice& lattice, const Block& block) {
  Field<std::uint8_t> seen(block.size, 0);
  std::vector<Int3> nodes;
  for (std::size_t v = 0; v < cells.vertices(); ++v) {
    const Vec3 low = at(cells.X, v).array().floor();
    for_each_image({low, low + Vec3::Ones()}, lattice, block, [&](int i, int j, int k, const Vec3&) {
      if (seen(i, j, k)) return;
      seen(i, j, k) = 1;
      nodes.push_back({i, j, k});
    });
  }
  return nodes;
}

}  // namespace

void cast_rays(const Cells& cells, const Lattice& lattice, const Block& block, RaySearch search, Flags& flags) {
  require_sane(cells, lattice);
  clear_owned(flags);
  for (const CellRange& range : cells.ranges) {
    const CellForRays cell(cells, range, search);
    if (search == RaySearch::columns) {
      for_each_image(cell.box(), lattice, block, [&](int i, int j, int k, const Vec3& position) {
        if (cell.contains(position)) flags(i, j, k) = 1;
      });
      continue;
    }
    const Shifts shifts = shifts_over(cell.box(), lattice);
    for (int k = 0; k < block.size[2]; ++k)
      for (int j = 0; j < block.size[1]; ++j)
        for (int i = 0; i < block.size[0]; ++i)
          if (contains_an_image(cell, shifts, lattice, global_node(block, {i, j, k}))) flags(i, j, k) = 1;
  }
}

void cast_rays_near_membrane(const Cells& cells, const Lattice& lattice, const Block& block, RaySearch search,
                             Flags& flags) {
  require_sane(cells, lattice);
  const std::vector<Int3> nodes = nodes_near_membrane(cells, lattice, block);
  for (const auto& [i, j, k] : nodes) flags(i, j, k) = 0;
  for (const CellRange& range : cells.ranges) {
    const CellForRays cell(cells, range, search);
    const Shifts shifts = shifts_over(cell.box(), lattice);
    for (const auto& [i, j, k] : nodes)
      if (contains_an_image(cell, shifts, lattice, global_node(block, {i, j, k}))) flags(i, j, k) = 1;
  }
}

}  // namespace rouleau
