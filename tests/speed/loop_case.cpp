// SPDX-License-Identifier: BSD-3-Clause
#include "loop_case.hpp"

#include "base/error.hpp"
#include "run/metadata.hpp"
#include "run/run_loop.hpp"
#include "stopwatch.hpp"
#include "storage/checkpoint.hpp"
#include "storage/inspect.hpp"
#include "storage/resume.hpp"

namespace rouleau::speed {

namespace {

using Clock = std::chrono::steady_clock;

/// A simulation that passes everything on and takes the time of its steps.
class TimedSteps final : public Simulation {
 public:
  explicit TimedSteps(Simulation& inner) : inner_(inner) {}

  void step() override {
    const auto begin = Clock::now();
    inner_.step();
    last_end_ = Clock::now();
    in_steps_ += last_end_ - begin;
  }
  [[nodiscard]] Clock::duration in_steps() const { return in_steps_; }
  [[nodiscard]] Clock::time_point last_end() const { return last_end_; }

  void start() override { inner_.start(); }
  void resume() override { inner_.resume(); }
  PersistentState persistent() override { return inner_.persistent(); }
  [[nodiscard]] std::string mesh_digest() const override { return inner_.mesh_digest(); }
  [[nodiscard]] std::int64_t steps_done() const override { return inner_.steps_done(); }
  [[nodiscard]] const Cells& cells() const override { return inner_.cells(); }
  [[nodiscard]] const StepTimers& timers() const override { return inner_.timers(); }
  [[nodiscard]] std::int64_t inside_nodes() const override { return inner_.inside_nodes(); }
  [[nodiscard]] double mean_velocity() const override { return inner_.mean_velocity(); }
  [[nodiscard]] double body_force() const override { return inner_.body_force(); }
  [[nodiscard]] std::int64_t flips() const override { return inner_.flips(); }
  void forget_flips() override { inner_.forget_flips(); }
  void check_health() override { inner_.check_health(); }
  void find_membrane_forces() override { inner_.find_membrane_forces(); }
  LatticePicture take_picture(int stride) override { return inner_.take_picture(stride); }

 private:
  Simulation& inner_;
  Clock::duration in_steps_{};
  Clock::time_point last_end_;
};

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

void LoopCase::measure_shares(Series& series) {
  FileSystem& files = posix_file_system();
  // From one sample to the one after the next: two samples, and corrections at their own interval.
  run_.end_after(2 * run_.setup().run.parameters.output.sample_interval_steps);
  TimedSteps timed(run_.simulation());
  Attempt attempt = Attempt::claim(files, directory_);
  SampleLog log(files, directory_ / "samples.csv", sample_columns(), attempt.number(), [&] { attempt.fence(); });
  log.start();
  const StepTimers before = timed.timers();
  RunLoop loop({run_.setup(), run_.comm(), timed, files, directory_, &attempt, &log, timed.mesh_digest(), {}, true},
               std::nullopt);
  const auto begin = Clock::now();
  loop.run();
  // The checkpoint at the end comes after the last step and does not count.
  const double total = seconds(timed.last_end() - begin);
  const auto share = [&](Part part) { return (timed.timers().seconds(part) - before.seconds(part)) / total; };
  series.add("tracking_share", share(Part::tracking));
  series.add("volume_share", share(Part::volume));
  series.add("correction_share", share(Part::correction));
  series.add("sampling_share", 1 - seconds(timed.in_steps()) / total);
}

void LoopCase::measure_checkpoint(Series& series) {
  FileSystem& files = posix_file_system();
  Simulation& simulation = run_.simulation();
  const Setup& setup = run_.setup();
  const auto directory = directory_ / "checkpoint-case";
  const CheckpointPlace place{files, directory, [] {}, 1};
  SavedCheckpoint saved;
  const double write_s = seconds_of([&] {
    simulation.check_health();
    saved = save_checkpoint(place, run_.comm(), simulation.persistent(),
                            checkpoint_metadata(setup, simulation.steps_done(), 0, {}, simulation.mesh_digest()));
  });
  const double verify_s = seconds_of([&] {
    if (!verify_checkpoint(files, saved.file).sound) fail(Exit::io, "{}: does not verify", saved.file.string());
  });
  const Expected expected{recorded_parameters(setup.run), setup.run.identity, {}};
  const double read_s = seconds_of([&] {
    PersistentState state = simulation.persistent();
    if (!load_newest(files, directory, run_.comm(), expected, state).metadata)
      fail(Exit::io, "{}: cannot be read", saved.file.string());
    simulation.resume();
  });
  series.add("checkpoint_mb", 1e-6 * static_cast<double>(saved.bytes));
  series.add("checkpoint_write_ms", 1e3 * write_s);
  series.add("checkpoint_verify_ms", 1e3 * verify_s);
  series.add("checkpoint_read_ms", 1e3 * read_s);
  const double interval_s = 60 * setup.run.parameters.output.checkpoint_interval_min;
  series.add("checkpoint_share", write_s / (interval_s + write_s));
}

}  // namespace rouleau::speed
