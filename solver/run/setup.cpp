// SPDX-License-Identifier: BSD-3-Clause
#include "run/setup.hpp"

#include <type_traits>

#include "run/state_list.hpp"

namespace rouleau {

Setup set_up(const std::filesystem::path& run_file, FileSystem& files) {
  RunFile run = read_run_file(run_file);
  const Units units(run.parameters);
  LatticeParameters lattice = lattice_parameters(run, units);
  std::vector<std::string> warnings = check_feasibility(run, lattice, units);
  CellSetup cells = set_up_cells(run, lattice, files);
  warnings.insert(warnings.end(), cells.warnings.begin(), cells.warnings.end());
  return {std::move(run), units, std::move(lattice), std::move(cells), std::move(warnings)};
}

std::int64_t checkpoint_bytes(const Setup& setup) {
  CellRecord cells(assemble(setup.cells.starts));
  const ElementType type =
      setup.run.parameters.numerics.precision == Precision::single_ ? ElementType::f32 : ElementType::f64;
  return static_cast<std::int64_t>(estimate_bytes(state_shape(setup.lattice.lattice, type, cells)));
}

}  // namespace rouleau
