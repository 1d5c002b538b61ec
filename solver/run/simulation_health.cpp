// SPDX-License-Identifier: BSD-3-Clause
// Whether the state still means something: what would otherwise run on for weeks as nonsense ends the run here.
#include <cmath>

#include "base/error.hpp"
#include "fluid/flow_rate.hpp"
#include "membrane/measures.hpp"
#include "run/coupled_simulation.hpp"
#include "run/safe_combinations.hpp"

namespace rouleau {

template <class Real>
void CoupledSimulation<Real>::check_health() {
  comm_.all_agree([&] { check_flow(); });
  comm_.all_agree([&] { check_cells(); });

  if (!tracker_) return;
  const BoundsParameters& bounds = setup_.run.parameters.bounds;
  double volume_sum = 0;
  for (std::size_t c = 0; c < cells_.ranges.size(); ++c) volume_sum += volume(cells_, c);
  const double ratio = static_cast<double>(inside_nodes()) / volume_sum;
  if (!(ratio >= bounds.inside_ratio_min && ratio <= bounds.inside_ratio_max))
    fail(
        Exit::physics,
        "the flagged nodes fill {:.3f} of the cells' volume, outside of [{}, {}] (bounds.inside_ratio_min/max); cell 0 "
        "is {}. Try a finer mesh (cell.subdivisions), a smaller correction_interval or a smaller time_step_us",
        ratio, bounds.inside_ratio_min, bounds.inside_ratio_max, place_of(cells_, 0));
}

template <class Real>
void CoupledSimulation<Real>::check_flow() const {
  const double max_mach = setup_.run.parameters.bounds.max_mach;
  const double limit = max_mach / std::sqrt(3.0);
  const SpeedCheck speed = check_speed(fluid_, limit);
  if (!speed.first_bad) return;
  const double mach = speed.bad_speed * std::sqrt(3.0);
  const std::string what = !std::isfinite(mach) || !std::isfinite(speed.bad_rho)
                               ? fmt::format("the flow is not finite (density {}, Mach {})", speed.bad_rho, mach)
                           : mach > max_mach
                               ? fmt::format("the velocity is Mach {:.3g}, above {} (bounds.max_mach)", mach, max_mach)
                               : fmt::format("the density is {:.3g} of the mean, outside of 0 to 2", speed.bad_rho);
  const Int3& n = *speed.first_bad;
  fail(Exit::physics, "at node ({}, {}, {}) {}. Try a smaller time_step_us", n[0], n[1], n[2], what);
}

template <class Real>
void CoupledSimulation<Real>::check_cells() {
  if (const auto fault = mesh_health_.find_fault(cells_))
    fail(Exit::physics, "cell {}, triangle {}: {}. {}", fault->cell, fault->triangle, fault->what,
         mesh_remedy(setup_.run.parameters));
  const BoundsParameters& bounds = setup_.run.parameters.bounds;
  for (std::size_t c = 0; c < cells_.ranges.size(); ++c) {
    const double ratio = area(cells_, c) / cells_.ranges[c].area_0;
    if (!(ratio >= bounds.area_ratio_min && ratio <= bounds.area_ratio_max))
      fail(Exit::physics,
           "cell {} {}: its area is {:.4f} of the area at rest, outside of [{}, {}] (bounds.area_ratio_min/max). {}", c,
           place_of(cells_, c), ratio, bounds.area_ratio_min, bounds.area_ratio_max,
           mesh_remedy(setup_.run.parameters));
  }
}

template void CoupledSimulation<float>::check_health();
template void CoupledSimulation<double>::check_health();
template void CoupledSimulation<float>::check_flow() const;
template void CoupledSimulation<double>::check_flow() const;
template void CoupledSimulation<float>::check_cells();
template void CoupledSimulation<double>::check_cells();

}  // namespace rouleau
