// SPDX-License-Identifier: BSD-3-Clause
#include "run/run_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "run/metadata.hpp"
#include "run/safe_combinations.hpp"

namespace rouleau {

namespace {

/// Steps between two looks at clocks, signals and the stop file; in a parallel run a look costs a reduction.
constexpr std::int64_t look_interval = 16;
/// Steps between two checks of the state's health, samples and checkpoints aside.
constexpr std::int64_t health_interval = 256;

}  // namespace

double mlups(const Setup& setup, double steps_per_s) {
  return steps_per_s * static_cast<double>(setup.lattice.lattice.nodes()) * 1e-6;
}

RunLoop::RunLoop(const LoopParts& parts, std::optional<std::int64_t> resumed_at)
    : parts_(parts),
      stop_(parts.comm, parts.deadline, parts.run_directory / "stop"),
      snapshots_(parts.setup, parts.comm, parts.files, parts.run_directory, parts.attempt),
      bar_(parts.comm.is_root() && !parts.quiet),
      start_step_(resumed_at.value_or(0)),
      end_step_(parts.setup.lattice.steps),
      checkpoint_step_(resumed_at),
      started_s_(monotonic_s()),
      checkpointed_s_(started_s_) {
  if (resumed_at) last_sampled_ = *resumed_at;
}

double RunLoop::steps_per_s() const {
  const double spent = monotonic_s() - started_s_;
  return spent > 0 ? static_cast<double>(parts_.simulation.steps_done() - start_step_) / spent : 0;
}

std::string RunLoop::last_checkpoint() const {
  return checkpoint_step_ ? fmt::format("last good checkpoint: checkpoints/{}", checkpoint_name(*checkpoint_step_))
                          : "there is no checkpoint yet";
}

Outcome RunLoop::run() try {
  const std::int64_t interval = parts_.setup.run.parameters.output.sample_interval_steps;
  const double checkpoint_interval_s = 60 * parts_.setup.run.parameters.output.checkpoint_interval_min;
  const double progress_interval_s = parts_.setup.run.parameters.output.progress_interval_s;
  for (;;) {
    const std::int64_t step = parts_.simulation.steps_done();
    if (step % interval == 0 && step > last_sampled_) sample();
    snapshots_.take(parts_.simulation);
    if (step >= end_step_) {
      checkpoint();
      report_progress();
      return {Exit::finished, "end time reached"};
    }
    if (step % look_interval == 0) {
      if (const auto reason = stop_.reason()) {
        checkpoint();
        report_progress();
        return {Exit::stopped, *reason};
      }
      enum Due { nothing, progress, a_checkpoint };
      const double now = monotonic_s();
      std::int64_t due = now - progressed_s_ >= progress_interval_s ? progress : nothing;
      if (now - checkpointed_s_ >= checkpoint_interval_s) due = a_checkpoint;
      parts_.comm.broadcast(&due, sizeof due);
      if (due == a_checkpoint) checkpoint();
      if (due != nothing) report_progress();
      if (bar_.is_due(now)) bar_.draw(progress_now(), now);
    }
    if (step % health_interval == 0) parts_.simulation.check_health();
    parts_.simulation.step();
  }
} catch (const Error& error) {
  if (error.code() != Exit::physics) throw;
  std::string what = error.what();
  what.erase(what.find_last_not_of('.') + 1);
  const LatticeParameters& lattice = parts_.setup.lattice;
  what += kernel_remedy(parts_.setup.run.parameters, std::max(lattice.moduli.kappa_A, lattice.moduli.kappa_S));
  throw Error(Exit::physics, fmt::format("step {}: {}; {}.", parts_.simulation.steps_done(), what, last_checkpoint()));
}

void RunLoop::sample() {
  parts_.simulation.check_health();
  const Sample sample = take_sample(parts_.simulation, parts_.setup);
  parts_.comm.on_root([&] { parts_.log->append(sample.rows); });
  parts_.simulation.forget_flips();
  last_sampled_ = parts_.simulation.steps_done();
  d_um_ = sample.d_um;
  asphericity_ = sample.asphericity;
}

void RunLoop::checkpoint() {
  const std::int64_t step = parts_.simulation.steps_done();
  if (checkpoint_step_ == step) return;
  const double begun = monotonic_s();
  parts_.simulation.check_health();
  SampleLogPosition position;
  parts_.comm.on_root([&] { position = parts_.log->sync(); });
  parts_.comm.broadcast(&position.bytes, sizeof position.bytes);
  parts_.comm.broadcast(position.hash);
  const CheckpointPlace place{parts_.files, parts_.run_directory / "checkpoints", [this] { parts_.attempt->fence(); },
                              parts_.setup.run.parameters.output.checkpoints_kept};
  int attempt = parts_.attempt ? parts_.attempt->number() : 0;
  parts_.comm.broadcast(&attempt, sizeof attempt);
  save_checkpoint(place, parts_.comm, parts_.simulation.persistent(),
                  checkpoint_metadata(parts_.setup, step, attempt, position, parts_.mesh_digest));
  checkpoint_step_ = step;
  checkpointed_s_ = monotonic_s();
  checkpoint_unix_s_ = unix_s();
  checkpoint_s_ = checkpointed_s_ - begun;
  stop_.expect_checkpoint(checkpoint_s_);
}

Progress RunLoop::progress_now() const {
  Progress p;
  p.step = parts_.simulation.steps_done();
  p.end_step = end_step_;
  p.time_s = parts_.setup.units.time_s(p.step);
  p.end_time_s = parts_.setup.units.time_s(p.end_step);
  p.steps_per_s = steps_per_s();
  p.mlups = mlups(parts_.setup, p.steps_per_s);
  if (p.steps_per_s > 0) p.eta_s = static_cast<double>(std::max<std::int64_t>(0, p.end_step - p.step)) / p.steps_per_s;
  p.checkpoint_step = checkpoint_step_.value_or(0);
  p.checkpoint_unix_s = checkpoint_unix_s_;
  p.checkpoint_ms = 1e3 * checkpoint_s_;
  p.d_um = d_um_;
  p.asphericity = asphericity_;
  p.updated_unix_s = unix_s();
  return p;
}

void RunLoop::report_progress() {
  progressed_s_ = monotonic_s();
  parts_.comm.on_root([&] {
    const Progress p = progress_now();
    write_progress(parts_.files, *parts_.attempt, p);
    if (bar_.is_shown()) return bar_.draw(p, progressed_s_);
    if (!parts_.quiet)
      fmt::print(stderr, "step {:>9} of {}  t {:.6f} s  {:7.1f} steps/s  {:6.1f} MLUPS{}{}\n", p.step, p.end_step,
                 p.time_s, p.steps_per_s, p.mlups, p.eta_s ? fmt::format("  {:.0f} s left", *p.eta_s) : "",
                 p.d_um ? fmt::format("  d {:.3f} um", *p.d_um) : "");
  });
}

}  // namespace rouleau
