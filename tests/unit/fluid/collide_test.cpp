// SPDX-License-Identifier: BSD-3-Clause
// The collision of one node against its moments and against dense matrices.
#include <gtest/gtest.h>

#include <random>

#include "fluid/relax.hpp"
#include "slow_fluid.hpp"

namespace rouleau {
namespace {

using testing::Column;
using testing::velocity_of;

Pulled<double> pulled(const Column& f_minus_w) {
  Pulled<double> pulled;
  pulled.rest = f_minus_w[0];
  for (int p = 0; p < pairs; ++p) {
    pulled.sum[p] = f_minus_w[1 + 2 * p] + f_minus_w[2 + 2 * p];
    pulled.difference[p] = f_minus_w[1 + 2 * p] - f_minus_w[2 + 2 * p];
  }
  return pulled;
}

Column column_of(const Halves<double>& h) {
  Column f;
  f[0] = h.rest;
  for (int p = 0; p < pairs; ++p) {
    f[1 + 2 * p] = h.even[p] + h.odd[p];
    f[2 + 2 * p] = h.even[p] - h.odd[p];
  }
  return f;
}

Column weights() {
  Column w;
  for (int q = 0; q < Q; ++q) w[q] = w_q(q);
  return w;
}

/// Far from equilibrium, to make every moment count.
struct Node {
  Column f;  ///< full populations
  Vec3 F;

  explicit Node(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-0.01, 0.01);
    for (int q = 0; q < Q; ++q) f[q] = w_q(q) + value(random);
    F = Vec3(value(random), value(random), value(random));
  }
  [[nodiscard]] Pulled<double> populations() const { return pulled(f - weights()); }
  [[nodiscard]] Real3<double> force() const { return {F[0], F[1], F[2]}; }
  [[nodiscard]] Moments<double> all_moments() const { return moments(populations(), force()); }
};

Column equilibrium_of(const Moments<double>& m) {
  Halves<double> h;
  h.rest = equilibrium_rest(m);
  unrolled<pairs>([&](auto p) {
    const Pair<double> pair = equilibrium<p>(m);
    h.even[p] = pair.even;
    h.odd[p] = pair.odd;
  });
  return column_of(h);
}

Column source_of(const Moments<double>& m) {
  Halves<double> h;
  h.rest = guo_source_rest(m);
  unrolled<pairs>([&](auto p) {
    const Pair<double> pair = guo_source<p>(m);
    h.even[p] = pair.even;
    h.odd[p] = pair.odd;
  });
  return column_of(h);
}

Vec3 first_moment(const Column& f) {
  Vec3 sum = Vec3::Zero();
  for (int q = 0; q < Q; ++q) sum += f[q] * velocity_of(q);
  return sum;
}

Eigen::Matrix3d second_moment(const Column& f) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int q = 0; q < Q; ++q) sum += f[q] * velocity_of(q) * velocity_of(q).transpose();
  return sum;
}

// Sums of 19 numbers below 1: a few units in the last place.
constexpr double rounding = 2e-16;

TEST(FluidEquilibrium, HasTheMomentsOfTheFluid) {
  const Node node(1);
  const Moments<double> m = node.all_moments();
  const Column f = equilibrium_of(m);
  const double rho = 1 + m.rho_1;
  const Vec3 u(m.u[0], m.u[1], m.u[2]);
  EXPECT_NEAR(f.sum(), m.rho_1, rounding);
  EXPECT_LT((first_moment(f) - rho * u).norm(), rounding);
  const Eigen::Matrix3d stress = m.rho_1 / 3 * Eigen::Matrix3d::Identity() + rho * u * u.transpose();
  EXPECT_LT((second_moment(f) - stress).norm(), 2 * rounding);
}

TEST(FluidEquilibrium, IsEquationThreeMinusTheWeights) {
  const Node node(2);
  const Moments<double> m = node.all_moments();
  const Column full = testing::equilibrium_column(1 + m.rho_1, Vec3(m.u[0], m.u[1], m.u[2]));
  EXPECT_LT((equilibrium_of(m) - (full - weights())).cwiseAbs().maxCoeff(), rounding);
}

TEST(FluidForce, SourceAddsForceAndItsWorkOnly) {
  const Node node(3);
  const Moments<double> m = node.all_moments();
  const Vec3 u(m.u[0], m.u[1], m.u[2]);
  const Column S = source_of(m);
  EXPECT_NEAR(S.sum(), 0, rounding);
  EXPECT_LT((first_moment(S) - node.F).norm(), rounding);
  EXPECT_LT((second_moment(S) - u * node.F.transpose() - node.F * u.transpose()).norm(), rounding);
}

TEST(FluidCollision, ConservesMassAndAddsTheForce) {
  const TrtRates<> trt = trt_rates(0.3);
  const MrtRates<> mrt{.e = 1.1, .eps = 1.3, .q = 1.7, .nu = 0.9, .pi = 1.5, .m = 0.6};
  for (unsigned seed = 10; seed < 20; ++seed) {
    const Node node(seed);
    for (const Column& after : {column_of(collide(node.populations(), node.all_moments(), factors_of<double>(trt))),
                                column_of(collide(node.populations(), node.all_moments(), mrt))}) {
      EXPECT_NEAR(after.sum(), (node.f - weights()).sum(), rounding);
      EXPECT_LT((first_moment(after) - first_moment(node.f) - node.F).norm(), 2 * rounding);
    }
  }
}

TEST(FluidCollision, TrtIsItsDenseMatrix) {
  const TrtRates<> rates = trt_rates(5.0 / 6);
  for (unsigned seed = 20; seed < 30; ++seed) {
    const Node node(seed);
    const Column slow = testing::collide_slowly(node.f, node.F, testing::relaxation(rates));
    const Column fast =
        column_of(collide(node.populations(), node.all_moments(), factors_of<double>(rates))) + weights();
    EXPECT_LT((slow - fast).cwiseAbs().maxCoeff(), rounding);
  }
}

TEST(FluidCollision, MrtIsItsDenseMatrix) {
  const MrtRates<> rates{.e = 1.1, .eps = 1.3, .q = 1.7, .nu = 0.9, .pi = 1.5, .m = 0.6};
  for (unsigned seed = 30; seed < 40; ++seed) {
    const Node node(seed);
    const Column slow = testing::collide_slowly(node.f, node.F, testing::relaxation(rates));
    const Column fast = column_of(collide(node.populations(), node.all_moments(), rates)) + weights();
    EXPECT_LT((slow - fast).cwiseAbs().maxCoeff(), 4 * rounding);  // the dense inverse rounds too
  }
}

TEST(FluidCollision, MrtWithTwoRatesIsTrt) {
  for (const double nu : {1.0 / 6, 5.0 / 6})
    for (unsigned seed = 40; seed < 50; ++seed) {
      const Node node(seed);
      const TrtRates<> trt = trt_rates(nu);
      const Column a = column_of(collide(node.populations(), node.all_moments(), factors_of<double>(trt)));
      const Column b = column_of(collide(node.populations(), node.all_moments(), mrt_rates_of_trt(trt)));
      EXPECT_LT((a - b).cwiseAbs().maxCoeff(), rounding);
    }
}

TEST(FluidCollision, EachMrtRateActsOnItsOwnMoments) {
  const Node node(50);
  const MrtRates<> base{.e = 1, .eps = 1, .q = 1, .nu = 1, .pi = 1, .m = 1};
  const Column reference = testing::basis_matrix() * column_of(collide(node.populations(), node.all_moments(), base));
  const std::array<std::pair<MomentKind, double MrtRates<>::*>, 6> rates{{{MomentKind::e, &MrtRates<>::e},
                                                                          {MomentKind::eps, &MrtRates<>::eps},
                                                                          {MomentKind::q, &MrtRates<>::q},
                                                                          {MomentKind::nu, &MrtRates<>::nu},
                                                                          {MomentKind::pi, &MrtRates<>::pi},
                                                                          {MomentKind::m, &MrtRates<>::m}}};
  for (const auto& [kind, rate] : rates) {
    MrtRates<> changed = base;
    changed.*rate = 1.4;
    const Column after = testing::basis_matrix() * column_of(collide(node.populations(), node.all_moments(), changed));
    for (int k = 0; k < Q; ++k) {
      const double change = std::abs(after[k] - reference[k]);
      // Rows sum up to 19 |f| 30 with |f| < 0.01: rounding below 1e-14, changes of the order of 1e-3.
      if (moment_basis[k].kind == kind) {
        EXPECT_GT(change, 1e-6) << k;
      } else {
        EXPECT_LT(change, 1e-14) << k;
      }
    }
  }
}

}  // namespace
}  // namespace rouleau
