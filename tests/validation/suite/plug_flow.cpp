// SPDX-License-Identifier: BSD-3-Clause
// A cell in a uniform flow through a periodic box sees nothing of it: as at rest, flags and all.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "campaign_run.hpp"
#include "cases.hpp"
#include "live_flags.hpp"
#include "membrane/measures.hpp"

namespace rouleau::validation {
namespace {

constexpr const char* galilean = "Galilean invariance";
constexpr double slow_mm_per_s = 1e-3;  // below it the study's point is the one at rest

/// What a number of nodes went through.
struct Range {
  double low = 1e300, high = 0;

  void see(std::int64_t count) {
    low = std::min(low, static_cast<double>(count));
    high = std::max(high, static_cast<double>(count));
  }
  /// +- of its middle
  [[nodiscard]] double share() const { return (high - low) / (high + low); }
};

struct Ride {
  double mm_per_s = 0, path = 0;  ///< path in periods of the box
  CellMeasures at_end;
  VectorArray X;  ///< at the end, relative to the mean of the vertices
  Worst flags;
  Range count, cast_count;  ///< of inside nodes; the latter by ray casting
};

Ride ride(const CampaignPoint& point) {
  LiveRun run(point.directory / "run.ini");
  const std::int64_t interval = run.setup().run.parameters.numerics.correction_interval;
  const std::int64_t look_interval = run.setup().run.parameters.output.sample_interval_steps;
  const auto unwrapped = [&] {
    return centre_of_mass(run.cells(), 0)[0] + run.cells().images[0][0] * run.lattice().size[0];
  };
  Ride result;
  result.mm_per_s = point.number("initial_velocity_mm_per_s");
  const double start = unwrapped();
  run.run([&](std::int64_t step) {
    if (step % look_interval != 0) return;
    const testing::TrackingDifference difference = own_difference(run);
    result.flags.see(difference, step % interval == 0);
    result.count.see(difference.inside + difference.excess);
    result.cast_count.see(difference.inside);
  });
  result.path = (unwrapped() - start) / run.lattice().size[0];
  result.at_end = measure(run.cells(), 0);
  result.X = VectorArray(run.cells().vertices());
  for (std::size_t v = 0; v < result.X.size(); ++v) set(result.X, v, at(run.cells().X, v) - result.at_end.vertex_mean);
  return result;
}

double largest_distance(const VectorArray& a, const VectorArray& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (at(a, v) - at(b, v)).norm());
  return largest;
}

}  // namespace

void plug_flow(Suite& suite) {
  std::map<std::string, Ride> at_rest;  // by pose
  for (const CampaignPoint& point : make_campaign(suite.places(), "plug_flow")) {
    const Ride now = ride(point);
    const std::string pose = fmt::format("disc turned by {:g} deg", point.number("rotation_angle_deg"));
    if (now.mm_per_s < slow_mm_per_s) {
      at_rest[pose] = now;
      continue;
    }
    const std::string what = fmt::format("{}, {:.1f} periods of the box", pose, now.path);
    const Ride& rest = at_rest.at(pose);
    suite.check(what + ": asphericity against the cell at rest", now.at_end.asphericity,
                near_relative(rest.at_end.asphericity, 0.01), galilean);
    suite.check(what + ": area / A0 against the cell at rest", now.at_end.area_ratio,
                near_relative(rest.at_end.area_ratio, 0.001), galilean);
    suite.figure(what + ": largest displacement of a vertex against the cell at rest, dx",
                 largest_distance(now.X, rest.X));
    suite.check(what + ": flags more or less than ray casting / V", now.flags.count_error, at_most(0.01), "ray casting",
                fmt::format("ray casting itself is off V by {:.2g}", now.flags.cast_volume_error));
    suite.check(what + ": number of flags, +- of its middle", now.count.share(), at_most(0.01), galilean,
                fmt::format("by ray casting {:.2g}", now.cast_count.share()));
    suite.check(what + ": wrong flags / shell", now.flags.wrong_share, at_most(0.02), "ray casting");
    suite.check(what + ": nodes of a tail, right after a correction",
                static_cast<double>(now.flags.far_away_at_correction), at_most(0), "ray casting");
  }
}

}  // namespace rouleau::validation
