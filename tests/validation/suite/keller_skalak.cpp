// SPDX-License-Identifier: BSD-3-Clause
// A tank-treading capsule against the ellipsoid of Keller and Skalak: angle, frequency, and where tumbling begins.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "capsule_point.hpp"
#include "cases.hpp"
#include "keller_skalak_theory.hpp"
#include "run/value_text.hpp"

namespace rouleau::validation {
namespace {

/// What a value tends to as the radius in nodes grows, if its error falls as 1 / radius, as that of a spread interface.
double without_kernel(double coarse_radius, double coarse_value, double fine_radius, double fine_value) {
  return (fine_radius * fine_value - coarse_radius * coarse_value) / (fine_radius - coarse_radius);
}

constexpr const char* formula = "Keller, Skalak 1982, with the axes that the capsule has";
constexpr double angle_limit_deg = 4, rate_share = 0.1, critical_share = 0.2;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// The membrane as it goes around steadily, over the last half turn of a run: what the shape goes through within it
/// comes again in the next.
struct TankTreading {
  double nodes, lambda;
  double angle_deg;
  double rate;     ///< of the membrane's phase / gamma
  Vec3 semi_axes;  ///< um, of the ellipsoid with the volume's second moments
};

/// Angle of the marker about the ellipse after it was pressed to a circle, which Keller and Skalak's membrane covers
/// evenly.
double phase(const CampaignPoint& point, std::size_t i) {
  const double angle = point.series("angle_xz_deg")[i] * std::numbers::pi / 180;
  const double x = point.series("marker_z_dx_um")[i], z = point.series("marker_z_dz_um")[i];
  const double D = point.series("taylor_deformation")[i], ratio = (1 - D) / (1 + D);
  return std::atan2((z * std::cos(angle) - x * std::sin(angle)) / ratio, x * std::cos(angle) + z * std::sin(angle));
}

/// Whether the long axis went past the vertical. A steady one lies between the flow and the axis of strain.
bool tumbles(const CampaignPoint& point) {
  const std::vector<double>& angle_deg = point.series("angle_xz_deg");
  double turned_deg = 0;
  for (std::size_t i = 1; i < angle_deg.size(); ++i) {
    turned_deg += std::remainder(angle_deg[i] - angle_deg[i - 1], 180);
    if (turned_deg < -90) return true;
  }
  return false;
}

TankTreading tank_treading_of(const CampaignPoint& point) {
  const CapsulePoint capsule(point);
  TankTreading result{point.number("node_spacing_um"), capsule.lambda(), 0, 0, Vec3::Zero()};
  const std::vector<double>& time_s = point.series("time_s");
  const std::size_t end = time_s.size();
  std::size_t begin = end - 1;
  double D = 0, width_um = 0, turned = 0;
  for (; std::abs(turned) < std::numbers::pi; --begin) {
    if (begin == 0)
      fail(Exit::bad_input, "{}: the membrane made no half turn; let it run longer", point.directory.string());
    result.angle_deg += point.series("angle_xz_deg")[begin];
    D += point.series("taylor_deformation")[begin];
    width_um += point.series("extent_y_um")[begin];
    turned += std::remainder(phase(point, begin) - phase(point, begin - 1), 2 * std::numbers::pi);
  }
  ++begin;  // the samples from here to the end were summed
  const auto samples = static_cast<double>(end - begin);
  result.angle_deg /= samples;
  result.rate = std::abs(turned) / (point.number("shear_rate_per_s") * (time_s.back() - time_s[begin - 1]));
  const Vec3 start = parse_vector(point.text("semi_axes_um"));
  const double ratio = (1 - D / samples) / (1 + D / samples), third = 0.5 * width_um / samples;
  const double longer = std::sqrt(start.prod() / (ratio * third));  // the volume is kept
  result.semi_axes = {longer, ratio * longer, third};
  result.nodes = longer / result.nodes;
  return result;
}

void check_formula(Suite& suite) {
  for (const auto& [axes, critical] :
       {std::pair(Vec3(1, 0.9, 1), 24.401), std::pair(Vec3(1, 0.8, 0.8), 12.626), std::pair(Vec3(4, 1.3, 4), 3.162)})
    suite.check(fmt::format("formula: critical lambda of {}:{}:{}", axes[0], axes[1], axes[2]),
                KellerSkalak(axes).critical_lambda(), near(critical, 5e-4), "computed independently");
  const Vec3 axes(1, 0.5, 0.5);
  const KellerSkalak::Steady steady = *KellerSkalak(axes).steady(1);
  suite.check("formula: tan of the angle at lambda 1, 1:0.5:0.5", std::tan(steady.angle_rad), near(0.5, 1e-6),
              "closed form: a2/a1");
  suite.check("formula: membrane rate at lambda 1, 1:0.5:0.5", steady.membrane_rate, near(0.4, 1e-6),
              "closed form: r/(1 + r^2)");
}

/// Whole turns as a campaign counts them, against the rate of the phase and the formula.
void check_recorded_measure(Suite& suite) {
  for (const CampaignPoint& point : run_campaign(suite.places(), "keller_skalak_turn")) {
    const TankTreading found = tank_treading_of(point);
    const double per_s = found.rate * point.number("shear_rate_per_s") / (2 * std::numbers::pi);
    // The marker need not pass the long and the short sides equally often in what the rate was taken over.
    suite.check("tank_treading_per_s of the campaign, lambda 1", point.number("tank_treading_per_s"),
                near_relative(per_s, 0.05), "rate of the marker's phase", point.text("tank_treading_reason"));
    const KellerSkalak::Steady theory = *KellerSkalak(found.semi_axes).steady(1);
    suite.check(
        "the same against theory, 1/s", point.number("tank_treading_per_s"),
        near_relative(theory.membrane_rate * point.number("shear_rate_per_s") / (2 * std::numbers::pi), rate_share),
        formula);
  }
}

}  // namespace

void keller_skalak(Suite& suite) {
  check_formula(suite);
  check_recorded_measure(suite);

  std::map<double, std::map<double, TankTreading>> found;  // by lambda and nodes
  double steady_up_to = 0, tumbling_from = std::numeric_limits<double>::infinity();
  for (const CampaignPoint& point : run_campaign(suite.places(), "keller_skalak")) {
    const double lambda = CapsulePoint(point).lambda();
    if (tumbles(point)) {
      suite.figure(fmt::format("tumbles: lambda, dx = {:.3g} um", point.number("node_spacing_um")), lambda);
      tumbling_from = std::min(tumbling_from, lambda);
      continue;
    }
    steady_up_to = std::max(steady_up_to, lambda);
    const TankTreading t = tank_treading_of(point);
    found[t.lambda].emplace(t.nodes, t);
    suite.figure(fmt::format("angle, degrees, lambda {}, a1 = {:.3g} dx", t.lambda, t.nodes), t.angle_deg,
                 fmt::format("axes 1:{:.3g}:{:.3g}", t.semi_axes[1] / t.semi_axes[0], t.semi_axes[2] / t.semi_axes[0]));
    suite.figure(fmt::format("membrane rate / gamma, lambda {}, a1 = {:.3g} dx", t.lambda, t.nodes), t.rate);
  }
  suite.check("smallest lambda that tumbles / largest that treads", tumbling_from / steady_up_to, between(1, 2),
              "Keller, Skalak 1982: one transition", fmt::format("between {} and {}", steady_up_to, tumbling_from));
  std::map<double, double> squared_angle;  // at dx/a -> 0, by lambda
  double critical = 0;
  for (const auto& [lambda, by_nodes] : found) {
    if (by_nodes.size() < 2) continue;  // nothing to extrapolate
    const TankTreading &coarse = by_nodes.begin()->second, &fine = by_nodes.rbegin()->second;
    const double angle_deg = without_kernel(coarse.nodes, coarse.angle_deg, fine.nodes, fine.angle_deg);
    const double rate = without_kernel(coarse.nodes, coarse.rate, fine.nodes, fine.rate);
    squared_angle[lambda] = angle_deg * std::abs(angle_deg);
    const KellerSkalak theory(fine.semi_axes);
    critical = theory.critical_lambda();
    const std::optional<KellerSkalak::Steady> steady = theory.steady(lambda);
    if (!steady) {
      suite.figure(fmt::format("angle, degrees, lambda {}: dx/a -> 0", lambda), angle_deg, "theory: it tumbles");
      continue;
    }
    suite.check(fmt::format("angle, degrees, lambda {}: dx/a -> 0", lambda), angle_deg,
                near(degrees(steady->angle_rad), angle_limit_deg), formula);
    suite.check(fmt::format("membrane rate / gamma, lambda {}: dx/a -> 0", lambda), rate,
                near_relative(steady->membrane_rate, rate_share), formula);
  }
  // Near the transition the square of the angle falls like a straight line: it ends at the critical contrast.
  const auto [last, last_square] = *squared_angle.rbegin();
  const auto [before, before_square] = *std::next(squared_angle.rbegin());
  suite.check("critical lambda: dx/a -> 0", last + (last - before) * last_square / (before_square - last_square),
              near_relative(critical, critical_share), formula, fmt::format("from lambda {} and {}", before, last));
}

}  // namespace rouleau::validation
