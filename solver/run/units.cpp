// SPDX-License-Identifier: BSD-3-Clause
#include "run/units.hpp"

#include <cmath>

namespace rouleau {

Units::Units(const RunParameters& parameters)
    : dx_um_(parameters.numerics.node_spacing_um),
      dt_us_(parameters.numerics.time_step_us),
      dx_m_(dx_um_ * 1e-6),
      dt_s_(dt_us_ * 1e-6) {
  const double viscosity_Pa_s = parameters.fluid.plasma_viscosity_mPa_s * 1e-3;
  density_ = viscosity_Pa_s * dt_s_ / (viscosity_from_tau(parameters.numerics.tau_plasma) * dx_m_ * dx_m_);
  speed_m_per_s_ = dx_m_ / dt_s_;
  tension_N_per_m_ = density_ * dx_m_ * speed_m_per_s_ * speed_m_per_s_;
  energy_J_ = tension_N_per_m_ * dx_m_ * dx_m_;
  force_density_ = density_ * dx_m_ / (dt_s_ * dt_s_);
}

std::int64_t Units::steps(double time_s) const {
  const double steps = time_s / dt_s_;
  const double nearest = std::round(steps);
  return static_cast<std::int64_t>(std::abs(steps - nearest) <= 1e-6 ? nearest : std::ceil(steps));
}

}  // namespace rouleau
