// SPDX-License-Identifier: BSD-3-Clause
#include "capsule_point.hpp"

#include <numbers>

#include "base/error.hpp"

namespace rouleau::validation {

namespace {

constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Node spacings by which the hydrodynamic radius exceeds that of the mesh, as sphere_drag finds it at radii of 4 to 8.
double radius_excess(const std::string& kernel) {
  if (kernel == "2-point") return 0.35;
  return kernel == "3-point" ? 0.45 : 0.6;
}

}  // namespace

double CapsulePoint::nodes_per_radius() const {
  return point_->number("radius_um") / point_->number("node_spacing_um");
}

double CapsulePoint::capillary_number() const {
  if (point_->text("shear_modulus_convention") != "G_s")
    fail(Exit::bad_input, "{}: the capsule's modulus is not given as G_s", point_->directory.string());
  const double radius_um =
      point_->number("radius_um") + radius_excess(point_->text("kernel")) * point_->number("node_spacing_um");
  // mPa s um/s = 1e-3 uN/m
  return 1e-3 * point_->number("plasma_viscosity_mPa_s") * point_->number("shear_rate_per_s") * radius_um /
         point_->number("shear_modulus_uN_per_m");
}

double CapsulePoint::strain(std::size_t sample) const {
  return point_->number("shear_rate_per_s") * point_->series("time_s")[sample];
}

double CapsulePoint::at_strain(const std::string& column, double wanted) const {
  const std::vector<double>& values = point_->series(column);
  for (std::size_t i = 1; i < values.size(); ++i)
    if (strain(i) >= wanted) {
      const double share = (wanted - strain(i - 1)) / (strain(i) - strain(i - 1));
      return values[i - 1] + share * (values[i] - values[i - 1]);
    }
  fail(Exit::bad_input, "{}: its samples end before the strain {}", point_->directory.string(), wanted);
}

double CapsulePoint::angle_rad(double strain) const { return radians(at_strain("angle_xz_deg", strain)); }

double CapsulePoint::final_angle_rad() const { return radians(point_->series("angle_xz_deg").back()); }

double CapsulePoint::strain_to_reach(double share) const {
  const std::vector<double>& D = point_->series("taylor_deformation");
  std::size_t sample = 0;
  while (D[sample] < share * D.back()) ++sample;
  return strain(sample);
}

}  // namespace rouleau::validation
