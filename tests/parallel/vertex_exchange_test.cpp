// SPDX-License-Identifier: BSD-3-Clause
// Every rank ends with every vertex's value, bit for bit; a vertex without an owner is noticed.
#include "parallel/vertex_exchange.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rouleau {
namespace {

TEST(VertexExchange, SharesValuesOfTheirOwners) {
  const Communicator comm;
  constexpr std::size_t vertices = 1000;
  VectorArray values(vertices);
  std::vector<std::int32_t> owned;
  for (std::size_t v = 0; v < vertices; ++v)
    if (static_cast<int>(v * 7 / 3) % comm.size() == comm.rank()) {
      owned.push_back(static_cast<std::int32_t>(v));
      values.x[v] = -0.0;
      values.y[v] = 1.0 / 3.0 * static_cast<double>(v);
      values.z[v] = 1e-310;
    }
  VertexExchange exchange(comm, vertices);
  exchange.share(owned, values);
  for (std::size_t v = 0; v < vertices; ++v) {
    ASSERT_TRUE(std::signbit(values.x[v])) << v;
    ASSERT_EQ(values.y[v], 1.0 / 3.0 * static_cast<double>(v));
    ASSERT_EQ(values.z[v], 1e-310);
  }
}

TEST(VertexExchange, NoticesAVertexWithoutOwner) {
  const Communicator comm;
  VectorArray values(10);
  std::vector<std::int32_t> owned;
  if (comm.is_root()) owned = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  VertexExchange exchange(comm, 10);
  EXPECT_THROW(exchange.share(owned, values), std::logic_error);
}

}  // namespace
}  // namespace rouleau
