// SPDX-License-Identifier: BSD-3-Clause
// `rouleau run` stopped at a call on its database, while others read it; such a call that fails while nobody does; and
// reads that fail in commands that only read.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <future>
#include <iterator>
#include <sstream>

#include "crash/faults/plan.hpp"
#include "support/campaign_outcome.hpp"

namespace rouleau::testing {
namespace {

constexpr const char* manager_program = "rouleau";
constexpr double most_s = 10;  // a reader waits a second; the rest is a loaded machine

/// A campaign of two points that has been made, not run.
class SmallCampaign : public CampaignProgram {
 public:
  SmallCampaign() {
    write_study("fluid.lambda = 1, 8", execution());
    const Capture made = init();
    EXPECT_EQ(made.status, 0) << made.err;
  }
};

class CallsOnTheDatabase : public ::testing::Test {
 protected:
  /// Of an undisturbed run: calls on campaign.db and its journal.
  void SetUp() override {
    {
      Faults faults(undisturbed.path(), manager_program, {});
      faults.record();
      const auto end = undisturbed.run();
      ASSERT_EQ(end.status, 0) << end.err;
      for (const RecordedCall& call : read_calls(faults.log())) {
        if (std::filesystem::path(call.path).filename().string().starts_with("campaign.db")) calls.push_back(call);
      }
    }
    ASSERT_FALSE(calls.empty());
    fmt::print("{} calls\n", calls.size());
    expected = outcome_of(undisturbed);
  }
  void expect_undisturbed_end(const CampaignProgram& program) const {
    const CampaignOutcome found = outcome_of(program);
    tally().wrong_resumes += found == expected ? 0 : 1;
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.samples, expected.samples);
    EXPECT_EQ(found.results, expected.results);
    EXPECT_TRUE(program.jobs().empty());
  }

  const SmallCampaign undisturbed;
  std::vector<RecordedCall> calls;
  CampaignOutcome expected;
};

void expect_answers(const CampaignProgram& program) {
  const std::vector<std::vector<std::string>> readers = {{"status", "c"}, {"query", "c"}, {"why", "#1", "-C", "c"}};
  for (const std::vector<std::string>& words : readers) {
    std::vector<std::string> command = {ROULEAU_PROGRAM};
    command.insert(command.end(), words.begin(), words.end());
    campaign::CaptureSettings settings;
    settings.directory = program.path();
    settings.time_out_s = most_s;
    const auto answer = campaign::run_and_capture(command, settings);
    EXPECT_FALSE(answer.timed_out) << words[0] << " hangs";
    if (answer.status == 0) continue;
    EXPECT_EQ(answer.status, 1) << words[0] << ": " << answer.err;
    EXPECT_THAT(answer.err, ::testing::ContainsRegex("`rouleau run` \\(process [0-9]+ on .*\\) is writing"))
        << words[0];
  }
}

TEST_F(CallsOnTheDatabase, WhereTheManagerIsFrozenKeepNoReaderWaiting) {
  int freezes = 0;
  for (const std::int64_t place : planned_places(static_cast<std::int64_t>(calls.size()), 8)) {
    const RecordedCall& call = calls[static_cast<std::size_t>(place - 1)];
    SCOPED_TRACE(fmt::format("frozen at call {}, {} of {}", call.number, call.name, call.path));
    const SmallCampaign program;
    Faults faults(program.path(), manager_program, {call.number, Fault::stop});
    auto end = std::async(std::launch::async, [&program] { return program.run(); });
    const auto is_over = [&] { return end.wait_for(std::chrono::seconds(0)) == std::future_status::ready; };
    const bool is_frozen = has_stopped(faults, is_over);
    faults.let_go();
    if (is_frozen) {
      ++freezes;
      ++tally().freezes;
      expect_answers(program);
      ::kill(faults.victim(), SIGCONT);
    }
    const auto finished = end.get();
    EXPECT_EQ(finished.status, 0) << finished.err;
    expect_undisturbed_end(program);
    if (HasFailure() && !is_long_form()) return;
  }
  EXPECT_GT(freezes, 0);
}

// Such an error once ended the manager; a point whose start it hit was taken for one that could not be started.
TEST_F(CallsOnTheDatabase, ThatFailEndNoManagerThatIsUnderWay) {
  // What comes before the first attempt is claimed belongs to the opening, which ends with 1 and says what to do.
  std::int64_t first = 0;
  for (const RecordedCall& call : calls) {
    if (first == 0 && call.path.ends_with("-journal")) first = call.number;
  }
  std::erase_if(calls, [&](const RecordedCall& call) { return call.number < first; });
  for (const std::int64_t place : planned_places(static_cast<std::int64_t>(calls.size()), 10)) {
    const RecordedCall& call = calls[static_cast<std::size_t>(place - 1)];
    const Injection injection{call.number, Fault::error, place % 2 == 0 ? EIO : ENOSPC};
    SCOPED_TRACE(fmt::format("{} at call {}, {} of {}", name_of(injection), call.number, call.name, call.path));
    const SmallCampaign program;
    {
      const Faults faults(program.path(), manager_program, injection);
      const auto end = program.run();
      EXPECT_EQ(end.status, 0) << end.err;
      if (faults.injected() != 0) count(injection);
    }
    expect_undisturbed_end(program);
    for (const campaign::PointRow& point : program.store().points())
      EXPECT_EQ(program.store().attempts(point.key).size(), 1U) << point.ordinal;
    if (HasFailure() && !is_long_form()) return;
  }
}

// SQLite reports a page that the disk did not give as damage, and a look at the file that failed as its removal.
TEST(ReadsOfTheDatabase, ThatFailOnceEndNoManagerThatIsUnderWay) {
  std::vector<RecordedCall> calls;
  const SmallCampaign undisturbed;
  {
    Faults faults(undisturbed.path(), manager_program, {.watch = Watch::reads});
    faults.record();
    EXPECT_EQ(undisturbed.run().status, 0);
    bool is_under_way = false;  // since the first attempt was claimed: what comes before belongs to the opening
    for (const RecordedCall& call : read_calls(faults.log())) {
      is_under_way = is_under_way || call.path.find("/attempts/1") != std::string::npos;
      if (is_under_way && call.path.ends_with("/campaign.db")) calls.push_back(call);
    }
  }
  const CampaignOutcome expected = outcome_of(undisturbed);
  fmt::print("{} reads\n", calls.size());
  ASSERT_FALSE(calls.empty());
  for (const std::int64_t place : planned_places(static_cast<std::int64_t>(calls.size()), 10)) {
    const RecordedCall& call = calls[static_cast<std::size_t>(place - 1)];
    const Injection injection{call.number, Fault::error, EIO, false, Watch::reads};
    SCOPED_TRACE(fmt::format("{} of campaign.db at read {}", call.name, call.number));
    const SmallCampaign program;
    {
      const Faults faults(program.path(), manager_program, injection);
      const auto end = program.run();
      EXPECT_EQ(end.status, 0) << end.err;
      if (faults.injected() != 0) count(injection);
    }
    const CampaignOutcome found = outcome_of(program);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.samples, expected.samples);
    EXPECT_EQ(found.results, expected.results);
    EXPECT_EQ(found.logs, expected.logs);
    if (HasFailure() && !is_long_form()) return;
  }
}

class Readers : public ::testing::TestWithParam<std::string> {};

TEST_P(Readers, GiveTheWholeAnswerOrSayWhatTheyCannotRead) {
  const SmallCampaign program;
  ASSERT_EQ(program.run().status, 0);
  const CampaignOutcome before = outcome_of(program);
  std::istringstream text(GetParam());
  const std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
  const auto whole = program.rouleau(words);
  EXPECT_EQ(whole.status, 0) << whole.err;
  std::vector<RecordedCall> calls;
  {
    Faults faults(program.path(), manager_program, {.watch = Watch::reads});
    faults.record();
    EXPECT_EQ(program.rouleau(words).status, 0);
    calls = read_calls(faults.log());
  }
  fmt::print("{} reads\n", calls.size());
  for (const Injection& injection : planned_faults(calls, 12, Watch::reads)) {
    const Faults faults(program.path(), manager_program, injection);
    const auto answer = program.rouleau(words);
    if (faults.injected() == 0) continue;
    count(injection);
    SCOPED_TRACE(fmt::format("{} at read {} of {}: {} {}", name_of(injection), injection.at, calls.size(),
                             faults.struck().name, faults.struck().path));
    EXPECT_TRUE(answer.status >= 0 && answer.status < 8) << answer.status << answer.err;
    EXPECT_TRUE(answer.out == whole.out || !answer.err.empty()) << answer.out;
    EXPECT_TRUE(answer.status == 0 || !answer.err.empty()) << answer.status;
  }
  EXPECT_TRUE(outcome_of(program) == before);
}

INSTANTIATE_TEST_SUITE_P(, Readers, ::testing::Values("status c", "query c", "why #1 -C c", "verify c", "plan c"),
                         [](const auto& instance) { return instance.param.substr(0, instance.param.find(' ')); });

}  // namespace
}  // namespace rouleau::testing
