// SPDX-License-Identifier: BSD-3-Clause
#include "targets.hpp"

#include <fmt/format.h>

#include <limits>

namespace rouleau::speed {

std::vector<Target> targets(const Series& series) {
  std::vector<Target> result;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto add = [&](const std::string& figure, double low, double high, const std::string& text) {
    if (series.has(figure)) result.push_back({figure, low, high, series.median(figure), text});
  };
  const auto at_least = [&](const std::string& figure, double limit) {
    add(figure, limit, infinity, fmt::format(">= {}", limit));
  };
  const auto at_most = [&](const std::string& figure, double limit) {
    add(figure, -infinity, limit, fmt::format("<= {}", limit));
  };
  const auto about = [&](const std::string& figure, double value, double tolerance) {
    add(figure, value - tolerance, value + tolerance, fmt::format("{} +- {}", value, tolerance));
  };
  at_least("fluid_over_attainable_single", 0.55);
  at_least("fluid_over_attainable_double", 0.55);
  at_most("fluid_bytes_over_needed_single", 1.1);
  at_most("fluid_bytes_over_needed_double", 1.1);
  at_most("coupled_over_fluid_2pt_single", 1.35);
  at_most("coupled_over_fluid_4pt_single", 1.7);
  at_most("coupled_ms_4pt_single", 1.85);
  at_most("core_hours_large_step", 2.4);
  at_most("tracking_share", 0.07);
  at_most("correction_share", 0.01);
  at_most("volume_share", 0.03);
  at_most("sampling_share", 0.01);
  at_most("checkpoint_share", 0.01);
  at_least("two_rank_speedup", 1.75);
  at_least("two_jobs_throughput", 1.8);
  about("tracking_exponent", 2, 0.2);
  about("shell_raycast_exponent", 4, 0.4);
  about("full_raycast_exponent", 5, 0.4);
  return result;
}

}  // namespace rouleau::speed
