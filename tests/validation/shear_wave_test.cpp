// SPDX-License-Identifier: BSD-3-Clause
// A transverse wave in a periodic box dies out at the rate nu k^2: what viscosity a relaxation time stands for.
#include <gtest/gtest.h>

#include <numbers>

#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

/// Measured over asked viscosity, minus 1, of a wave of u_x along z over N nodes.
template <class Real>
double viscosity_error(const Collision& collision, double nu, int N) {
  const double k = 2 * std::numbers::pi / N;
  testing::OneBlock<Real> block({{2, 2, N}, {true, true, true}}, collision);
  set_equilibrium(
      block.fluid, [&](const Int3& n) { return Vec3(1e-3 * std::sin(k * n[2]), 0, 0); }, Vec3::Zero());
  const auto amplitude = [&] {
    double sum = 0;
    for (int n = 0; n < N; ++n) sum += block.u(0, 1, 1, n) * std::sin(k * n) * 2 / N;
    return sum;
  };
  const int settle = 40, steps = static_cast<int>(0.5 / (nu * k * k));  // 40 steps: the stress builds up at tau 3
  block.run(settle);
  const double before = amplitude();
  block.run(steps);
  return std::log(before / amplitude()) / (nu * k * k * steps) - 1;
}

TEST(ShearWave, DecaysWithTheViscosityOfTauOneAndThree) {
  for (const double tau : {1.0, 3.0}) {
    const double nu = (tau - 0.5) / 3;
    const double coarse = viscosity_error<double>(testing::one_trt(nu), nu, 64);
    const double fine = viscosity_error<double>(testing::one_trt(nu), nu, 128);
    EXPECT_LT(std::abs(fine), 0.01) << tau;
    EXPECT_NEAR(coarse / fine, 4, 0.2) << tau;  // second order in k
  }
}

TEST(ShearWave, DecaysAlikeWithMrtAndInSingle) {
  const double nu = 1.0 / 6;
  const MrtRates<> rates = mrt_rates(nu, 1.2, 1.1);
  EXPECT_LT(std::abs(viscosity_error<double>(TwoFluids<MrtRates<>>{rates, rates}, nu, 64)), 0.01);
  // Rounding of 3e-11 on an amplitude of 1e-3, over some thousand steps.
  EXPECT_NEAR(viscosity_error<float>(testing::one_trt(nu), nu, 64),
              viscosity_error<double>(testing::one_trt(nu), nu, 64), 1e-4);
}

}  // namespace
}  // namespace rouleau
