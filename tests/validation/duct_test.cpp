// SPDX-License-Identifier: BSD-3-Clause
// Force-driven flow through a rectangular channel of aspect ratio 6 : 5, the paper's.
#include <gtest/gtest.h>

#include "fluid/developed.hpp"
#include "fluid/initial.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

struct DuctError {
  double l2 = 0;       ///< relative to the exact field at the nodes
  double mean = 0;     ///< mean over the nodes against the true mean of the cross-section
  double largest = 0;  ///< velocity of the fastest node against the exact one there
};

template <class Real>
DuctError duct_error(int ny, int nz, double nu, int steps) {
  const Lattice lattice{{1, ny, nz}, {true, false, false}};
  testing::OneBlock<Real> block(lattice, testing::one_trt(nu));
  const DevelopedFlow flow(lattice);
  const double target = 7e-4, scale = target / flow.mean();
  block.body_force = Vec3(scale * nu, 0, 0);
  set_developed(block.fluid, target, block.body_force);
  block.run(steps);
  DuctError error;
  double difference = 0, square = 0, sum = 0;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) {
      const double exact = scale * flow.velocity(j - (ny - 1) / 2.0, k - (nz - 1) / 2.0), u = block.u(0, 0, j, k);
      difference += (u - exact) * (u - exact);
      square += exact * exact;
      sum += u;
    }
  error.l2 = std::sqrt(difference / square);
  error.mean = sum / (ny * nz) / target - 1;
  error.largest = block.u(0, 0, ny / 2, nz / 2) / (scale * flow.velocity(0.5, 0.5)) - 1;
  return error;
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
