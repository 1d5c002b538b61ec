// SPDX-License-Identifier: BSD-3-Clause
#include "fluid_cases.hpp"

#include "attainable.hpp"
#include "stopwatch.hpp"
#include "support/one_block.hpp"

namespace rouleau::speed {

namespace {

/// Of all arrays that the fluid and the flags hold. (The heap's own count would add the address space, never touched,
/// in front of arrays that start on a huge page.)
template <class Real>
std::size_t array_bytes(const testing::OneBlock<Real>& block) {
  std::size_t values = block.fluid.f.data.size() + block.fluid.inside_row.size();
  for (std::size_t a = 0; a < 3; ++a) values += block.fluid.u[a].data.size() + block.fluid.g[a].data.size();
  return values * sizeof(Real) + block.inside.data.size();
}

/// What the step needs: 19 populations with one halo node, the velocity with two, the membrane force, and a byte of
/// flag with one halo node.
template <class Real>
std::ptrdiff_t bytes_needed(const Int3& size) {
  const auto with_halo = [&](int halo) {
    return Lattice{{size[0] + 2 * halo, size[1] + 2 * halo, size[2] + 2 * halo}}.nodes();
  };
  return (Q * with_halo(1) + 3 * with_halo(2) + 3 * with_halo(0)) * std::ptrdiff_t{sizeof(Real)} + with_halo(1);
}

}  // namespace

template <class Real>
struct FluidCases::Case {
  std::string ending = sizeof(Real) == 4 ? "_single" : "_double";
  testing::OneBlock<Real> block;
  ScaledInPlace<Real> arrays;
  std::vector<std::uint8_t> no_rows;

  explicit Case(const Lattice& lattice)
      : block(lattice, testing::two_trt(1.0 / 6, 5.0 / 6)),
        arrays(lattice.size),
        no_rows(static_cast<std::size_t>(lattice.size[1] * lattice.size[2]), 0) {
    block.body_force = Vec3(1e-6, 0, 0);
  }

  void note_memory(Series& series) const {
    const Lattice& lattice = block.fluid.lattice;
    const auto bytes = static_cast<double>(array_bytes(block));
    const auto needed = static_cast<double>(bytes_needed<Real>(lattice.size));
    series.add("fluid_bytes_per_node" + ending, bytes / static_cast<double>(lattice.nodes()));
    series.add("fluid_bytes_over_needed" + ending, bytes / needed);
  }

  void measure(double enough_s, Series& series) {
    const auto nodes = static_cast<double>(block.fluid.lattice.nodes());
    const double scale_s = seconds_per_call(enough_s, [&] { arrays.scale(); });
    series.add("attainable_mlups" + ending, 1e-6 * nodes / scale_s);
    series.add("attainable_gb_per_s" + ending, 1e-9 * nodes * ScaledInPlace<Real>::bytes_per_node / scale_s);
    const double step_s = seconds_per_call(enough_s, [&] { block.step({no_rows}); });
    series.add("fluid_mlups" + ending, 1e-6 * nodes / step_s);
    series.add("fluid_ms" + ending, 1e3 * step_s);
  }
};

FluidCases::FluidCases(const Lattice& lattice, double enough_s, Series& series)
    : enough_s_(enough_s),
      single_(std::make_unique<Case<float>>(lattice)),
      double_(std::make_unique<Case<double>>(lattice)) {
  single_->note_memory(series);
  double_->note_memory(series);
}

FluidCases::~FluidCases() = default;

void FluidCases::measure(Series& series) {
  single_->measure(enough_s_, series);
  double_->measure(enough_s_, series);
}

}  // namespace rouleau::speed
