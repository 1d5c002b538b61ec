// SPDX-License-Identifier: BSD-3-Clause
#include "run/attempt_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "run/conversion_table.hpp"
#include "run/metadata.hpp"
#include "run/run_loop.hpp"
#include "run/version.hpp"
#include "storage/files.hpp"
#include "storage/past_checkpoint.hpp"
#include "storage/resume.hpp"
#include "storage/unfinished.hpp"

namespace rouleau {

namespace {

/// Holds what an exit record needs, and writes it however the attempt ends.
class AttemptRun {
 public:
  AttemptRun(const RunOptions& options, const Communicator& comm, FileSystem& files)
      : options_(options),
        comm_(comm),
        files_(files),
        directory_(options.run_file.parent_path()),
        begun_s_(monotonic_s()) {
    if (directory_.empty()) directory_ = ".";
    record_.ranks = comm.size();
    record_.version = version();
    record_.git = git_hash();
  }

  Exit run() {
    Outcome outcome;
    try {
      outcome = run_to_the_end();
    } catch (const Error& error) {
      const Error end = end_of(error);
      leave_record({end.code(), end.what()});
      throw end;
    }
    leave_record(outcome);
    if (comm_.is_root() && !options_.quiet) fmt::print(stderr, "{}\n", summary(outcome));
    return outcome.code;
  }

 private:
  /// A newer attempt takes unfinished files away and cuts the log back, which looks like a failure of the disk or like
  /// bad input; the fence tells. Collective.
  Error end_of(const Error& error) const {
    if (error.code() == Exit::superseded) return error;
    try {
      comm_.on_root([&] {
        if (attempt_) attempt_->fence();
      });
    } catch (const Error& fenced) {
      if (fenced.code() == Exit::superseded) return fenced;
    }
    return error;
  }

  Outcome run_to_the_end() {
    comm_.all_agree([&] { setup_.emplace(set_up(options_.run_file, files_)); });
    const Setup& setup = *setup_;
    require_same_everywhere(setup.run);
    record_.end_step = setup.lattice.steps;
    comm_.on_root([&] { claim(); });
    if (comm_.is_root() && !options_.quiet) print_set_up();

    const Decomposition decomposition(setup.lattice.lattice, comm_, options_.ranks);
    std::unique_ptr<Simulation> simulation;
    comm_.all_agree([&] { simulation = make_simulation(setup, comm_, decomposition); });
    if (comm_.is_root())
      log_.emplace(files_, directory_ / "samples.csv", sample_columns(), attempt_->number(),
                   [this] { attempt_->fence(); });

    const std::optional<std::int64_t> resumed_at = resume(*simulation);
    if (!resumed_at) {
      simulation->start();
      comm_.on_root([&] { log_->start(); });
    }
    RunLoop loop({setup, comm_, *simulation, files_, directory_, attempt_ ? &*attempt_ : nullptr,
                  log_ ? &*log_ : nullptr, simulation->mesh_digest(), options_.deadline, options_.quiet},
                 resumed_at);
    record_.start_step = loop.start_step();
    try {
      const Outcome outcome = loop.run();
      note_end(*simulation, loop);
      return outcome;
    } catch (const Error&) {
      note_end(*simulation, loop);
      throw;
    }
  }

  /// Each rank reads the files itself, while somebody may be changing them; ranks that differ would wait for each other
  /// for ever. Collective.
  void require_same_everywhere(const RunFile& run) const {
    std::string own;
    for (const ParameterValue& v : run.values) own += fmt::format("{} = {}\n", v.name, v.identity_value);
    std::string roots = own;
    comm_.broadcast(roots);
    comm_.all_agree([&] {
      if (own == roots) return;
      const auto same = std::mismatch(own.begin(), own.end(), roots.begin(), roots.end()).first - own.begin();
      const std::size_t begin = own.substr(0, static_cast<std::size_t>(same)).rfind('\n') + 1;
      const auto line = [&](const std::string& text) { return text.substr(begin, text.find('\n', begin) - begin); };
      fail(Exit::io,
           "{}: rank {} read {}, rank 0 {}. The file was changed while the run started, or this node sees an old one. "
           "Start the run again.",
           run.path.string(), comm_.rank(), line(own), line(roots));
    });
  }

  void claim() {
    attempt_.emplace(options_.attempt ? Attempt::join(files_, directory_, *options_.attempt, options_.token)
                                      : Attempt::claim(files_, directory_));
    const ProcessIdentity process = this_process(files_);
    record_.host = process.host;
    write_started(files_, *attempt_, process, comm_.size());
  }

  /// Loads the newest checkpoint that verifies; says which were rejected and why. All of them: Error(bad_input).
  std::optional<std::int64_t> resume(Simulation& simulation) {
    Expected expected;
    expected.parameters = recorded_parameters(setup_->run);
    expected.identity = setup_->run.identity;
    expected.obstacle = [&](const CheckpointMetadata& m) -> std::optional<std::string> {
      if (m.mesh_digest != simulation.mesh_digest()) return "its mesh differs from the run file's";
      return log_->obstacle(m.samples);
    };
    PersistentState state = simulation.persistent();
    Resumed resumed;
    try {
      resumed = load_newest(files_, directory_ / "checkpoints", comm_, expected, state);
    } catch (const NoneCanBeContinued& none) {
      note_rejected(none.rejected());
      throw;
    }
    note_rejected(resumed.rejected);
    if (!resumed.metadata) {
      if (resumed.rejected.empty()) {
        comm_.on_root([&] { require_nothing_to_lose(); });
        return std::nullopt;
      }
      fail(Exit::bad_input,
           "{}: none of its {} checkpoints can be continued (see above). Move them and samples.csv away to start anew "
           "at step 0.",
           (directory_ / "checkpoints").string(), resumed.rejected.size());
    }
    comm_.on_root([&] { set_foreign_aside(resumed.rejected); });
    simulation.resume();
    comm_.on_root([&] { log_->cut_back(resumed.metadata->samples); });
    record_.resumed_from = "checkpoints/" + resumed.file.filename().string();
    if (comm_.is_root() && !options_.quiet)
      fmt::print(stderr, "resumed from {} at step {}\n", record_.resumed_from, resumed.metadata->step);
    return resumed.metadata->step;
  }

  void note_rejected(const std::vector<RejectedCheckpoint>& rejected) {
    record_.rejected_checkpoints = rejected;
    if (!comm_.is_root()) return;
    for (const RejectedCheckpoint& checkpoint : rejected)
      fmt::print(stderr, "checkpoint {} is rejected: {}\n", checkpoint.file, checkpoint.why);
  }

  /// Starting at step 0 puts an empty log in the place of samples.csv. Samples that a checkpoint counted can be in it
  /// although none is there: a link to a volume that is not mounted looks like a folder that was never made.
  void require_nothing_to_lose() const {
    if (!log_->has_samples()) return;
    const auto told = past_checkpoint(files_, directory_);
    if (!told) return;
    fail(Exit::io,
         "{}: holds no checkpoint, but {}, and samples.csv has samples that it counted. Bring the folder back (is its "
         "volume mounted?), then start the run again; if it is lost, move samples.csv away to start anew at step 0.",
         (directory_ / "checkpoints").string(), *told);
  }

  /// A sound checkpoint of another run would be deleted with the next one of this run, as are all that were rejected.
  /// It is copied, not renamed: by the time that an attempt thaws, a newer one may have its own file of that name.
  void set_foreign_aside(const std::vector<RejectedCheckpoint>& rejected) {
    for (const RejectedCheckpoint& checkpoint : rejected) {
      if (!checkpoint.foreign) continue;
      const std::filesystem::path file = directory_ / "checkpoints" / checkpoint.file;
      const File original = File::read(files_, file);
      const auto fill = [&](File& copy) {
        read_blocks(original, file_size(files_, file), [&](std::string_view block) { copy.write(block); });
      };
      write_fenced(files_, file.string() + ".foreign", fill, attempt_->number(), [this] { attempt_->fence(); });
      fmt::print(stderr, "checkpoint {} belongs to another run; a copy is kept as {}.foreign\n", checkpoint.file,
                 checkpoint.file);
    }
  }

  void print_set_up() const {
    fmt::print("{}", conversion_table(setup_->run, setup_->lattice, setup_->units, setup_->cells.meshes));
    for (const auto& warning : setup_->warnings) fmt::print("warning: {}\n", warning);
    std::fflush(stdout);
  }

  void note_end(const Simulation& simulation, const RunLoop& loop) {
    record_.step = simulation.steps_done();
    record_.mlups = mlups(*setup_, loop.steps_per_s());
  }

  void leave_record(const Outcome& outcome) {
    record_.code = outcome.code;
    record_.reason = outcome.reason;
    record_.wall_s = monotonic_s() - begun_s_;
    record_.core_s = record_.wall_s * record_.ranks;
    record_.finished_unix_s = unix_s();
    if (!comm_.is_root()) return;
    if (!attempt_ && !options_.attempt) return;
    const int number = attempt_ ? attempt_->number() : *options_.attempt;
    try {
      // To the manager a record there would be the end of a process that lives on.
      if (!owns_attempt(files_, directory_, number, attempt_ ? attempt_->token() : options_.token)) return;
      if (record_.host.empty()) record_.host = this_process(files_).host;
      write_exit_record(files_, directory_ / "attempts" / std::to_string(number), record_);
    } catch (const Error& error) {  // the code still says it; the reason for the end must not be lost over this
      fmt::print(stderr, "rouleau-solver: {}\n", error.what());
    }
  }

  [[nodiscard]] std::string summary(const Outcome& outcome) const {
    return fmt::format("{} at step {} of {} after {:.1f} s ({:.1f} MLUPS)", outcome.reason, record_.step,
                       record_.end_step, record_.wall_s, record_.mlups);
  }

  const RunOptions& options_;
  const Communicator& comm_;
  FileSystem& files_;
  std::filesystem::path directory_;
  double begun_s_;
  std::optional<Setup> setup_;
  std::optional<Attempt> attempt_;
  std::optional<SampleLog> log_;
  ExitRecord record_;
};

}  // namespace

Exit run_attempt(const RunOptions& options, const Communicator& comm, FileSystem& files) {
  return AttemptRun(options, comm, files).run();
}

}  // namespace rouleau
