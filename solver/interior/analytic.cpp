// SPDX-License-Identifier: BSD-3-Clause
#include "interior/analytic.hpp"

#include "interior/image_nodes.hpp"
#include "membrane/shape_equations.hpp"

namespace rouleau {
namespace {

bool is_inside(const Body& body, const Vec3& point) {
  const Vec3 own = body.rotation.transpose() * (point - body.centre);
  switch (body.shape) {
    case Body::Shape::ellipsoid:
      return inside_ellipsoid(own, body.radii);
    case Body::Shape::red_blood_cell:
      break;
  }
  return inside_red_blood_cell(own, body.radii[0]);
}

}  // namespace

void flag_bodies(std::span<const Body> bodies, const Lattice& lattice, const Block& block, Flags& flags) {
  clear_owned(flags);
  for (const Body& body : bodies) {
    const Vec3 reach = Vec3::Constant(body.radii.maxCoeff());
    const ImageBox box{body.centre - reach, body.centre + reach};
    for_each_image(box, lattice, block, [&](int i, int j, int k, const Vec3& position) {
      if (is_inside(body, position)) flags(i, j, k) = 1;
    });
  }
}

}  // namespace rouleau
