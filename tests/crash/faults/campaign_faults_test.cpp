// SPDX-License-Identifier: BSD-3-Clause
// Every file-system call of `rouleau init`, `run` and the other commands that change a campaign, those that only read
// and those of SQLite included, fails or kills the manager, one after the other; the plain command again finishes the
// campaign as if nothing had been.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "crash/faults/plan.hpp"
#include "support/campaign_outcome.hpp"
#include "support/fault_shim/call_log.hpp"
#include "support/fault_shim/disk_model.hpp"

namespace rouleau::testing {
namespace {

constexpr const char* manager_program = "rouleau";

void write_small_study(const CampaignProgram& program) {
  program.write_study("fluid.lambda = 1, 8", CampaignProgram::execution());
}

/// Runs `rouleau WORDS` undisturbed.   returns its calls
std::vector<RecordedCall> recorded(const CampaignProgram& program, const std::vector<std::string>& words,
                                   Watch watch = Watch::changes) {
  Faults faults(program.path(), manager_program, {.watch = watch});
  faults.record();
  const auto end = program.rouleau(words);
  EXPECT_EQ(end.status, 0) << end.err;
  return read_calls(faults.log());
}

/// `rouleau run` on a disk that stays full, or with a file that cannot be read. It may wait as long as that takes, so
/// it is killed when it has come up against it some times.
void run_on_a_bad_disk(const CampaignProgram& program, const Faults& faults) {
  constexpr std::int64_t some = 4;
  const pid_t manager = program.start({"run", "c"});
  bool has_ended = false;
  EXPECT_TRUE(eventually([&] {
    has_ended = ::waitpid(manager, nullptr, WNOHANG) == manager;
    return has_ended || faults.injected() >= some;
  }));
  if (has_ended) return;
  ::kill(manager, SIGKILL);
  CampaignProgram::wait_for(manager);
}

/// Runs `rouleau WORDS` with the fault.
void disturb(const CampaignProgram& program, const std::vector<std::string>& words, const Injection& injection) {
  const Faults faults(program.path(), manager_program, injection);
  if (injection.lasts && words[0] == "run") {
    run_on_a_bad_disk(program, faults);
    if (faults.injected() > 0) count(injection);
    return;
  }
  const auto end = program.rouleau(words);
  if (faults.injected() == 0) {
    EXPECT_EQ(end.status, 0) << end.err;
    return;
  }
  count(injection);
  if (injection.fault == Fault::brief) {
    EXPECT_EQ(end.status, 0) << end.err;
  }
  // What it could not do it says, and how to go on; a start that failed and was repeated ends nothing.
  if (injection.fault == Fault::error && end.status != 0) {
    const bool is_part = words[0] == "rebuild" && end.status == 7;  // it names what it had to leave aside
    EXPECT_TRUE(end.status == 1 || is_part) << end.status << end.err;
    const bool is_full = injection.error_number != EIO;
    const char* const remedy = is_full ? "free space|has room|have room|make room" : ".";
    EXPECT_THAT(end.err, ::testing::ContainsRegex(remedy));
  }
}

/// The plain commands; expects what an undisturbed campaign has.
void expect_undisturbed_end(const CampaignProgram& program, const CampaignOutcome& expected) {
  const auto end = program.run();
  EXPECT_EQ(end.status, 0) << end.out << end.err;
  EXPECT_TRUE(program.jobs().empty()) << "a process is left over";
  const CampaignOutcome found = outcome_of(program);
  tally().manual_steps += end.status != 0 ? 1 : 0;
  tally().lost_samples += found.logs != expected.logs ? 1 : 0;
  tally().wrong_resumes += found == expected ? 0 : 1;
  EXPECT_EQ(found.points, expected.points);
  EXPECT_EQ(found.parameters, expected.parameters);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_EQ(found.results, expected.results);
  EXPECT_EQ(found.logs, expected.logs);
  const auto check = program.rouleau({"verify", "c"});
  EXPECT_EQ(check.status, 0) << check.out << check.err;
}

/// What an undisturbed campaign calls and comes to.
struct Undisturbed {
  explicit Undisturbed(Watch watch) {
    const CampaignProgram program;
    write_small_study(program);
    calls_of_init = recorded(program, {"init", "study.ini", "c"}, watch);
    calls_of_run = recorded(program, {"run", "c"}, watch);
    end = outcome_of(program);
  }
  std::vector<RecordedCall> calls_of_init, calls_of_run;
  CampaignOutcome end;
};

std::string name_of(Watch watch) { return watch == Watch::reads ? "AtReads" : "AtChanges"; }

class CampaignFaults : public ::testing::TestWithParam<Watch> {
 protected:
  const Undisturbed undisturbed{GetParam()};
};

TEST_P(CampaignFaults, InInitLeaveNoTrace) {
  const std::vector<RecordedCall>& calls = undisturbed.calls_of_init;
  fmt::print("{} calls\n", calls.size());
  for (const Injection& injection : planned_faults(calls, 14, GetParam())) {
    SCOPED_TRACE(fmt::format("{} at call {} of {}", name_of(injection), injection.at, calls.size()));
    const CampaignProgram program;
    write_small_study(program);
    disturb(program, {"init", "study.ini", "c"}, injection);
    const auto again = program.init();
    EXPECT_EQ(again.status, 0) << again.err;
    expect_undisturbed_end(program, undisturbed.end);
    if (HasFailure() && !is_long_form()) return;
  }
}

TEST_P(CampaignFaults, InRunLeaveNoTrace) {
  const std::vector<RecordedCall>& calls = undisturbed.calls_of_run;
  fmt::print("{} calls\n", calls.size());
  for (const Injection& injection : planned_faults(calls, 28, GetParam())) {
    SCOPED_TRACE(fmt::format("{} at call {} of {}", name_of(injection), injection.at, calls.size()));
    const CampaignProgram program;
    write_small_study(program);
    ASSERT_EQ(program.init().status, 0);
    disturb(program, {"run", "c"}, injection);
    expect_undisturbed_end(program, undisturbed.end);
    if (HasFailure() && !is_long_form()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(, CampaignFaults, ::testing::Values(Watch::changes, Watch::reads),
                         [](const auto& instance) { return name_of(instance.param); });

void do_without_fault(const CampaignProgram& program, const std::vector<std::string>& words) {
  const auto end = program.rouleau(words);
  EXPECT_EQ(end.status, 0) << end.err;
}

// SQLite then opened it for reading only, and the manager tried for ever to write what it could not.
TEST(OpeningOfTheDatabase, ThatFailsEndsTheRunAndSaysSo) {
  const Undisturbed undisturbed{Watch::changes};
  int opened = 0;
  for (const RecordedCall& call : undisturbed.calls_of_run) {
    if (call.name != "open" || !call.path.ends_with("/campaign.db") || (call.offset & O_ACCMODE) != O_RDWR) continue;
    SCOPED_TRACE(fmt::format("call {}", call.number));
    ++opened;
    const CampaignProgram program;
    write_small_study(program);
    do_without_fault(program, {"init", "study.ini", "c"});
    {
      const Faults faults(program.path(), manager_program, {call.number, Fault::error, EIO});
      campaign::CaptureSettings settings;
      settings.directory = program.path();
      settings.time_out_s = 60;
      const auto end = campaign::run_and_capture({ROULEAU_PROGRAM, "run", "c"}, settings);
      EXPECT_FALSE(end.timed_out);
      EXPECT_EQ(end.status, 1);
      EXPECT_THAT(end.err, ::testing::HasSubstr("campaign.db: cannot be opened for writing"));
    }
    expect_undisturbed_end(program, undisturbed.end);
  }
  EXPECT_GT(opened, 0);
}

/// A command of a campaign, and what comes before it.
struct Command {
  const char* name;
  std::vector<std::string> words;
  std::function<void(const CampaignProgram& program)> prepare;
  const char* sweep = "fluid.lambda = 1, 8";  ///< of the campaign as it was made
};

/// Point 2 computes, and stays at a step behind its first checkpoint until it is asked to stop.
void run_until_the_second_hangs(const CampaignProgram& program) {
  program.script(2, "hang 60\n");
  do_without_fault(program, {"sync", "c"});
  EXPECT_TRUE(eventually([&] {
    return program.jobs().size() == 1 &&
           std::filesystem::exists(program.run_directory(2) / "checkpoints/000000000050.h5");
  }));
}

const std::vector<std::string> cancel_one = {"cancel", "#2", "-C", "c"}, retry_one = {"retry", "#2", "-C", "c"};

const std::vector<Command> commands = {
    {"Sync",
     {"sync", "c"},
     [](const CampaignProgram& program) {
       do_without_fault(program, {"sync", "c"});
       EXPECT_TRUE(eventually([&] { return program.jobs().empty(); }));
     }},
    {"Rebuild",
     {"rebuild", "c"},
     [](const CampaignProgram& program) {
       do_without_fault(program, {"run", "c"});
     }},
    {"Cancel", cancel_one, [](const CampaignProgram&) {}},
    {"CancelOfARunningPoint", cancel_one, run_until_the_second_hangs},
    {"InitWithOneValueMore",
     {"init", "study.ini", "c"},
     [](const CampaignProgram& program) {
       do_without_fault(program, {"run", "c"});
       write_small_study(program);
     },
     "fluid.lambda = 1"},
    {"Retry", retry_one, [](const CampaignProgram& program) { do_without_fault(program, cancel_one); }},
};

class CommandFaults : public ::testing::TestWithParam<std::tuple<Command, Watch>> {
 protected:
  void make(const CampaignProgram& program) const {
    program.write_study(command.sweep, CampaignProgram::execution());
    do_without_fault(program, {"init", "study.ini", "c"});
    command.prepare(program);
  }
  const Command& command = std::get<0>(GetParam());
  const Watch watch = std::get<1>(GetParam());
  const Undisturbed undisturbed{watch};
};

TEST_P(CommandFaults, LeaveNoTraceWhenItIsGivenAgain) {
  const CampaignProgram recording;
  make(recording);
  const std::vector<RecordedCall> calls = recorded(recording, command.words, watch);
  fmt::print("{} calls\n", calls.size());
  for (const Injection& injection : planned_faults(calls, 7, watch)) {
    SCOPED_TRACE(fmt::format("{} at call {} of {}", name_of(injection), injection.at, calls.size()));
    const CampaignProgram program;
    make(program);
    disturb(program, command.words, injection);
    // A retry that has taken effect is not taken a second time.
    const bool is_retried = command.words == retry_one && program.state(2) != campaign::State::cancelled;
    if (!is_retried) do_without_fault(program, command.words);
    if (command.words == cancel_one) {
      EXPECT_EQ(program.state(2), campaign::State::cancelled);
      EXPECT_TRUE(eventually([&] { return program.jobs().empty(); })) << "it was not asked to stop";
      do_without_fault(program, retry_one);
    }
    expect_undisturbed_end(program, undisturbed.end);
    if (HasFailure() && !is_long_form()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(
    , CommandFaults, ::testing::Combine(::testing::ValuesIn(commands), ::testing::Values(Watch::changes, Watch::reads)),
    [](const auto& instance) { return std::get<0>(instance.param).name + name_of(std::get<1>(instance.param)); });

/// What the calls make of the disk as it was is what lies there now.
void expect_every_change_seen(const CampaignProgram& program, const std::vector<std::string>& words) {
  SCOPED_TRACE(words[0]);
  DiskModel model(program.path());
  for (const RecordedCall& call : recorded(program, words)) model.apply(call);
  for (const auto& [name, content] : model.files()) EXPECT_TRUE(content == content_of(program.path() / name)) << name;
  std::size_t found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(program.path())) {
    if (entry.is_regular_file()) ++found;
  }
  EXPECT_EQ(found, model.files().size());
}

TEST(FaultShim, SeesEveryChangeOfTheManager) {
  const CampaignProgram program;
  write_small_study(program);
  expect_every_change_seen(program, {"init", "study.ini", "c"});
  expect_every_change_seen(program, cancel_one);
  expect_every_change_seen(program, retry_one);
  do_without_fault(program, {"run", "c"});
  expect_every_change_seen(program, {"rebuild", "c"});
}

}  // namespace
}  // namespace rouleau::testing
