// SPDX-License-Identifier: BSD-3-Clause
// Relaxation rates from viscosities.
#include "fluid/rates.hpp"

#include "base/error.hpp"

namespace rouleau {

namespace {

// Above it the even rate is below 0.004 and the flow takes thousands of steps to cross one node: surely a unit mistake.
constexpr double largest_viscosity = 100;

void require_rate(const char* name, double rate) {
  if (!(rate > 0 && rate < 2))
    fail(Exit::bad_input,
         "relaxation rate `{}` is {}; it must lie between 0 and 2, both excluded. Choose another rate.", name, rate);
}

}  // namespace

double shear_rate_of(double nu) {
  if (!(nu > 0 && nu <= largest_viscosity))
    fail(
        Exit::bad_input,
        "kinematic viscosity is {} in lattice units; it must lie in (0, {}]. Change the time step or the node spacing.",
        nu, largest_viscosity);
  return 1 / (3 * nu + 0.5);
}

TrtRates<> trt_rates(double nu, double magic) {
  if (!(magic > 0))
    fail(Exit::bad_input, "magic number of TRT is {}; it must be positive. 0.1875 makes walls exact.", magic);
  return {shear_rate_of(nu), 1 / (magic / (3 * nu) + 0.5)};
}

MrtRates<> mrt_rates_of_trt(const TrtRates<>& rates) {
  return {.e = rates.even, .eps = rates.even, .q = rates.odd, .nu = rates.even, .pi = rates.even, .m = rates.odd};
}

MrtRates<> mrt_rates(double nu, double bulk, double ghost) {
  require_rate("bulk", bulk);
  require_rate("ghost", ghost);
  return {.e = bulk, .eps = ghost, .q = ghost, .nu = shear_rate_of(nu), .pi = ghost, .m = ghost};
}

}  // namespace rouleau
