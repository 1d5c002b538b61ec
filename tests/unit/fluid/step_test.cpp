// SPDX-License-Identifier: BSD-3-Clause
// The step of a block: against the plain second implementation, conservation, and what must not change its bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "fluid/flow_rate.hpp"
#include "fluid/initial.hpp"
#include "slow_fluid.hpp"
#include "support/one_block.hpp"

namespace rouleau {
namespace {

using testing::OneBlock;
using testing::swirl;

const MrtRates<> odd_rates{.e = 1.1, .eps = 1.3, .q = 1.7, .nu = 0.9, .pi = 1.5, .m = 0.6};
const MrtRates<> other_rates{.e = 0.8, .eps = 1.2, .q = 1.1, .nu = 0.4, .pi = 0.9, .m = 1.6};

bool is_flagged(const Int3& n) { return (n[0] * 3 + n[1] * 5 + n[2] * 7) % 4 == 0; }
Vec3 local_force(const Int3& n) { return 1e-4 * swirl({n[2], n[0], n[1]}); }

template <class Real>
OneBlock<Real> busy_block(const Lattice& lattice, const Collision& collision) {
  OneBlock<Real> block(lattice, collision);
  block.body_force = Vec3(1e-4, 2e-5, -3e-5);
  set_equilibrium(
      block.fluid, [](const Int3& n) { return Vec3(0.02 * swirl(n)); }, block.body_force);
  for (int k = 0; k < lattice.size[2]; ++k)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (int i = 0; i < lattice.size[0]; ++i) {
        block.inside(i, j, k) = is_flagged({i, j, k}) ? 1 : 0;
        for (int a = 0; a < 3; ++a) block.fluid.g[a](i, j, k) = Real(local_force({i, j, k})[a]);
      }
  return block;
}

template <class Real>
double largest_difference(const Fluid<double>& a, const Fluid<Real>& b) {
  double largest = 0;
  for (int q = 0; q < Q; ++q)
    for (int k = 0; k < a.block.size[2]; ++k)
      for (int j = 0; j < a.block.size[1]; ++j)
        for (int i = 0; i < a.block.size[0]; ++i)
          largest = std::max(largest, std::abs(a.f.at(q, i, j, k) - double(b.f.at(q, i, j, k))));
  return largest;
}

template <class Real>
bool same_bits(const Fluid<Real>& a, const Fluid<Real>& b) {
  for (int q = 0; q < Q; ++q)
    for (int k = 0; k < a.block.size[2]; ++k)
      for (int j = 0; j < a.block.size[1]; ++j)
        if (std::memcmp(&a.f.at(q, 0, j, k), &b.f.at(q, 0, j, k),
                        sizeof(Real) * static_cast<std::size_t>(a.block.size[0])) != 0)
          return false;
  return true;
}

class FluidStep : public ::testing::TestWithParam<std::tuple<std::array<bool, 3>, bool>> {};

TEST_P(FluidStep, AgreesWithThePlainImplementation) {
  const auto& [periodic, is_mrt] = GetParam();
  const Lattice lattice{{19, 4, 5}, periodic};
  const Collision collision = is_mrt ? Collision(TwoFluids<MrtRates<>>{odd_rates, other_rates})
                                     : Collision(TwoFluids<TrtRates<>>{trt_rates(1.0 / 6), trt_rates(5.0 / 6)});
  OneBlock<double> block = busy_block<double>(lattice, collision);
  testing::SlowFluid slow{lattice, {}, {}};
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      Vec3 u = 0.01 * swirl({axis, side, 3});
      u[axis] = 0;
      slow.wall_velocity[axis][side] = block.fluid.wall_velocity[axis][side] = periodic[axis] ? Vec3(0, 0, 0) : u;
    }
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 19; ++i) {
        testing::Column f;
        for (int q = 0; q < Q; ++q) f[q] = w_q(q) + block.fluid.f.at(q, i, j, k);
        slow.f.push_back(f);
      }
  const std::array<testing::Square, 2> R =
      is_mrt ? std::array{testing::relaxation(odd_rates), testing::relaxation(other_rates)}
             : std::array{testing::relaxation(trt_rates(1.0 / 6)), testing::relaxation(trt_rates(5.0 / 6))};
  for (int n = 0; n < 12; ++n) {
    block.step();
    slow.step([&](const Int3& node) { return Vec3(block.body_force + local_force(node)); },
              [&](const Int3& node) -> const testing::Square& { return R[is_flagged(node) ? 1 : 0]; });
  }
  double largest = 0;
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 19; ++i)
        for (int q = 0; q < Q; ++q)
          largest =
              std::max(largest, std::abs(slow.f[slow.index({i, j, k})][q] - w_q(q) - block.fluid.f.at(q, i, j, k)));
  EXPECT_LT(largest, 2e-15);  // rounding of populations of size 0.3 in the plain one, over 12 steps
}

INSTANTIATE_TEST_SUITE_P(
    WallsAndLaws, FluidStep,
    ::testing::Combine(::testing::Values(std::array{true, true, true}, std::array{true, true, false},
                                         std::array{true, false, false}, std::array{false, false, false},
                                         std::array{false, true, false}),
                       ::testing::Bool()));

TEST(FluidStepVelocity, IncludesHalfOfAllForces) {
  OneBlock<double> block = busy_block<double>({{17, 3, 4}, {true, true, true}}, testing::one_trt(0.2));
  block.step();
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 17; ++i) {
      // After the step the populations hold u rho + F/2.
      Vec3 j = -0.5 * (block.body_force + local_force({i, 1, k}));
      double rho = 1;
      for (int q = 0; q < Q; ++q) {
        const double f = block.fluid.f.at(q, i, 1, k);
        rho += f;
        j += f * testing::velocity_of(q);
      }
      for (int a = 0; a < 3; ++a) EXPECT_NEAR(block.u(a, i, 1, k), j[a] / rho, 1e-16);
    }
}

TEST(FluidStepMomentum, GrowsByTheForceInAPeriodicBox) {
  const Lattice lattice{{21, 6, 5}, {true, true, true}};
  OneBlock<double> block = busy_block<double>(lattice, testing::two_trt(1.0 / 6, 5.0 / 6));
  Vec3 force = Vec3::Zero();
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 21; ++i) force += block.body_force + local_force({i, j, k});
  const auto before = testing::total_momentum(block.fluid);
  const int steps = 50;
  block.run(steps);
  const auto after = testing::total_momentum(block.fluid);
  // 630 nodes, each rounded to half a unit of 2^-36 twice.
  for (int a = 0; a < 3; ++a)
    EXPECT_NEAR(double(after[a] - before[a]) / momentum_scale, steps * force[a], 630 / momentum_scale) << a;
}

template <class Real>
double mass(const Fluid<Real>& fluid) {
  double sum = 0;
  for (int q = 0; q < Q; ++q)
    for (int k = 0; k < fluid.block.size[2]; ++k)
      for (int j = 0; j < fluid.block.size[1]; ++j)
        for (int i = 0; i < fluid.block.size[0]; ++i) sum += double(fluid.f.at(q, i, j, k));
  return sum;
}

template <class Real>
void expect_mass_is_kept(double tolerance_per_node) {
  OneBlock<Real> block = busy_block<Real>({{16, 8, 8}, {true, false, false}}, testing::two_trt(1.0 / 6, 5.0 / 6));
  block.fluid.wall_velocity[2] = {Vec3(-0.02, 0.01, 0), Vec3(0.02, 0, 0)};
  const double before = mass(block.fluid);
  block.run(400);
  EXPECT_NEAR((mass(block.fluid) - before) / (16 * 8 * 8), 0, tolerance_per_node);
}

// Populations of about 1e-2 round to 1e-18 (double) or 5e-10 (single): 400 random steps give 20 times, a bias 400 times
// that.
TEST(FluidStepMass, IsKeptBetweenMovingWallsInDouble) { expect_mass_is_kept<double>(4e-16); }
TEST(FluidStepMass, IsKeptBetweenMovingWallsInSingle) { expect_mass_is_kept<float>(2e-7); }

template <class Real>
void expect_membrane_rows_change_no_bits(const Collision& collision) {
  const Lattice lattice{{37, 5, 6}, {true, false, false}};  // segments of 16, 16 and 5 nodes
  OneBlock<Real> all = busy_block<Real>(lattice, collision), some = busy_block<Real>(lattice, collision);
  std::vector<std::uint8_t> segments(30);
  const auto is_touched = [&](int i, std::size_t r) { return (segments[r] >> (i / 16) & 1) != 0; };
  for (std::size_t r = 0; r < 30; ++r) {
    segments[r] = static_cast<std::uint8_t>(r % 8);
    for (int i = 0; i < 37; ++i)
      for (int a = 0; a < 3; ++a)
        if (!is_touched(i, r))
          all.fluid.g[a](i, int(r % 5), int(r / 5)) = some.fluid.g[a](i, int(r % 5), int(r / 5)) = 0;
  }
  for (int n = 0; n < 10; ++n) {
    all.step();
    some.step({segments});
  }
  EXPECT_TRUE(same_bits(all.fluid, some.fluid));
  for (std::size_t r = 0; r < 30; ++r)
    for (int i = 0; i < 37; ++i)
      for (int a = 0; a < 3 && is_touched(i, r); ++a)
        EXPECT_EQ(all.fluid.u[a](i, int(r % 5), int(r / 5)), some.fluid.u[a](i, int(r % 5), int(r / 5)));
}

TEST(FluidStepMembraneRows, ChangeNoBits) {
  expect_membrane_rows_change_no_bits<double>(testing::two_trt(1.0 / 6, 5.0 / 6));
  expect_membrane_rows_change_no_bits<float>(testing::two_trt(1.0 / 6, 5.0 / 6));
  expect_membrane_rows_change_no_bits<double>(TwoFluids<MrtRates<>>{odd_rates, other_rates});
  expect_membrane_rows_change_no_bits<float>(TwoFluids<MrtRates<>>{odd_rates, other_rates});
}

TEST(FluidStepMembraneRows, AreAllThatIsReadOfTheForceAndSetOfTheVelocity) {
  const Lattice lattice{{80, 2, 1}, {true, true, true}};
  OneBlock<double> block = busy_block<double>(lattice, testing::one_trt(0.2));
  for (Field<double>& component : block.fluid.u) std::fill(component.data.begin(), component.data.end(), 7);
  for (int i = 0; i < 80; ++i)
    if (i < 16 || i >= 48) block.fluid.g[1](i, 0, 0) = std::nan("");
  block.fluid.g[1](20, 1, 0) = std::nan("");
  const std::vector<std::uint8_t> segments{0b00110, 0};  // nodes 16 to 47 of the first row
  block.step({segments});
  EXPECT_FALSE(check_speed(block.fluid, 0.5).first_bad.has_value());
  for (int i = 0; i < 80; ++i) {
    EXPECT_EQ(block.u(1, i, 0, 0) == 7, i < 16 || i >= 48) << i;
    EXPECT_EQ(block.u(1, i, 1, 0), 7) << i;
  }
}

TEST(FluidStepFlags, OfEqualViscosityChangeNoBits) {
  for (const Collision& collision :
       {testing::one_trt(1.0 / 6), Collision(TwoFluids<MrtRates<>>{odd_rates, odd_rates})}) {
    OneBlock<float> with = busy_block<float>({{33, 4, 4}, {true, false, true}}, collision);
    OneBlock<float> without = busy_block<float>({{33, 4, 4}, {true, false, true}}, collision);
    std::fill(without.inside.data.begin(), without.inside.data.end(), std::uint8_t{0});
    with.run(10);
    without.run(10);
    EXPECT_TRUE(same_bits(with.fluid, without.fluid));
  }
}

TEST(FluidStepSymmetry, ShiftAlongAPeriodicAxisShiftsTheBits) {
  // The place of a node in a vector, or in the remainder after the last vector, must not matter.
  const Lattice lattice{{45, 3, 4}, {true, true, false}};
  const auto shifted = [&](int by) {
    OneBlock<float> block(lattice, testing::two_trt(1.0 / 6, 5.0 / 6));
    set_equilibrium(
        block.fluid,
        [&](const Int3& n) {
          return Vec3(0.02 * swirl({(n[0] + by) % 45, n[1], n[2]}));
        },
        Vec3::Zero());
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 45; ++i) block.inside(i, j, k) = is_flagged({(i + by) % 45, j, k}) ? 1 : 0;
    block.run(8);
    return block;
  };
  const OneBlock<float> a = shifted(0);
  for (const int by : {1, 7, 16, 44}) {
    const OneBlock<float> b = shifted(by);
    for (int q = 0; q < Q; ++q)
      for (int i = 0; i < 45; ++i) ASSERT_EQ(b.fluid.f.at(q, i, 1, 2), a.fluid.f.at(q, (i + by) % 45, 1, 2));
  }
}

TEST(FluidStepPrecision, SingleFollowsDouble) {
  const Lattice lattice{{24, 8, 8}, {true, false, false}};
  OneBlock<double> a(lattice, testing::two_trt(1.0 / 6, 5.0 / 6));
  OneBlock<float> b(lattice, testing::two_trt(1.0 / 6, 5.0 / 6));
  set_equilibrium(
      a.fluid, [](const Int3& n) { return Vec3(1e-3 * swirl(n)); }, Vec3::Zero());
  set_equilibrium(
      b.fluid, [](const Int3& n) { return Vec3(1e-3 * swirl(n)); }, Vec3::Zero());
  a.run(200);
  b.run(200);
  // f - w is at most 5e-4 here; single rounds it to 3e-11, and the flow decays faster than rounding piles up.
  EXPECT_LT(largest_difference(a.fluid, b.fluid), 3e-10);
}

}  // namespace
}  // namespace rouleau
