// SPDX-License-Identifier: BSD-3-Clause
// Gathering blocks on rank 0.
#include "parallel/root_gather.hpp"

#include <climits>
#include <cstring>

#include "base/error.hpp"

namespace rouleau {

RootGather::RootGather(const Communicator& comm, const Lattice& lattice, const Block& own)
    : comm_(comm), lattice_(lattice), blocks_(static_cast<std::size_t>(comm.size())) {
  static_assert(sizeof(Block) == 6 * sizeof(int), "blocks travel as six integers");
  require(lattice.nodes() <= INT_MAX, "RootGather: more nodes than a message can count");
  MPI_Allgather(&own, 6, MPI_INT, blocks_.data(), 6, MPI_INT, comm_.raw());
}

void RootGather::gather_bytes(const void* packed, std::size_t node_bytes, void* whole) const {
  std::vector<int> count, begin;
  int total = 0;
  for (const Block& block : blocks_) {
    count.push_back(block.size[0] * block.size[1] * block.size[2]);
    begin.push_back(total);
    total += count.back();
  }
  std::vector<std::byte> received(comm_.is_root() ? static_cast<std::size_t>(total) * node_bytes : 0);
  MPI_Datatype node = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(node_bytes), MPI_BYTE, &node);
  MPI_Type_commit(&node);
  MPI_Gatherv(packed, count[static_cast<std::size_t>(comm_.rank())], node, received.data(), count.data(), begin.data(),
              node, 0, comm_.raw());
  MPI_Type_free(&node);
  if (!comm_.is_root()) return;

  const std::byte* from = received.data();
  for (const Block& block : blocks_) {
    const std::size_t row = static_cast<std::size_t>(block.size[0]) * node_bytes;
    for (int k = 0; k < block.size[2]; ++k)
      for (int j = 0; j < block.size[1]; ++j, from += row) {
        const std::ptrdiff_t first =
            (std::ptrdiff_t{block.begin[2] + k} * lattice_.size[1] + block.begin[1] + j) * lattice_.size[0] +
            block.begin[0];
        if (row > 0)
          std::memcpy(static_cast<std::byte*>(whole) + static_cast<std::size_t>(first) * node_bytes, from, row);
      }
  }
}

}  // namespace rouleau
