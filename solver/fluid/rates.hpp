// SPDX-License-Identifier: BSD-3-Clause
// Relaxation rates of the two collision laws, from the viscosity of a fluid.
#pragma once

#include <variant>

namespace rouleau {

/// Two rates: one for the even halves of opposite pairs (it sets the viscosity), one for the odd halves. [Ginzburg
/// 2008]
template <class Real = double>
struct TrtRates {
  Real even, odd;
};

/// A rate for each kind of moment (see moment_basis.hpp): energy, its square, energy flux, shear, and the ghosts pi and
/// m.
template <class Real = double>
struct MrtRates {
  Real e, eps, q, nu, pi, m;
};

/// The rates inside and outside the cells. All collisions of a run have the same law.
template <class Rates>
struct TwoFluids {
  Rates outside, inside;
};

using Collision = std::variant<TwoFluids<TrtRates<>>, TwoFluids<MrtRates<>>>;

/// Product (1/omega_even - 1/2)(1/omega_odd - 1/2) that puts a half-way wall of a channel, and an interface between two
/// viscosities, exactly mid-link.
inline constexpr double exact_wall_magic = 3.0 / 16.0;

/// omega = 1 / (3 nu + 1/2). throws Error(bad_input) unless 0 < nu <= 100 lattice units
double shear_rate_of(double nu);

/// even = 1 / (3 nu + 1/2), odd from (1/even - 1/2)(1/odd - 1/2) = magic, the same magic at every viscosity.
/// throws Error(bad_input) unless nu is in range and magic > 0
TrtRates<> trt_rates(double nu, double magic = exact_wall_magic);

/// The rates of MRT that make it the TRT of the same viscosity and magic number: even kinds even, odd kinds odd.
MrtRates<> mrt_rates_of_trt(const TrtRates<>& rates);

/// Shear rate from nu; `bulk` for e, `ghost` for eps, q, pi, m. ESPResSo's default is bulk = ghost = 1: then walls and
/// interfaces are exact at nu = 1/8 only, (1/omega - 1/2)/2 = 3/2 nu being the magic number.
/// throws Error(bad_input) unless nu is in range and 0 < bulk, ghost < 2
MrtRates<> mrt_rates(double nu, double bulk, double ghost);

}  // namespace rouleau
