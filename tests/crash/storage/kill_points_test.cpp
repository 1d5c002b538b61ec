// SPDX-License-Identifier: BSD-3-Clause
// A run that dies at any one file-system call, and is started again, ends with the same bytes as one that never died.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "storage/attempt.hpp"
#include "storage/checkpoint.hpp"
#include "storage/inspect.hpp"
#include "storage/resume.hpp"
#include "storage/sample_log.hpp"
#include "support/file_system_double.hpp"
#include "support/small_state.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

const Int3 size{5, 4, 3};
constexpr std::int64_t end_step = 12;
constexpr std::int64_t checkpoint_interval = 4;
constexpr int kept = 2;

/// The files of a run as the solver keeps them, around a state that is a pure function of the step.
class MiniatureRun {
 public:
  MiniatureRun(FileSystem& files, const std::filesystem::path& directory)
      : files_(files),
        attempt_(Attempt::claim(files, directory)),
        place_{files, directory / "checkpoints", [this] { attempt_.fence(); }, kept},
        log_(files, directory / "samples.csv", {"step", "cell", "value"}, attempt_.number(),
             [this] { attempt_.fence(); }) {}

  /// To the end, from the newest checkpoint or from step 0.
  void run() {
    std::int64_t step = start();
    while (step < end_step) {
      state_.fill(static_cast<std::uint64_t>(++step));
      sample(step);
      if (step % checkpoint_interval == 0) checkpoint(step);
    }
  }
  std::string final_digest() { return digest(state_.list(), comm_); }

 private:
  std::int64_t start() {
    PersistentState list = state_.list();
    const CheckpointMetadata metadata = small_metadata(0);
    const Expected expected{metadata.parameters, metadata.identity,
                            [&](const CheckpointMetadata& m) { return log_.obstacle(m.samples); }};
    const Resumed resumed = load_newest(files_, place_.directory, comm_, expected, list);
    // A death never costs more than the unfinished generation, so nothing with a final name is ever unusable.
    EXPECT_TRUE(resumed.rejected.empty());
    if (resumed.metadata) {
      SmallState<float> wanted(size, Block{{0, 0, 0}, size});
      wanted.fill(static_cast<std::uint64_t>(resumed.metadata->step));
      EXPECT_TRUE(state_.same_bits(wanted)) << "step " << resumed.metadata->step;
      log_.cut_back(resumed.metadata->samples);
      return resumed.metadata->step;
    }
    state_.fill(0);
    log_.start();
    sample(0);
    return 0;
  }
  void sample(std::int64_t step) {
    log_.append(std::vector<SampleRow>{{step, std::int64_t{0}, static_cast<double>(state_.X[0])},
                                       {step, std::int64_t{1}, static_cast<double>(state_.X[5])}});
  }
  void checkpoint(std::int64_t step) {
    CheckpointMetadata metadata = small_metadata(step, attempt_.number());
    metadata.samples = log_.sync();
    save_checkpoint(place_, comm_, state_.list(), metadata);
  }

  FileSystem& files_;
  Communicator comm_;
  Attempt attempt_;
  CheckpointPlace place_;
  SampleLog log_;
  SmallState<float> state_{size, Block{{0, 0, 0}, size}};
};

struct Ending {
  std::string samples, digest;
  std::vector<std::string> checkpoints;
  bool operator==(const Ending&) const = default;
};

Ending ending(const std::filesystem::path& directory, MiniatureRun& run) {
  Ending end{content_of(directory / "samples.csv"), run.final_digest(), {}};
  // A death between the last rename and the removal of the oldest generation leaves one more than are kept.
  const auto found = find_checkpoints(posix_file_system(), directory / "checkpoints");
  EXPECT_LE(found.size(), static_cast<std::size_t>(kept + 1));
  for (std::size_t i = 0; i < std::min<std::size_t>(kept, found.size()); ++i) {
    end.checkpoints.push_back(found[i].filename().string());
    EXPECT_TRUE(verify_checkpoint(posix_file_system(), found[i]).sound);
  }
  return end;
}

/// Runs with deaths at the given calls, one a start, then to the end. Returns how many calls the first start made.
int run_with_deaths(const std::vector<int>& moments, Ending& end) {
  const TemporaryDirectory directory;
  int calls = 0;
  for (const int moment : moments) {
    FileSystemDouble dying;
    dying.die_at = moment;
    try {
      MiniatureRun(dying, directory.path()).run();
    } catch (const Error&) {
      EXPECT_TRUE(dying.dead());
    }
    calls = dying.calls;
  }
  FileSystemDouble alive;
  MiniatureRun run(alive, directory.path());
  run.run();
  end = ending(directory.path(), run);
  return moments.empty() ? alive.calls : calls;
}

TEST(Crash, AtAnyCallIsUndoneByStartingAgain) {
  Ending undisturbed;
  const int calls = run_with_deaths({}, undisturbed);
  EXPECT_EQ(undisturbed.checkpoints.size(), 2U);
  ASSERT_GT(calls, 100);
  for (int moment = 1; moment <= calls; ++moment) {
    Ending end;
    run_with_deaths({moment}, end);
    EXPECT_TRUE(end == undisturbed) << "death at call " << moment << " of " << calls;
  }
}

TEST(Crash, AgainAndAgainIsUndoneToo) {
  Ending undisturbed;
  const int calls = run_with_deaths({}, undisturbed);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::vector<int> moments;
    for (std::uint64_t death = 0; death < 5; ++death) {
      moments.push_back(1 + static_cast<int>(scramble(seed, death) % static_cast<std::uint64_t>(calls)));
    }
    Ending end;
    run_with_deaths(moments, end);
    EXPECT_TRUE(end == undisturbed) << "seed " << seed;
  }
}

}  // namespace
}  // namespace rouleau::testing
