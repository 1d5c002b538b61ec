// SPDX-License-Identifier: BSD-3-Clause
// How the fluid, the tracking and the paper's two ray casts grow with the lattice, the triangles growing as N^2.
#pragma once

#include <memory>
#include <vector>

#include "series.hpp"

namespace rouleau::speed {

/// One round, for each edge N of a cubic lattice with a red blood cell of radius N / 4 and 20 (N / 3)^2 triangles (the
/// paper's cell at N = 48): `sweep.fluid_ms.N`, `sweep.tracking_ms.N`, `sweep.shell_raycast_ms.N`,
/// `sweep.full_raycast_ms.N`, `sweep.column_raycast_ms.N`; and `<name>_exponent` fitted through them.
class SizeSweep {
 public:
  /// `edges`: multiples of 3.
  SizeSweep(const std::vector<int>& edges, double enough_s);
  ~SizeSweep();
  void measure(Series& series);

  /// Planes of nodes that the full cast is measured on.
  static constexpr int measured_planes = 2;

 private:
  struct Size;
  std::vector<std::unique_ptr<Size>> sizes_;
  double enough_s_;
};

}  // namespace rouleau::speed
