// SPDX-License-Identifier: BSD-3-Clause
// The lattice, its moment basis, and the rates. (Moment identities of the weights are static_asserts in the headers.)
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "slow_fluid.hpp"

namespace rouleau {
namespace {

TEST(FluidLattice, FiveDirectionsCrossEachFace) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const auto list = directions_out(axis, side);
      for (std::size_t n = 0; n < list.size(); ++n) {
        EXPECT_EQ(c_q[list[n]][axis], side == 0 ? -1 : 1);
        if (n > 0) {
          EXPECT_LT(list[n - 1], list[n]);
        }
      }
    }
}

TEST(FluidLattice, VelocitiesAreTheNineteenOfLengthUpToRootTwo) {
  for (int q = 0; q < Q; ++q) {
    EXPECT_LE(squared_length(q), 2);
    for (int other = 0; other < q; ++other) EXPECT_NE(c_q[q], c_q[other]);
  }
}

TEST(FluidMomentBasis, InverseIsTheScaledTranspose) {
  testing::Square inverse;
  for (int q = 0; q < Q; ++q)
    for (int k = 0; k < Q; ++k) inverse(q, k) = double(moment_basis[k].value[q]) / moment_norm(k);
  // Entries up to 30, 19 terms: a few units in the last place.
  EXPECT_LT((testing::basis_matrix() * inverse - testing::Square::Identity()).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(FluidMomentBasis, HasThePublishedRows) {
  // [d'Humieres 2002] appendix: energy, its square and energy flux at |c|^2 = 0, 1, 2; norms of all rows.
  EXPECT_EQ(moment_basis[1].value[0], -30);
  EXPECT_EQ(moment_basis[1].value[1], -11);
  EXPECT_EQ(moment_basis[1].value[7], 8);
  EXPECT_EQ(moment_basis[2].value[0], 12);
  EXPECT_EQ(moment_basis[2].value[1], -4);
  EXPECT_EQ(moment_basis[2].value[7], 1);
  EXPECT_EQ(moment_basis[6].value[1], -4);
  EXPECT_EQ(moment_basis[6].value[7], 1);
  const std::array<int, Q> norms{19, 2394, 252, 10, 10, 10, 40, 40, 40, 36, 12, 4, 4, 4, 72, 24, 8, 8, 8};
  for (int k = 0; k < Q; ++k) EXPECT_EQ(moment_norm(k), norms[k]) << k;
}

TEST(FluidRates, MagicNumberIsTheSameAtEveryViscosity) {
  for (const double nu : {1e-3, 1.0 / 6, 5.0 / 6, 6.8}) {
    const TrtRates<> rates = trt_rates(nu, 0.1875);
    EXPECT_NEAR((1 / rates.even - 0.5) * (1 / rates.odd - 0.5), 0.1875, 1e-14) << nu;
    EXPECT_NEAR((1 / rates.even - 0.5) / 3, nu, 1e-15 * (1 + nu)) << nu;
    EXPECT_GT(rates.odd, 0);
    EXPECT_LT(rates.odd, 2);
  }
}

TEST(FluidRates, BadValuesAreRefused) {
  EXPECT_THROW(trt_rates(0), Error);
  EXPECT_THROW(trt_rates(-1), Error);
  EXPECT_THROW(trt_rates(1000), Error);
  EXPECT_THROW(trt_rates(1.0 / 6, 0), Error);
  EXPECT_THROW(trt_rates(std::nan("")), Error);
  EXPECT_THROW(mrt_rates(1.0 / 6, 2, 1), Error);
  EXPECT_THROW(mrt_rates(1.0 / 6, 1, 0), Error);
}

}  // namespace
}  // namespace rouleau
