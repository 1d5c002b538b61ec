// SPDX-License-Identifier: BSD-3-Clause
#include "size_sweep.hpp"

#include <fmt/format.h>

#include "interior/ray_cast.hpp"
#include "interior/tracker.hpp"
#include "membrane/assemble.hpp"
#include "membrane/shapes.hpp"
#include "membrane/transform.hpp"
#include "ray_times.hpp"
#include "stopwatch.hpp"
#include "support/one_block.hpp"

namespace rouleau::speed {

namespace {

Cells cell_for(int edge) {
  // Beside the lattice's symmetry planes, where many vertices would share their nodes.
  const Vec3 centre = Vec3::Constant((edge - 1) / 2.0) + Vec3(0.13, 0.29, 0.37);
  Surface surface = red_blood_cell(Division::of_frequency(edge / 3), edge / 4.0);
  translate(surface, centre);
  const std::vector<CellStart> starts{{std::move(surface), std::nullopt}};
  return assemble(starts);
}

}  // namespace

struct SizeSweep::Size {
  int edge;
  testing::OneBlock<float> block;
  Cells cells;
  Tracker tracker;
  Flags flags;
  std::vector<std::uint8_t> no_rows;
  double distance = 0.01;

  explicit Size(int n)
      : edge(n),
        block({{n, n, n}, {true, false, false}}, testing::two_trt(1.0 / 6, 5.0 / 6)),
        cells(cell_for(n)),
        tracker(Tracking::vertex_normals, block.fluid.lattice, block.fluid.block, cells),
        flags(block.fluid.lattice.size, 1),
        no_rows(static_cast<std::size_t>(n * n), 0) {
    block.body_force = Vec3(1e-6, 0, 0);
    cast_rays(cells, block.fluid.lattice, block.fluid.block, RaySearch::columns, flags);
  }

  /// As a flow would move it: there and back by so little that few nodes change sides. Costs far less than an update.
  void move() {
    distance = -distance;
    for (double& x : cells.X.x) x += distance;
  }

  /// Seconds, by name.
  std::map<std::string, double> measure(double enough_s) {
    const Lattice& lattice = block.fluid.lattice;
    return {{"fluid", seconds_per_call(enough_s, [&] { block.step({no_rows}); })},
            {"tracking", seconds_per_call(enough_s,
                                          [&] {
                                            move();
                                            tracker.update(cells, flags);
                                          })},
            {"shell_raycast", shell_cast_seconds(cells, lattice, enough_s)},
            {"full_raycast", full_cast_seconds(cells, lattice, measured_planes)},
            {"column_raycast", column_cast_seconds(cells, lattice, enough_s)}};
  }
};

SizeSweep::SizeSweep(const std::vector<int>& edges, double enough_s) : enough_s_(enough_s) {
  for (const int edge : edges) sizes_.push_back(std::make_unique<Size>(edge));
}

SizeSweep::~SizeSweep() = default;

void SizeSweep::measure(Series& series) {
  std::vector<double> edges;
  std::map<std::string, std::vector<double>> seconds;
  for (const auto& size : sizes_) {
    edges.push_back(size->edge);
    for (const auto& [name, s] : size->measure(enough_s_)) {
      seconds[name].push_back(s);
      series.add(fmt::format("sweep.{}_ms.{}", name, size->edge), 1e3 * s);
    }
  }
  for (const auto& [name, s] : seconds) series.add(name + "_exponent", fitted_exponent(edges, s));
}

}  // namespace rouleau::speed
