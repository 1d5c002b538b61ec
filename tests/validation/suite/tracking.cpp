// SPDX-License-Identifier: BSD-3-Clause
// The flag lattice against ray casting: at rest, and on cells that flow, by variant and correction interval.
#include <fmt/format.h>

#include <numbers>
#include <random>

#include "campaign_run.hpp"
#include "cases.hpp"
#include "live_flags.hpp"
#include "membrane/shapes.hpp"
#include "membrane/transform.hpp"
#include "unit/membrane/sample_cells.hpp"

namespace rouleau::validation {
namespace {

constexpr const char* ray_casting = "ray casting";
constexpr const char* mesh_volume = "volume of the mesh";

/// The paper's cell at dx = 1/3 um, at rest.
testing::TrackingDifference difference_at_rest(const Vec3& axis, double angle, const Vec3& centre) {
  const Lattice lattice{{40, 40, 40}, {true, true, true}};
  Surface surface = red_blood_cell(4, 12);
  rotate(surface, axis, angle);
  translate(surface, centre);
  const Cells cells = test::one_cell(surface);
  Follower follower(Tracking::vertex_normals, 0, lattice, cells);
  follower.follow(cells, 1);
  return follower.difference(cells);
}

void check_at_rest(Suite& suite) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> in(-1, 1);
  const auto anywhere = [&] { return Vec3(in(random), in(random), in(random)); };
  for (const bool is_tilted : {true, false}) {
    Worst worst;
    for (int pose = 0; pose < 6; ++pose) {
      const Vec3 axis = is_tilted ? anywhere() : Vec3(0, 1, 0);
      const double angle = is_tilted ? 3 * in(random) : 0.5 * std::numbers::pi * (pose % 2);
      worst.see(difference_at_rest(axis, angle, Vec3::Constant(20) + anywhere()), false);
    }
    const std::string poses = is_tilted ? "at rest, six poses" : "at rest, disc axis along x or z, six places";
    suite.check(poses + ": wrong flags / shell", worst.wrong_share, at_most(0.01), ray_casting);
    const std::string note = fmt::format("ray casting itself {:.2g}", worst.cast_volume_error);
    if (is_tilted)
      suite.check(poses + ": |N_in / V - 1|", worst.volume_error, at_most(0.01), mesh_volume, note);
    else  // told, not judged: the poses that are worst for counting nodes
      suite.figure(poses + ": |N_in / V - 1|", worst.volume_error, note);
  }
}

std::string also(const Worst& worst) {
  return fmt::format(
      "count off that of ray casting by {:.2g} V (mean {:+.2g}), farther than 2 dx: {} nodes, after a correction {}; "
      "{} flips "
      "in {} corrections",
      worst.count_error, worst.mean_count_error(), worst.far_away, worst.far_away_at_correction, worst.flips,
      worst.corrections);
}

/// What the simulation's own flags, and those of other variants on the same meshes, were at worst.
struct RunFindings {
  std::int64_t interval = 0;  ///< of its own corrections
  Worst own;
  std::vector<Follower> others;
};

RunFindings follow_run(const CampaignPoint& point) {
  LiveRun run(point.directory / "run.ini");
  const RunParameters& parameters = run.setup().run.parameters;
  RunFindings found{parameters.numerics.correction_interval, {}, {}};
  for (const std::int64_t other : {std::int64_t{50}, 10 * found.interval, std::int64_t{0}})
    found.others.emplace_back(Tracking::face_normals, other, run.lattice(), run.cells());
  for (const Tracking variant : {Tracking::vertex_normals, Tracking::vertex_normals_wide})
    found.others.emplace_back(variant, found.interval, run.lattice(), run.cells());

  run.run([&](std::int64_t step) {
    for (Follower& other : found.others) other.follow(run.cells(), step);
    if (step % parameters.output.sample_interval_steps != 0) return;
    found.own.see(own_difference(run), step % found.interval == 0);
    found.own.corrections = step / found.interval;
    for (Follower& other : found.others) other.look(run.cells(), step);
  });
  found.own.flips = run.simulation().flips();
  return found;
}

void judge(Suite& suite, const std::string& what, const Worst& own) {
  suite.check(what + ": wrong flags / shell, at most", own.wrong_share, at_most(0.02), ray_casting, also(own));
  suite.check(what + ": flags more or less than ray casting / V, at most", own.count_error, at_most(0.01), ray_casting);
  // Exact flags do not hold this limit either: planes of nodes pass flat parts of the membrane at once.
  suite.check(what + ": |N_in / V - 1|, at most", own.volume_error, at_most(0.01), mesh_volume,
              fmt::format("ray casting itself {:.2g}", own.cast_volume_error));
  suite.check(what + ": wrong flags farther than 2 dx after a correction",
              static_cast<double>(own.far_away_at_correction), at_most(0), ray_casting);
}

void report_run(Suite& suite, const CampaignPoint& point, const std::string& study, bool is_judged) {
  const RunFindings found = follow_run(point);
  const std::string name = fmt::format("{}, {}", study, point.text("swept"));
  const std::string own = fmt::format("{}: face normals, corrected every {} steps", name, found.interval);
  if (is_judged)
    judge(suite, own, found.own);
  else
    suite.figure(own + ": wrong flags / shell, at most", found.own.wrong_share, also(found.own));
  for (const Follower& other : found.others) {
    const std::string what = fmt::format("{}: {}", name, other.name());
    if (is_judged && other.variant() == Tracking::vertex_normals)
      judge(suite, what, other.worst());
    else
      suite.figure(what + ": wrong flags / shell, at most", other.worst().wrong_share, also(other.worst()));
  }
}

}  // namespace

void tracking(Suite& suite) {
  check_at_rest(suite);
  for (const char* study : {"tracking_channel", "tracking_shear"})
    for (const CampaignPoint& point : make_campaign(suite.places(), study)) report_run(suite, point, study, true);
  for (const CampaignPoint& point : make_campaign(suite.places(), "tracking_coarse"))
    report_run(suite, point, "tracking_coarse", false);
}

}  // namespace rouleau::validation
