// SPDX-License-Identifier: BSD-3-Clause
// Force-driven flow through a rectangular channel of aspect ratio 6 : 5, the paper's.
#include <gtest/gtest.h>

#include "analytic_flows.hpp"

namespace rouleau {
namespace {

using testing::DuctError;

template <class Real>
DuctError duct_error(int ny, int nz, double nu, int steps) {
  return testing::duct_error<Real>(testing::one_trt(nu), nu, ny, nz, steps);
}

// nu = 1 settles six times as fast as nu = 1/6: slowest decay time 54 steps at 36 x 30.

TEST(Duct, FlowRateAndPeakAreWithinTwoInAThousandAtThePapersResolution) {
  const DuctError error = duct_error<double>(36, 30, 1, 1500);
  EXPECT_LT(error.l2, 1e-3);
  EXPECT_LT(std::abs(error.mean), 2e-3);  // 1.1e-3 of it is the midpoint rule of the mean
  EXPECT_LT(std::abs(error.largest), 2e-3);
}

TEST(Duct, SinglePrecisionIsAsGood) {
  const DuctError error = duct_error<float>(36, 30, 1, 1500);
  EXPECT_LT(error.l2, 1e-3);
  EXPECT_LT(std::abs(error.mean), 2e-3);
  EXPECT_LT(std::abs(error.largest), 2e-3);
}

TEST(Duct, ErrorIsOfSecondOrder) {
  const double coarse = duct_error<double>(24, 20, 1, 1000).l2, fine = duct_error<double>(48, 40, 1, 3000).l2;
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
}

TEST(Duct, SteadyFlowDoesNotDependOnTheViscosityButForItsScale) {
  // At equal magic number TRT's steady errors are those of its geometry.
  const DuctError thick = duct_error<double>(12, 10, 1, 1200), thin = duct_error<double>(12, 10, 1.0 / 6, 7200);
  EXPECT_NEAR(thick.l2, thin.l2, 1e-6);
  EXPECT_NEAR(thick.mean, thin.mean, 1e-6);
}

}  // namespace
}  // namespace rouleau
