// SPDX-License-Identifier: BSD-3-Clause
#include "live_run.hpp"

#include "storage/file_system.hpp"

namespace rouleau::validation {

LiveRun::LiveRun(const std::filesystem::path& run_file)
    : setup_(set_up(run_file, posix_file_system())),
      decomposition_(setup_.lattice.lattice, comm_),
      simulation_(make_simulation(setup_, comm_, decomposition_)) {
  simulation_->start();
}

}  // namespace rouleau::validation
