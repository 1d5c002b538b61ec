// SPDX-License-Identifier: BSD-3-Clause
// The loop around the step: sample, take snapshots, look around, checkpoint, stop. Everything here happens between two
// steps.
#pragma once

#include <optional>
#include <string>

#include "run/progress_bar.hpp"
#include "run/sampling.hpp"
#include "run/simulation.hpp"
#include "run/snapshots.hpp"
#include "run/stop.hpp"
#include "storage/attempt.hpp"
#include "storage/checkpoint.hpp"
#include "storage/records.hpp"
#include "storage/sample_log.hpp"

namespace rouleau {

/// How an attempt ended, if not by an Error.
struct Outcome {
  Exit code = Exit::finished;
  std::string reason;
};

/// What the loop works with; all must outlive it. `attempt` and `log` are rank 0's, null elsewhere.
struct LoopParts {
  const Setup& setup;
  const Communicator& comm;
  Simulation& simulation;
  FileSystem& files;
  std::filesystem::path run_directory;
  Attempt* attempt;
  SampleLog* log;
  std::string mesh_digest;
  std::optional<double> deadline;  ///< on the clock of monotonic_s()
  bool quiet = false;
};

class RunLoop {
 public:
  /// `resumed_at`: the step of the checkpoint loaded; nothing for a new run, which is sampled at step 0.
  RunLoop(const LoopParts& parts, std::optional<std::int64_t> resumed_at);

  /// Steps until the end time or until asked to stop; both leave a checkpoint of the last step. Collective.
  /// throws Error(physics) naming step and last good checkpoint, Error(io), Error(superseded)
  Outcome run();

  /// Steps per second of this attempt, checkpoints and samples included.
  [[nodiscard]] double steps_per_s() const;
  [[nodiscard]] std::int64_t start_step() const { return start_step_; }

 private:
  void sample();
  void checkpoint();
  [[nodiscard]] Progress progress_now() const;  ///< rank 0's
  void report_progress();
  [[nodiscard]] std::string last_checkpoint() const;

  LoopParts parts_;
  StopWatch stop_;
  Snapshots snapshots_;
  ProgressBar bar_;
  std::int64_t start_step_ = 0, end_step_ = 0;
  std::int64_t last_sampled_ = -1;
  std::optional<std::int64_t> checkpoint_step_;
  double started_s_ = 0, checkpointed_s_ = 0, progressed_s_ = 0;
  double checkpoint_unix_s_ = 0, checkpoint_s_ = 0;
  std::optional<double> d_um_, asphericity_;
};

/// 19 populations a node updated: millions a second.
double mlups(const Setup& setup, double steps_per_s);

}  // namespace rouleau
