// SPDX-License-Identifier: BSD-3-Clause
// How a membrane is stretched and bent at each of its vertices: what a picture of it is coloured by.
#pragma once

#include <vector>

#include "membrane/cells.hpp"

namespace rouleau {

/// [vertices] each, lattice units.
struct LocalState {
  /// Area of the triangles around a vertex over that of the same triangles at rest, minus 1.
  std::vector<double> area_strain;
  /// Mean of the two principal tensions of the in-plane law, weighted by the areas of the triangles around a vertex:
  /// the energy that an isotropic dilation costs, per area that it adds. Positive where the membrane is pulled.
  std::vector<double> tension;
  /// H, by the same discrete Laplacian and areas as the bending energy; positive on a sphere: 1 / R.
  std::vector<double> mean_curvature;
};

/// reads   cells.X, cells.X_reference and the topology
LocalState local_state(const Cells& cells, const Moduli& moduli);

}  // namespace rouleau
