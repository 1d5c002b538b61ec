// SPDX-License-Identifier: BSD-3-Clause
// Gives every rank the values of all vertices, each computed by the one rank that owns the vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/arrays.hpp"
#include "parallel/communicator.hpp"

namespace rouleau {

class VertexExchange {
 public:
  VertexExchange(const Communicator& comm, std::size_t vertices);

  /// Sends values[v] for the vertices v in `owned` (ascending) to all ranks and sets all others of `values`.
  /// Throws logic_error if some vertex is owned by no rank or by several.
  void share(std::span<const std::int32_t> owned, VectorArray& values);

 private:
  struct Entry {
    double x, y, z;
    std::int64_t vertex;
  };
  MPI_Comm comm_;
  std::vector<Entry> mine_, all_;
  std::vector<int> bytes_, offsets_;
};

}  // namespace rouleau
