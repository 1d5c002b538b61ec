// SPDX-License-Identifier: BSD-3-Clause
// The only place that converts between the user's units and lattice units (node spacing 1, time step 1, density 1).
#pragma once

#include <cstdint>

#include "run/parameters.hpp"

namespace rouleau {

/// nu = (tau - 1/2) / 3, and back. Both fluids pass through the same function, so that lambda = 1 gives them the same
/// bits.
constexpr double viscosity_from_tau(double tau) { return (tau - 0.5) / 3.0; }
constexpr double tau_from_viscosity(double nu) { return 3.0 * nu + 0.5; }

/// The unit system of a run. Spacing, step and lattice viscosity fix an effective density
/// rho_eff = mu dt / (nu_out dx^2): the Reynolds number is rho_eff / rho times the physical one.
class Units {
 public:
  explicit Units(const RunParameters& parameters);

  [[nodiscard]] double dx_um() const { return dx_m_ * 1e6; }
  [[nodiscard]] double dt_us() const { return dt_us_; }
  [[nodiscard]] double effective_density_kg_per_m3() const { return density_; }

  // user's units -> lattice
  [[nodiscard]] double length(double um) const { return um / dx_um_; }
  /// Node coordinate of a point at this distance from the lower face of the box, which lies at -1/2.
  [[nodiscard]] double coordinate(double um) const { return um / dx_um_ - 0.5; }
  [[nodiscard]] double speed(double mm_per_s) const { return mm_per_s * 1e-3 / speed_m_per_s_; }
  [[nodiscard]] double rate(double per_s) const { return per_s * dt_s_; }
  [[nodiscard]] double tension(double uN_per_m) const { return uN_per_m * 1e-6 / tension_N_per_m_; }
  [[nodiscard]] double force(double pN) const { return pN * 1e-12 / (tension_N_per_m_ * dx_m_); }
  [[nodiscard]] double energy(double joule) const { return joule / energy_J_; }
  [[nodiscard]] double force_density(double Pa_per_m) const { return Pa_per_m / force_density_; }
  /// Steps after which the run has reached this time: the next whole number, or the nearest within 1e-6.
  [[nodiscard]] std::int64_t steps(double time_s) const;

  // lattice -> user's units
  [[nodiscard]] double length_um(double length) const { return length * dx_um_; }
  [[nodiscard]] double coordinate_um(double coordinate) const { return (coordinate + 0.5) * dx_um_; }
  [[nodiscard]] double area_um2(double area) const { return area * dx_um_ * dx_um_; }
  [[nodiscard]] double volume_um3(double volume) const { return volume * dx_um_ * dx_um_ * dx_um_; }
  [[nodiscard]] double speed_mm_per_s(double speed) const { return speed * speed_m_per_s_ * 1e3; }
  [[nodiscard]] double rate_per_s(double rate) const { return rate / dt_s_; }
  [[nodiscard]] double tension_uN_per_m(double tension) const { return tension * tension_N_per_m_ * 1e6; }
  [[nodiscard]] double force_pN(double force) const { return force * tension_N_per_m_ * dx_m_ * 1e12; }
  [[nodiscard]] double energy_joule(double energy) const { return energy * energy_J_; }
  [[nodiscard]] double pressure_Pa(double pressure) const { return pressure * tension_N_per_m_ / dx_m_; }
  [[nodiscard]] double force_density_pN_per_um3(double force_density) const {
    return force_density * force_density_ * 1e-6;
  }
  [[nodiscard]] double curvature_per_um(double curvature) const { return curvature / dx_um_; }
  [[nodiscard]] double pressure_gradient_Pa_per_m(double force_density) const { return force_density * force_density_; }
  [[nodiscard]] double time_s(std::int64_t step) const { return static_cast<double>(step) * dt_us_ * 1e-6; }

 private:
  double dx_um_, dt_us_, dx_m_, dt_s_;
  double density_;        // of one lattice unit, kg/m^3
  double speed_m_per_s_;  // of one lattice unit, like those below
  double tension_N_per_m_;
  double energy_J_;
  double force_density_;  // N/m^3
};

}  // namespace rouleau
