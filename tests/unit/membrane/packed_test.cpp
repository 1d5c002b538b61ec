// SPDX-License-Identifier: BSD-3-Clause
// Packed vertices: rows and back, and the cross product.
#include "membrane/packed.hpp"

#include <gtest/gtest.h>

#include "membrane/v3.hpp"

namespace rouleau {
namespace {

TEST(MembranePacked, RowsHoldTheComponentsAndComeBack) {
  Packed in[4], out[4];
  for (int i = 0; i < 4; ++i) in[i] = Packed{10. * i, 10. * i + 1, 10. * i + 2, 10. * i + 3};
  PackedRows rows{};
  set_rows(rows, 8, in[0], in[1], in[2], in[3]);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(rows.x[8 + i], 10 * i);
    EXPECT_EQ(rows.y[8 + i], 10 * i + 1);
    EXPECT_EQ(rows.z[8 + i], 10 * i + 2);
    EXPECT_EQ(rows.w[8 + i], 10 * i + 3);
  }
  EXPECT_EQ(rows.x[7] + rows.x[12], 0);
  get_rows(rows, 8, out[0], out[1], out[2], out[3]);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(out[i][k], in[i][k]);
  }
}

TEST(MembranePacked, CrossProductIsThatOfPlainVectors) {
  const V3 u{1.5, -2.25, 0.375}, v{-0.5, 4, 3.125};
  const V3 expected = cross(u, v);
  const Packed N = cross(Packed{u.x, u.y, u.z, 5}, Packed{v.x, v.y, v.z, 7});
  EXPECT_EQ(N[0], expected.x);
  EXPECT_EQ(N[1], expected.y);
  EXPECT_EQ(N[2], expected.z);
  EXPECT_EQ(N[3], 0);
}

}  // namespace
}  // namespace rouleau
