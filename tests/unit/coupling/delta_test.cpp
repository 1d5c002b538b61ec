// SPDX-License-Identifier: BSD-3-Clause
// The moments of the kernels, and their published piecewise forms.
#include "coupling/delta.hpp"

#include <gtest/gtest.h>

namespace rouleau {
namespace {

constexpr double rounding = 4e-16;  // weights are sums of a few terms of order one

/// Calls check(distances, weights) at positions across several nodes, ends of the intervals included.
template <class Phi, class Check>
void everywhere(Check check) {
  for (int n = -64; n <= 64; ++n) {
    const double X = n / 32.0 + (n % 3) * 1e-3;
    const double first = Phi::first_node(X);
    std::array<double, Phi::width> distance;
    for (int a = 0; a < Phi::width; ++a) distance[static_cast<std::size_t>(a)] = X - (first + a);
    check(distance, Phi::weights(X - first));
  }
}

template <class Phi>
class Delta : public ::testing::Test {};
using Kernels = ::testing::Types<TwoPoint, ThreePoint, FourPoint>;
TYPED_TEST_SUITE(Delta, Kernels);

TYPED_TEST(Delta, WeightsSumToOneAnywhere) {
  everywhere<TypeParam>([](const auto&, const auto& w) {
    double sum = 0;
    for (const double x : w) sum += x;
    EXPECT_NEAR(sum, 1.0, rounding);
  });
}

TYPED_TEST(Delta, FirstMomentVanishesAnywhere) {
  everywhere<TypeParam>([](const auto& r, const auto& w) {
    double moment = 0;
    for (std::size_t a = 0; a < w.size(); ++a) moment += r[a] * w[a];
    EXPECT_NEAR(moment, 0.0, rounding);
  });
}

TYPED_TEST(Delta, WeightsAreNeverNegative) {
  everywhere<TypeParam>([](const auto&, const auto& w) {
    for (const double x : w) EXPECT_GE(x, -rounding);
  });
}

TYPED_TEST(Delta, IsContinuousWhereTheStencilMoves) {
  for (const double X : {2.0, 2.5}) {
    const double below = std::nextafter(X, 0.0);
    const auto weight_of = [](double at, double node) {
      const double first = TypeParam::first_node(at);
      const double a = node - first;
      return a < 0 || a >= TypeParam::width ? 0.0 : TypeParam::weights(at - first)[static_cast<std::size_t>(a)];
    };
    // phi_4 has a square root that starts at 0: its slope is finite, the others are smooth or linear.
    for (int node = -2; node <= 6; ++node) EXPECT_NEAR(weight_of(X, node), weight_of(below, node), 1e-15);
  }
}

TEST(DeltaFourPoint, EvenAndOddNodesHoldOneHalfEach) {
  everywhere<FourPoint>([](const auto&, const auto& w) {
    EXPECT_NEAR(w[0] + w[2], 0.5, rounding);
    EXPECT_NEAR(w[1] + w[3], 0.5, rounding);
  });
}

TEST(DeltaFourPoint, SumOfSquaresIsThreeEighths) {
  everywhere<FourPoint>([](const auto&, const auto& w) {
    EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3], 3.0 / 8.0, rounding);
  });
}

TEST(DeltaThreePoint, SumOfSquaresIsOneHalf) {
  everywhere<ThreePoint>(
      [](const auto&, const auto& w) { EXPECT_NEAR(w[0] * w[0] + w[1] * w[1] + w[2] * w[2], 0.5, rounding); });
}

// Near the ends of the support the published roots take the difference of nearly equal numbers: hence the tolerances.

TEST(DeltaFourPoint, IsTheFunctionOfPeskin) {
  everywhere<FourPoint>([](const auto& distance, const auto& w) {
    for (std::size_t a = 0; a < w.size(); ++a) {
      const double r = std::abs(distance[a]);
      const double phi = r <= 1 ? (3 - 2 * r + std::sqrt(std::max(0.0, 1 + 4 * r - 4 * r * r))) / 8
                                : (5 - 2 * r - std::sqrt(std::max(0.0, -7 + 12 * r - 4 * r * r))) / 8;
      EXPECT_NEAR(w[a], phi, 1e-14) << r;
    }
  });
}

TEST(DeltaThreePoint, IsTheFunctionOfRoma) {
  everywhere<ThreePoint>([](const auto& distance, const auto& w) {
    for (std::size_t a = 0; a < w.size(); ++a) {
      const double r = std::abs(distance[a]);
      const double phi = r <= 0.5 ? (1 + std::sqrt(1 - 3 * r * r)) / 3
                                  : (5 - 3 * r - std::sqrt(std::max(0.0, 1 - 3 * (1 - r) * (1 - r)))) / 6;
      EXPECT_NEAR(w[a], phi, 1e-14) << r;
    }
  });
}

TEST(DeltaTwoPoint, IsLinearInterpolation) {
  const auto w = TwoPoint::weights(3.25 - TwoPoint::first_node(3.25));
  EXPECT_EQ(w[0], 0.75);
  EXPECT_EQ(w[1], 0.25);
}

}  // namespace
}  // namespace rouleau
