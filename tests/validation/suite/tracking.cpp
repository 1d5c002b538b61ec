// SPDX-License-Identifier: BSD-3-Clause
// The flag lattice against ray casting: at rest, and on cells that flow, by variant and correction interval.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "campaign_run.hpp"
#include "cases.hpp"
#include "follower.hpp"
#include "live_run.hpp"
#include "membrane/shapes.hpp"
#include "membrane/transform.hpp"
#include "unit/membrane/sample_cells.hpp"

namespace rouleau::validation {
namespace {

constexpr const char* ray_casting = "ray casting";
constexpr const char* mesh_volume = "volume of the mesh";

/// The paper's cell at dx = 1/3 um, at rest.
Worst look_at_rest(const Vec3& axis, double angle, const Vec3& centre) {
  const Lattice lattice{{40, 40, 40}, {true, true, true}};
  Surface surface = red_blood_cell(4, 12);
  rotate(surface, axis, angle);
  translate(surface, centre);
  const Cells cells = test::one_cell(surface);
  Follower follower(Tracking::vertex_normals, 0, lattice, cells);
  follower.follow(cells, 1);
  follower.look(cells, 1);
  return follower.worst();
}

void check_at_rest(Suite& suite) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in(-1, 1);
  const auto anywhere = [&] { return Vec3(in(random), in(random), in(random)); };
  for (const bool is_tilted : {true, false}) {
    double wrong = 0, volume = 0, cast = 0;
    for (int pose = 0; pose < 6; ++pose) {
      const Vec3 axis = is_tilted ? anywhere() : Vec3(0, 1, 0);
      const double angle = is_tilted ? 3 * in(random) : 1.5707963267948966 * (pose % 2);
      const Worst worst = look_at_rest(axis, angle, Vec3::Constant(20) + anywhere());
      wrong = std::max(wrong, worst.wrong_share);
      volume = std::max(volume, worst.volume_error);
      cast = std::max(cast, worst.cast_volume_error);
    }
    const std::string poses = is_tilted ? "at rest, six poses" : "at rest, disc axis along x or z, six places";
    suite.check(poses + ": wrong flags / shell", wrong, at_most(0.01), ray_casting);
    const std::string note = fmt::format("ray casting itself {:.2g}", cast);
    if (is_tilted)
      suite.check(poses + ": |N_in / V - 1|", volume, at_most(0.01), mesh_volume, note);
    else  // whole planes of nodes pass the flat faces at once
      suite.figure(poses + ": |N_in / V - 1|", volume, note);
  }
}

/// The flags that the simulation itself uses.
testing::TrackingDifference own_difference(LiveRun& run) {
  const PersistentState state = run.simulation().persistent();
  const auto flags = std::find_if(state.lattice_items.begin(), state.lattice_items.end(),
                                  [](const LatticeItem& item) { return item.name == "interior/flags"; });
  require(flags != state.lattice_items.end(), "the state has no flags");
  const auto* tracked = static_cast<const std::uint8_t*>(flags->data[0]);
  return testing::tracking_difference([&](int i, int j, int k) { return tracked[flags->layout.index(i, j, k)]; },
                                      run.cells(), run.lattice());
}

std::string also(const Worst& worst) {
  return fmt::format(
      "|N_in / V - 1| {:.2g} (ray casting itself {:.2g}), farther than 2 dx: {} nodes, after a correction {}; {} flips "
      "in {} "
      "corrections",
      worst.volume_error, worst.cast_volume_error, worst.far_away, worst.far_away_at_correction, worst.flips,
      worst.corrections);
}

void check_run(Suite& suite, const CampaignPoint& point, const std::string& name) {
  LiveRun run(point.directory / "run.ini");
  const NumericsParameters& numerics = run.setup().run.parameters.numerics;
  const std::int64_t look_interval = run.setup().run.parameters.output.sample_interval_steps;
  const std::int64_t interval = numerics.correction_interval;
  Worst own;
  std::vector<Follower> others;
  for (const std::int64_t other : {std::int64_t{50}, 10 * interval, std::int64_t{0}})
    others.emplace_back(Tracking::vertex_normals, other, run.lattice(), run.cells());
  for (const Tracking variant : {Tracking::vertex_normals_wide, Tracking::face_normals})
    others.emplace_back(variant, interval, run.lattice(), run.cells());

  run.run([&](std::int64_t step) {
    for (Follower& other : others) other.follow(run.cells(), step);
    if (step % look_interval != 0) return;
    own.see(own_difference(run), step % interval == 0);
    own.corrections = step / interval;
    for (Follower& other : others) other.look(run.cells(), step);
  });
  own.flips = run.simulation().flips();

  const std::string what = fmt::format("{}: vertex normals, corrected every {} steps", name, interval);
  suite.check(what + ": wrong flags / shell, at most", own.wrong_share, at_most(0.02), ray_casting, also(own));
  suite.check(what + ": |N_in / V - 1|, at most", own.volume_error, at_most(0.01), mesh_volume);
  suite.check(what + ": wrong flags farther than 2 dx after a correction",
              static_cast<double>(own.far_away_at_correction), at_most(0), ray_casting);
  for (const Follower& other : others)
    suite.figure(fmt::format("{}: {}: wrong flags / shell, at most", name, other.name()), other.worst().wrong_share,
                 also(other.worst()));
}

}  // namespace

void tracking(Suite& suite) {
  check_at_rest(suite);
  for (const char* study : {"tracking_channel", "tracking_shear"})
    for (const CampaignPoint& point : make_campaign(suite.places(), study))
      check_run(suite, point, fmt::format("{}, {}", study, point.text("swept")));
}

}  // namespace rouleau::validation
