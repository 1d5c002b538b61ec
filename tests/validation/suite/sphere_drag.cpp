// SPDX-License-Identifier: BSD-3-Clause
// Drag of a cubic array of spheres: the hydrodynamic radius of each kernel.
#include <fmt/format.h>

#include "case_file.hpp"
#include "cases.hpp"
#include "fixed_sphere.hpp"

namespace rouleau::validation {
namespace {

constexpr const char* hasimoto = "[Hasimoto1959]";
constexpr double velocity = 1e-4;

struct Sphere {
  double radius;
  int box;
};

}  // namespace

void sphere_drag(Suite& suite) {
  CaseFile file(suite.places().studies / "sphere_drag.ini");
  const double nu = file.number("fluid", "viscosity"), radius = file.number("sphere", "radius");
  const std::vector<double> boxes = file.numbers("sphere", "boxes"), other_radii = file.numbers("other", "radii"),
                            other_boxes = file.numbers("other", "boxes");
  file.require_all_used();
  std::vector<Sphere> spheres;
  for (const double box : boxes) spheres.push_back({radius, static_cast<int>(box)});
  for (std::size_t i = 0; i < other_radii.size(); ++i)
    spheres.push_back({other_radii[i], static_cast<int>(other_boxes.at(i))});

  std::vector<double> fitted;  // excess of the first sphere, one a kernel
  for (const Kernel kernel : {Kernel::two_point, Kernel::three_point, Kernel::four_point}) {
    double excess = 0;
    for (const Sphere& s : spheres) {
      FixedSphere sphere(kernel, s.radius, s.box, nu, velocity);
      const double force = sphere.settled_force();
      const double own = hydrodynamic_radius(force, nu, velocity, s.box) - s.radius;
      const std::string what = fmt::format("{}, a = {:g} dx, phi {:.3g}", kernel_name(kernel), s.radius,
                                           4.18879 * std::pow(s.radius / s.box, 3));
      if (&s == &spheres.front()) {
        excess = own;
        suite.figure(what + ": excess of the hydrodynamic radius, dx", own);
        suite.check(what + ": slip of the vertices / U", sphere.slip(), at_most(0.01), "no slip");
        continue;
      }
      const double fit = s.radius + excess;
      suite.check(what + ": drag / that of the radius fitted at the first phi",
                  force / (6 * std::numbers::pi * nu * fit * velocity * hasimoto_factor(fit, s.box)),
                  near_relative(1, 0.02), hasimoto, fmt::format("excess here {:.3f} dx", own));
    }
    fitted.push_back(excess);
  }
  for (std::size_t k = 1; k < fitted.size(); ++k)
    suite.check(fmt::format("excess of the {}-point over the {}-point kernel, dx", k + 2, k + 1),
                fitted[k] - fitted[k - 1], between(0, 0.5), "the wider kernel is the larger sphere");
}

}  // namespace rouleau::validation
