// SPDX-License-Identifier: BSD-3-Clause
// A simulation of a run file within this program, to look at what its samples do not hold.
#pragma once

#include <filesystem>
#include <memory>

#include "parallel/communicator.hpp"
#include "parallel/decomposition.hpp"
#include "run/simulation.hpp"

namespace rouleau::validation {

class LiveRun {
 public:
  /// Sets it up and starts it. Nothing is written.
  explicit LiveRun(const std::filesystem::path& run_file);
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  [[nodiscard]] const Setup& setup() const { return setup_; }
  [[nodiscard]] const Lattice& lattice() const { return setup_.lattice.lattice; }
  [[nodiscard]] Simulation& simulation() { return *simulation_; }
  [[nodiscard]] const Cells& cells() const { return simulation_->cells(); }

  /// Steps to the end time; after each step calls `each_step`, and at every sample checks the health.
  template <class EachStep>
  void run(EachStep each_step) {
    const std::int64_t interval = setup_.run.parameters.output.sample_interval_steps;
    while (simulation_->steps_done() < setup_.lattice.steps) {
      simulation_->step();
      if (simulation_->steps_done() % interval == 0) simulation_->check_health();
      each_step(simulation_->steps_done());
    }
  }

 private:
  Setup setup_;
  Communicator comm_;
  Decomposition decomposition_;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace rouleau::validation
