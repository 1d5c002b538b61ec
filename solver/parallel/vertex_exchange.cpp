// SPDX-License-Identifier: BSD-3-Clause
#include "parallel/vertex_exchange.hpp"

#include "base/error.hpp"

namespace rouleau {

VertexExchange::VertexExchange(const Communicator& comm, std::size_t vertices)
    : comm_(comm.raw()),
      mine_(vertices),
      all_(comm.size() > 1 ? vertices : 0),
      bytes_(static_cast<std::size_t>(comm.size())),
      offsets_(static_cast<std::size_t>(comm.size())) {}

void VertexExchange::share(std::span<const std::int32_t> owned, VectorArray& values) {
  if (bytes_.size() == 1) {
    require(owned.size() == values.size(), "a vertex is owned by no rank");
    return;
  }
  for (std::size_t n = 0; n < owned.size(); ++n) {
    const auto v = static_cast<std::size_t>(owned[n]);
    mine_[n] = {values.x[v], values.y[v], values.z[v], owned[n]};
  }
  const int count = static_cast<int>(owned.size() * sizeof(Entry));
  MPI_Allgather(&count, 1, MPI_INT, bytes_.data(), 1, MPI_INT, comm_);
  int total = 0;
  for (std::size_t r = 0; r < bytes_.size(); ++r) {
    offsets_[r] = total;
    total += bytes_[r];
  }
  require(static_cast<std::size_t>(total) == values.size() * sizeof(Entry),
          "a vertex is owned by no rank or by several");
  MPI_Allgatherv(mine_.data(), count, MPI_BYTE, all_.data(), bytes_.data(), offsets_.data(), MPI_BYTE, comm_);
  for (const Entry& e : all_) {
    const auto v = static_cast<std::size_t>(e.vertex);
    values.x[v] = e.x;
    values.y[v] = e.y;
    values.z[v] = e.z;
  }
}

}  // namespace rouleau
