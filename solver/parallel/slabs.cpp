// SPDX-License-Identifier: BSD-3-Clause
// Redistribution of blocks into z-slabs.
#include "parallel/slabs.hpp"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <cstring>

#include "base/error.hpp"

namespace rouleau {

Slabs::Slabs(const Communicator& comm, const Lattice& lattice, const Block& own)
    : comm_(comm), lattice_(lattice), blocks_(static_cast<std::size_t>(comm.size())) {
  static_assert(sizeof(Block) == 6 * sizeof(int), "blocks travel as six integers");
  MPI_Allgather(&own, 6, MPI_INT, blocks_.data(), 6, MPI_INT, comm_.raw());
  first_plane_ = first_plane_of(comm_.rank());
  planes_ = first_plane_of(comm_.rank() + 1) - first_plane_;
}

int Slabs::first_plane_of(int rank) const {
  return static_cast<int>(std::int64_t{lattice_.size[2]} * rank / comm_.size());
}

Slabs::Overlap Slabs::overlap(const Block& block, int slab_rank) const {
  const int begin = std::max(block.begin[2], first_plane_of(slab_rank));
  const int end = std::min(block.begin[2] + block.size[2], first_plane_of(slab_rank + 1));
  return {begin, std::max(0, end - begin)};
}

void Slabs::gather(const std::vector<std::byte>& packed, std::size_t element_size, std::vector<std::byte>& slab) {
  const auto ranks = static_cast<std::size_t>(comm_.size());
  const auto plane_bytes = [&](const Block& block) {
    return static_cast<std::size_t>(block.size[0]) * static_cast<std::size_t>(block.size[1]) * element_size;
  };
  const Block& own = blocks_[static_cast<std::size_t>(comm_.rank())];
  std::vector<int> send_count(ranks), send_begin(ranks), receive_count(ranks), receive_begin(ranks);
  std::size_t total = 0;
  for (std::size_t r = 0; r < ranks; ++r) {
    const Overlap out = overlap(own, static_cast<int>(r));
    const Overlap in = overlap(blocks_[r], comm_.rank());
    // Planes follow each other in a packed block, so what goes to one slab is one piece.
    const std::size_t offset = out.count == 0 ? 0 : static_cast<std::size_t>(out.begin - own.begin[2]);
    send_begin[r] = static_cast<int>(offset * plane_bytes(own));
    send_count[r] = static_cast<int>(static_cast<std::size_t>(out.count) * plane_bytes(own));
    receive_begin[r] = static_cast<int>(total);
    receive_count[r] = static_cast<int>(static_cast<std::size_t>(in.count) * plane_bytes(blocks_[r]));
    total += static_cast<std::size_t>(receive_count[r]);
  }
  require(packed.size() <= INT_MAX && total <= INT_MAX, "Slabs: a component of one rank exceeds 2 GiB");
  received_.resize(total);
  MPI_Alltoallv(packed.data(), send_count.data(), send_begin.data(), MPI_BYTE, received_.data(), receive_count.data(),
                receive_begin.data(), MPI_BYTE, comm_.raw());

  const auto nx = static_cast<std::size_t>(lattice_.size[0]);
  const auto ny = static_cast<std::size_t>(lattice_.size[1]);
  slab.resize(static_cast<std::size_t>(planes_) * ny * nx * element_size);
  for (std::size_t r = 0; r < ranks; ++r) {
    const Block& block = blocks_[r];
    const Overlap in = overlap(block, comm_.rank());
    const std::size_t row = static_cast<std::size_t>(block.size[0]) * element_size;
    const std::byte* from = received_.data() + receive_begin[r];
    for (int z = in.begin; z < in.begin + in.count; ++z) {
      for (int j = 0; j < block.size[1]; ++j, from += row) {
        const auto plane = static_cast<std::size_t>(z - first_plane_);
        const auto y = static_cast<std::size_t>(block.begin[1] + j);
        const auto x = static_cast<std::size_t>(block.begin[0]);
        std::memcpy(slab.data() + ((plane * ny + y) * nx + x) * element_size, from, row);
      }
    }
  }
}

}  // namespace rouleau
