// SPDX-License-Identifier: BSD-3-Clause
// Rows that the tests of the store share.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "store/store.hpp"

namespace rouleau::campaign::testing {

inline CampaignRow a_campaign() {
  return {"quick", "[study]\nname = quick\n", "0123456789abcdef", 1.7e9, "0.1.0", "abc"};
}

/// Point number `ordinal`, of λ = ordinal.
inline PointRow a_point(int ordinal) {
  PointRow point;
  point.key = fmt::format("{:012x}", 0xabc000 + ordinal);
  point.ordinal = ordinal;
  point.end_step = 1000;
  point.end_time_s = 0.25;
  return point;
}

inline std::vector<ParameterRow> its_parameters(const PointRow& point) {
  const double lambda = point.ordinal;
  return {{"fluid.lambda", fmt::format("{}", lambda), lambda, true}, {"cell.shape", "sphere", std::nullopt, false}};
}

inline SampleRow a_sample(std::int64_t step, double d_um) {
  SampleRow sample;
  sample.step = step;
  sample.time_s = 1e-6 * static_cast<double>(step);
  sample.d_um = d_um;
  sample.asphericity = 0.15;
  sample.inside_nodes = 800;
  return sample;
}

}  // namespace rouleau::campaign::testing
