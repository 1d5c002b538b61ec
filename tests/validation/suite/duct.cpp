// SPDX-License-Identifier: BSD-3-Clause
// Force-driven flow through the paper's rectangular channel: the series, the lattice against it, and `rouleau` in SI.
#include <fmt/format.h>

#include "../analytic_flows.hpp"
#include "campaign_run.hpp"
#include "case_file.hpp"
#include "cases.hpp"

namespace rouleau::validation {
namespace {

using testing::DuctError;

constexpr const char* series = "series [White, Viscous Fluid Flow, eq. 3-48]";
constexpr const char* independent = "the same series, summed by another program";
constexpr double last_digit = 2e-6;  // of the six that are known, of a sum that was cut
constexpr double flow_share = 2e-3;

struct Law {
  std::string name;
  double nu;
  Collision collision;
};

Law trt(double nu) { return {"TRT 3/16", nu, testing::one_trt(nu)}; }
Law mrt(double nu) {
  return {"MRT, ghost rates 1", nu, TwoFluids<MrtRates<>>{mrt_rates(nu, 1, 1), mrt_rates(nu, 1, 1)}};
}

/// Velocity at a point of the 12 x 10 channel, um from the axis, over the mean.
struct KnownPoint {
  double y_um, z_um, velocity;
};
constexpr KnownPoint known_points[] = {
    {0, 0, 2.088638}, {1.5, 0.8333, 1.936152}, {3, 0, 1.653716}, {0, 2.5, 1.604860}, {5, 4, 0.326344}};

/// Width over height, largest over mean velocity, mean velocity in units of G H^2 / mu.
struct KnownChannel {
  double aspect, peak, mean;
};
constexpr KnownChannel known_channels[] = {
    {1, 2.096256, 0.0351443}, {1.2, 2.088638, 0.04152973}, {2, 1.991797, 0.0571704}, {4, 1.773680, 0.0702032}};

void check_series(Suite& suite) {
  for (const KnownChannel& channel : known_channels) {
    const DevelopedFlow flow(channel.aspect, 1);
    suite.check(fmt::format("u_max / u_mean, aspect ratio {}", channel.aspect), flow.maximum() / flow.mean(),
                near(channel.peak, last_digit), independent);
    suite.check(fmt::format("u_mean / (G H^2 / mu), aspect ratio {}", channel.aspect), flow.mean(),
                near_relative(channel.mean, last_digit), independent);
  }
  const DevelopedFlow paper(12, 10);
  for (const KnownPoint& point : known_points)
    suite.check(fmt::format("u / u_mean at ({}, {:.4g}) um of the 12 x 10 um channel", point.y_um, point.z_um),
                paper.velocity(point.y_um, point.z_um) / paper.mean(), near(point.velocity, last_digit), independent);
}

/// Enough steps for the slowest mode to decay by exp(-30).
int steps_to_settle(double nu, int ny, int nz) {
  constexpr double pi2 = 9.8696;
  return static_cast<int>(30 / (nu * pi2 * (1.0 / (ny * ny) + 1.0 / (nz * nz))));
}

template <class Real>
DuctError error_at(const Law& law, int nz) {
  const int ny = nz * 6 / 5;
  return testing::duct_error<Real>(law.collision, law.nu, ny, nz, steps_to_settle(law.nu, ny, nz));
}

template <class Real>
void check_paper_grid(Suite& suite, const Law& law, const char* precision, int nz) {
  const DuctError error = error_at<Real>(law, nz);
  const std::string where = fmt::format("{}, nu {:.4g}, {}, {} x {}", law.name, law.nu, precision, nz * 6 / 5, nz);
  suite.check(where + ": L2 error of the profile", error.l2, at_most(1e-3), series);
  suite.check(where + ": flow rate / exact", 1 + error.mean, near_relative(1, flow_share), series,
              "0.0011 of it is the midpoint rule of the mean over nodes");
  suite.check(where + ": largest velocity / exact", 1 + error.largest, near_relative(1, flow_share), series);
}

template <class Real>
void check_order(Suite& suite, const Law& law, const char* precision, const std::vector<double>& heights) {
  double coarser = 0, coarser_height = 0;
  for (const double height : heights) {
    const double error = error_at<Real>(law, static_cast<int>(height)).l2;
    const std::string what = fmt::format("{}, nu {:.4g}, {}", law.name, law.nu, precision);
    suite.figure(fmt::format("{}: L2 error, {:g} nodes high", what, height), error);
    if (coarser_height != 0)
      suite.check(fmt::format("{}: order of convergence, {:g} to {:g} nodes", what, coarser_height, height),
                  std::log(coarser / error) / std::log(height / coarser_height), between(1.9, 2.1),
                  "half-way bounce-back is of second order");
    coarser = error;
    coarser_height = height;
  }
}

}  // namespace

void duct(Suite& suite) {
  CaseFile file(suite.places().studies / "duct.ini");
  const double nu = file.number("fluid", "viscosity"), order_nu = file.number("fluid", "viscosity_for_order_of_trt");
  const std::vector<double> heights = file.numbers("channel", "nodes_z");
  const int paper_height = file.integer("channel", "paper_nodes_z");
  file.require_all_used();

  check_series(suite);
  for (const Law& law : {trt(nu), mrt(nu)}) {
    check_paper_grid<double>(suite, law, "double", paper_height);
    check_paper_grid<float>(suite, law, "single", paper_height);
  }
  for (const Law& law : {trt(order_nu), mrt(nu)}) {
    check_order<double>(suite, law, "double", heights);
    check_order<float>(suite, law, "single", heights);
  }
  for (const CampaignPoint& point : run_campaign(suite.places(), "duct_flow_rate"))
    suite.check(
        fmt::format("mean velocity at 4.33424e5 Pa/m, mm/s: {}, {}", point.text("collision"), point.text("precision")),
        point.series("mean_velocity_mm_per_s").back(), near_relative(1.5, flow_share), series,
        "run by rouleau in the paper's units");
}

}  // namespace rouleau::validation
