// SPDX-License-Identifier: BSD-3-Clause
// The paper's point as its study has it, in the variant that a case wants.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "run/setup.hpp"
#include "run/simulation.hpp"

namespace rouleau::speed {

/// Values by "section.name" that differ from the study's.
using Changes = std::map<std::string, std::string>;

/// The point lambda = 5 of a study file.   leaves a run file in `directory`
Setup paper_point(const std::filesystem::path& study, const std::filesystem::path& directory, const Changes& changes);

/// A simulation with all that must outlive it.
class PointRun {
 public:
  /// Starts it. Collective over `comm`, which must outlive it.
  PointRun(Setup setup, const Communicator& comm);

  void step(int steps) {
    for (int n = 0; n < steps; ++n) simulation_->step();
  }
  [[nodiscard]] const Setup& setup() const { return *setup_; }
  [[nodiscard]] Simulation& simulation() { return *simulation_; }
  [[nodiscard]] const Communicator& comm() const { return comm_; }
  /// Lets a loop around the simulation end so many steps from now.
  void end_after(std::int64_t steps) { setup_->lattice.steps = simulation_->steps_done() + steps; }

 private:
  std::unique_ptr<Setup> setup_;  ///< stays where it is when this is moved: the simulation refers to it
  const Communicator& comm_;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace rouleau::speed
