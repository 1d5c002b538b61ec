// SPDX-License-Identifier: BSD-3-Clause
// The fluid alone on the paper's lattice, beside the attainable rate.
#pragma once

#include <memory>

#include "base/grid.hpp"
#include "series.hpp"

namespace rouleau::speed {

/// One round: `attainable_mlups`, `attainable_gb_per_s`, `fluid_mlups`, `fluid_ms`, each `_single` and `_double`.
class FluidCases {
 public:
  /// Adds `fluid_bytes_per_node` and `fluid_bytes_over_needed`, which no round changes.
  FluidCases(const Lattice& lattice, double enough_s, Series& series);
  ~FluidCases();
  void measure(Series& series);

 private:
  template <class Real>
  struct Case;
  double enough_s_;
  std::unique_ptr<Case<float>> single_;
  std::unique_ptr<Case<double>> double_;
};

}  // namespace rouleau::speed
