// SPDX-License-Identifier: BSD-3-Clause
// Flow between two plates: exact for the magic number 3/16, off by a slip that is known for every other.
#include <fmt/format.h>

#include "../analytic_flows.hpp"
#include "case_file.hpp"
#include "cases.hpp"

namespace rouleau::validation {
namespace {

using testing::one_trt;
using testing::plane_channel_error;
using testing::plane_channel_slip;

constexpr const char* exact_profile = "parabola";
constexpr const char* known_slip = "(16 Lambda - 3)/(3 N^2) of u_max [Ginzburg2008]";

Collision mrt_with_unit_ghosts(double nu) { return TwoFluids<MrtRates<>>{mrt_rates(nu, 1, 1), mrt_rates(nu, 1, 1)}; }

}  // namespace

void plane_channel(Suite& suite) {
  CaseFile file(suite.places().studies / "plane_channel.ini");
  const std::vector<double> nodes = file.numbers("channel", "nodes"),
                            viscosities = file.numbers("fluid", "viscosities");
  const double other_magic = file.number("fluid", "other_magic");
  file.require_all_used();

  for (const double nu : viscosities) {
    const int N = static_cast<int>(nodes.front());
    suite.check(fmt::format("TRT 3/16, nu {:.4g}, N {}: largest error / u_max", nu, N),
                plane_channel_error<double>(one_trt(nu), nu, 2, N).largest, at_most(1e-9), exact_profile);
    // Populations of 5e-4 rounded to 3e-11 act like random forces; between walls ten nodes apart they add up.
    suite.check(fmt::format("the same in single precision, nu {:.4g}", nu),
                plane_channel_error<float>(one_trt(nu), nu, 2, N).largest, at_most(1e-5), exact_profile);
    const double unit_ghosts = plane_channel_error<double>(mrt_with_unit_ghosts(nu), nu, 2, N).mean;
    // 1e-7: terms of order u^2 = 1e-6 enter as soon as walls are not exact.
    suite.check(fmt::format("MRT, ghost rates 1, nu {:.4g}, N {}: slip / u_max", nu, N), unit_ghosts,
                near(plane_channel_slip(1.5 * nu, N), 1e-7), known_slip, "the paper's choice; Lambda = 3/2 nu");
  }
  const double nu = viscosities.front();
  for (const double N_value : nodes) {
    const int N = static_cast<int>(N_value);
    suite.check(fmt::format("TRT {:.4g}, nu {:.4g}, N {}: slip / u_max", other_magic, nu, N),
                plane_channel_error<double>(one_trt(nu, other_magic), nu, 2, N).mean,
                near(plane_channel_slip(other_magic, N), 1e-7), known_slip);
    if (N_value == nodes.front()) continue;  // done above
    suite.check(fmt::format("MRT, ghost rates 1, nu {:.4g}, N {}: slip / u_max", nu, N),
                plane_channel_error<double>(mrt_with_unit_ghosts(nu), nu, 2, N).mean,
                near(plane_channel_slip(1.5 * nu, N), 1e-7), known_slip);
  }
}

}  // namespace rouleau::validation
