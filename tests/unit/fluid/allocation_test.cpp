// SPDX-License-Identifier: BSD-3-Clause
// The step allocates nothing: operator new is replaced in this program by one that counts.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "fluid/controller.hpp"
#include "fluid/flow_rate.hpp"
#include "support/one_block.hpp"

namespace {
std::size_t allocations = 0;

void* counted(std::size_t bytes, std::size_t alignment) {
  ++allocations;
  void* p = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (p == nullptr) throw std::bad_alloc();
  return p;
}
}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) { return counted(bytes, std::size_t(alignment)); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace rouleau {
namespace {

TEST(FluidAllocation, HappensOnlyAtConstruction) {
  const std::size_t at_start = allocations;
  testing::OneBlock<float> block({{20, 6, 5}, {true, false, false}}, testing::two_trt(1.0 / 6, 5.0 / 6));
  const MeanVelocityController controller(1e-3, 100, 10);
  ControllerState state = controller.start(0);
  block.inside(3, 3, 3) = 1;
  EXPECT_GT(allocations, at_start);
  const std::size_t before = allocations;
  for (int n = 0; n < 3; ++n) {
    block.step();
    controller.update(state, mean_velocity(momentum_fixed_point(block.fluid, 0), 600, state.force));
    (void)check_speed(block.fluid, 0.1);
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace rouleau
