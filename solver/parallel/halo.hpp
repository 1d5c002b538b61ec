// SPDX-License-Identifier: BSD-3-Clause
// Fills the halo of node fields from the neighbouring blocks: x, then y, then z, so that edges and corners come along.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "parallel/decomposition.hpp"

namespace rouleau {

/// Exchanges fields of one layout. Along a periodic axis that is not cut the block is its own neighbour; beyond walls
/// the halo is left as it is.
template <class T>
class HaloExchange {
 public:
  /// Components to send along each axis towards the low (0) and the high (1) side.
  using Components = std::array<std::array<std::vector<Rows<T>>, 2>, 3>;

  /// `width` <= layout.halo layers are filled. Buffers are allocated here, for at most `components` fields a face.
  HaloExchange(const Communicator& comm, const Decomposition& decomposition, const Layout& layout, int width,
               std::size_t components)
      : comm_(comm.raw()), own_rank_(comm.rank()), layout_(layout), width_(width) {
    std::size_t largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) neighbour_[axis][side] = decomposition.neighbour(axis, side);
      largest = std::max(largest, slab(axis, 0, width).nodes());
    }
    for (auto& buffer : buffers_) buffer.resize(largest * components);
  }

  /// Every field in every direction.
  void exchange(std::span<const Rows<T>> fields) {
    const std::array<Run, 1> all{{{-width_, layout_.size[0] + width_}}};
    exchange(fields, 0, all);
  }

  /// Every field, within some runs of each row only, which do not overlap and are the same on all ranks that share
  /// their x; axes before `first_axis` are left alone.
  void exchange(std::span<const Rows<T>> fields, int first_axis, std::span<const Run> runs) {
    for (int axis = first_axis; axis < 3; ++axis) exchange_axis(axis, fields, fields, runs);
  }

  /// Only the listed components cross each face; axes before `first_axis` are left alone.
  void exchange(const Components& components, int first_axis) {
    const std::array<Run, 1> all{{{-width_, layout_.size[0] + width_}}};
    for (int axis = first_axis; axis < 3; ++axis) exchange_axis(axis, components[axis][0], components[axis][1], all);
  }

 private:
  struct Slab {
    Int3 begin, end;
    [[nodiscard]] std::size_t nodes() const {
      return static_cast<std::size_t>(end[0] - begin[0]) * static_cast<std::size_t>(end[1] - begin[1]) *
             static_cast<std::size_t>(end[2] - begin[2]);
    }
  };

  /// Layers [first, last) along `axis`; along the axes already exchanged the halo is included.
  [[nodiscard]] Slab slab(int axis, int first, int last) const {
    Slab s;
    for (int a = 0; a < 3; ++a) {
      const int w = a < axis ? width_ : 0;
      s.begin[a] = -w;
      s.end[a] = layout_.size[a] + w;
    }
    s.begin[axis] = first;
    s.end[axis] = last;
    return s;
  }

  /// Calls visit(j, k, begin, end) for what the runs leave of each row of a slab.
  template <class Visit>
  static void each_piece(const Slab& s, std::span<const Run> runs, Visit visit) {
    for (int k = s.begin[2]; k < s.end[2]; ++k)
      for (int j = s.begin[1]; j < s.end[1]; ++j)
        for (const Run& run : runs) {
          const int begin = std::max(s.begin[0], run.begin), end = std::min(s.end[0], run.end);
          if (begin < end) visit(j, k, begin, end);
        }
  }

  /// Returns the number of elements.
  std::size_t pack(std::span<const Rows<T>> fields, const Slab& s, std::span<const Run> runs, T* buffer) const {
    T* out = buffer;
    for (const Rows<T>& field : fields)
      each_piece(s, runs, [&](int j, int k, int begin, int end) {
        const T* const row = field(j, k);
        out = std::copy(row + begin, row + end, out);
      });
    return static_cast<std::size_t>(out - buffer);
  }

  void unpack(std::span<const Rows<T>> fields, const Slab& s, std::span<const Run> runs, const T* in) const {
    for (const Rows<T>& field : fields)
      each_piece(s, runs, [&](int j, int k, int begin, int end) {
        std::copy_n(in, end - begin, field(j, k) + begin);
        in += end - begin;
      });
  }

  void exchange_axis(int axis, std::span<const Rows<T>> to_low, std::span<const Rows<T>> to_high,
                     std::span<const Run> runs) {
    const int n = layout_.size[axis];
    const Slab low_owned = slab(axis, 0, width_), high_owned = slab(axis, n - width_, n);
    const Slab low_halo = slab(axis, -width_, 0), high_halo = slab(axis, n, n + width_);
    const int low = neighbour_[axis][0], high = neighbour_[axis][1];
    auto& [send_low, send_high, from_low, from_high] = buffers_;
    if (low == own_rank_) {  // the axis is not cut, and periodic
      pack(to_low, low_owned, runs, send_low.data());
      pack(to_high, high_owned, runs, send_high.data());
      unpack(to_low, high_halo, runs, send_low.data());
      unpack(to_high, low_halo, runs, send_high.data());
      return;
    }
    if (low < 0 && high < 0) return;

    std::array<MPI_Request, 4> requests;
    int count = 0;
    const int tag_down = 2 * axis, tag_up = 2 * axis + 1, capacity = static_cast<int>(from_low.size() * sizeof(T));
    if (high >= 0) MPI_Irecv(from_high.data(), capacity, MPI_BYTE, high, tag_down, comm_, &requests[count++]);
    if (low >= 0) MPI_Irecv(from_low.data(), capacity, MPI_BYTE, low, tag_up, comm_, &requests[count++]);
    if (low >= 0) {
      const std::size_t packed = pack(to_low, low_owned, runs, send_low.data());
      MPI_Isend(send_low.data(), static_cast<int>(packed * sizeof(T)), MPI_BYTE, low, tag_down, comm_,
                &requests[count++]);
    }
    if (high >= 0) {
      const std::size_t packed = pack(to_high, high_owned, runs, send_high.data());
      MPI_Isend(send_high.data(), static_cast<int>(packed * sizeof(T)), MPI_BYTE, high, tag_up, comm_,
                &requests[count++]);
    }
    MPI_Waitall(count, requests.data(), MPI_STATUSES_IGNORE);
    if (high >= 0) unpack(to_low, high_halo, runs, from_high.data());
    if (low >= 0) unpack(to_high, low_halo, runs, from_low.data());
  }

  MPI_Comm comm_;
  int own_rank_;
  Layout layout_;
  int width_;
  std::array<std::array<int, 2>, 3> neighbour_{};
  std::array<std::vector<T>, 4> buffers_;
};

}  // namespace rouleau
