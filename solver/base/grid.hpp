// SPDX-License-Identifier: BSD-3-Clause
// The lattice as a whole, the block of it that one rank owns, and where a node's value stands in memory.
//
// Coordinates: node (i, j, k) lies at position (i, j, k) in lattice units. A half-way wall lies at -0.5 and at N - 0.5;
// a periodic axis has the period N. The channel axis is therefore at (N - 1) / 2.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/vec3.hpp"

namespace rouleau {

/// The global lattice.
struct Lattice {
  Int3 size{};                                     ///< nodes along x, y, z
  std::array<bool, 3> periodic{true, true, true};  ///< the other axes end in half-way walls

  [[nodiscard]] std::ptrdiff_t nodes() const { return std::ptrdiff_t{1} * size[0] * size[1] * size[2]; }
  /// Global coordinate folded into [0, size) along a periodic axis; unchanged along a walled one.
  [[nodiscard]] int wrap(int axis, int i) const {
    if (!periodic[axis]) return i;
    const int n = size[axis];
    const int r = i % n;
    return r < 0 ? r + n : r;
  }
  [[nodiscard]] bool contains(int axis, int i) const { return i >= 0 && i < size[axis]; }
};

/// The nodes that one rank owns: [begin, begin + size) in global coordinates.
struct Block {
  Int3 begin{};
  Int3 size{};
};

/// Local nodes [begin, end) along x.
struct Run {
  int begin, end;
};

/// The rows (., j, k) of a field, which may stand in memory turned by some rows: the first ones then stand last.
template <class T>
struct Rows {
  T* first = nullptr;         ///< node x = 0 of the row that stands first
  std::ptrdiff_t stride = 0;  ///< elements from row to row
  int halo = 0, size_y = 0;   ///< size_y: rows of a layer, halo included
  std::ptrdiff_t count = 0;   ///< rows of the field, halo included
  std::ptrdiff_t turn = 0;    ///< place of the first row, in [0, count)

  /// Node (0, j, k); j and k from -halo to size + halo - 1.
  T* operator()(int j, int k) const {
    std::ptrdiff_t row = (j + halo) + std::ptrdiff_t{k + halo} * size_y + turn;
    if (row >= count) row -= count;
    return first + row * stride;
  }
};

/// Where the value of local node (i, j, k) stands; local coordinates run from -halo to size + halo - 1, x fastest.
/// Node i = 0 of every row starts on a cache line for elements of 4 and 8 bytes; the low halo of a row stands behind
/// the row before it.
struct Layout {
  Int3 size{};
  int halo = 0;
  std::ptrdiff_t stride_y = 0, stride_z = 0, origin = 0, count = 0;

  Layout() = default;
  Layout(const Int3& owned, int halo_width) : size(owned), halo(halo_width) {
    constexpr std::ptrdiff_t pad = 16;  // elements: a cache line of floats, two of doubles
    stride_y = (size[0] + 2 * halo + pad - 1) / pad * pad;
    stride_z = stride_y * (size[1] + 2 * halo);
    origin = pad + stride_y * halo + stride_z * halo;
    count = stride_z * (size[2] + 2 * halo) + 2 * pad;
  }
  [[nodiscard]] std::ptrdiff_t index(int i, int j, int k) const { return origin + i + j * stride_y + k * stride_z; }
  /// The rows of data[index].
  template <class T>
  [[nodiscard]] Rows<T> rows(T* data) const {
    const int size_y = size[1] + 2 * halo;
    return {data + index(0, -halo, -halo), stride_y, halo, size_y, std::ptrdiff_t{size_y} * (size[2] + 2 * halo), 0};
  }
};

/// One value a node. (Components of a vector are separate fields.)
template <class T>
struct Field {
  Layout layout;
  Array<T> data;

  Field() = default;
  Field(const Int3& owned, int halo) : layout(owned, halo), data(static_cast<std::size_t>(layout.count)) {}
  T& operator()(int i, int j, int k) { return data[static_cast<std::size_t>(layout.index(i, j, k))]; }
  const T& operator()(int i, int j, int k) const { return data[static_cast<std::size_t>(layout.index(i, j, k))]; }
};

template <class T>
using VectorField = std::array<Field<T>, 3>;

}  // namespace rouleau
