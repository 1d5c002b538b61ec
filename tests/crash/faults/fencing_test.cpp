// SPDX-License-Identifier: BSD-3-Clause
// Two live solvers on one run directory: the older one, frozen at any of its file-system calls and thawed when the
// newer one is under way or done, stops with 76 and changes nothing that the newer one has written.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <set>

#include "crash/faults/busy_run.hpp"
#include "crash/faults/plan.hpp"

namespace rouleau::testing {
namespace {

/// A solver that is stopped at a call, until it is thawed.
class Frozen {
 public:
  Frozen(const BusyRun& run, int ranks, std::int64_t at)
      : at_(at),
        faults_(run.directory(), solver_program, {at, Fault::stop}),
        end_(std::async(std::launch::async, [&run, ranks] { return run.run(ranks); })) {
    is_frozen_ = has_stopped(faults_, [this] { return is_over(); });
    faults_.let_go();
  }
  [[nodiscard]] bool is_frozen() const { return is_frozen_; }
  /// Thaws it and waits for its end.
  Finished thaw() {
    if (is_frozen_) ::kill(faults_.victim(), SIGCONT);
    return end_.get();
  }

  /// What it was stopped at.
  [[nodiscard]] StruckCall call() const { return faults_.struck(); }
  /// Its calls from the one it was stopped at.
  [[nodiscard]] std::int64_t calls_since() const { return faults_.calls() - at_; }

 private:
  [[nodiscard]] bool is_over() const { return end_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

  std::int64_t at_;
  Faults faults_;
  std::future<Finished> end_;
  bool is_frozen_ = false;
};

/// All files of the run but those of the attempts, which are each one's own.
std::map<std::string, std::string> shared_files(const BusyRun& run) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(run.directory())) {
    const std::string name = entry.path().lexically_relative(run.directory()).string();
    if (entry.is_regular_file() && !name.starts_with("attempts/")) files[name] = content_of(entry.path());
  }
  return files;
}

void expect_same_files(const std::map<std::string, std::string>& before,
                       const std::map<std::string, std::string>& after) {
  for (const auto& [name, content] : after) {
    const auto found = before.find(name);
    EXPECT_TRUE(found != before.end()) << name << " has appeared";
    if (found != before.end()) {
      EXPECT_TRUE(found->second == content) << name << " has changed";
    }
  }
  for (const auto& [name, content] : before) EXPECT_TRUE(after.contains(name)) << name << " is gone";
}

bool is_checkpoint(const std::string& path) {
  const std::filesystem::path file(path);
  return file.parent_path().filename() == "checkpoints" && file.extension() == ".h5";
}

/// The calls between which an older attempt must be stopped by the fence: it has claimed, and has something left to
/// finish that all attempts share. Behind them it makes `rest` calls. Up to `resumed`, the log has been cut back.
struct Span {
  std::int64_t first = 0, last = 0, rest = 0, resumed = 0;
  std::vector<std::int64_t> renames;  ///< up to `resumed`
  /// Calls by which others see what was done: renames, and writes to the sample log. And those of them that bring a
  /// checkpoint its name.
  std::vector<std::int64_t> commits, checkpoints;
};
Span fenced_span(const std::vector<RecordedCall>& calls) {
  Span span;
  for (const RecordedCall& call : calls) {
    if (call.name == "mkdir" && std::filesystem::path(call.path).parent_path().filename() == "attempts")
      span.first = call.number + 1;
    if (call.name == "write" && call.path.ends_with("/samples.csv")) span.commits.push_back(call.number);
    if (call.name != "rename") continue;
    span.commits.push_back(call.number);
    if (is_checkpoint(call.other)) span.checkpoints.push_back(call.number);
    if (call.other.ends_with("/progress.json")) span.last = call.number;
    if (span.resumed == 0) span.renames.push_back(call.number);
    if (call.other.ends_with("/samples.csv")) span.resumed = call.number;
  }
  std::erase_if(span.commits, [&](std::int64_t number) { return number > span.last; });
  EXPECT_LT(span.first, span.resumed);
  EXPECT_LT(span.resumed, span.last);
  span.rest = static_cast<std::int64_t>(calls.size()) - span.last;
  return span;
}

/// What there is before the attempts that a test looks at.
using Prepare = std::function<void(BusyRun&)>;

struct Undisturbed {
  explicit Undisturbed(
      int ranks, const Prepare& prepare = [](BusyRun&) {}) {
    BusyRun run;
    prepare(run);
    span = fenced_span(recorded(run, ranks));
    end = run.fingerprint();
  }
  Span span;
  std::string end;
};

/// A third of the run has every kind of commit, too, and the short form has time for all of them.
void shorten(BusyRun& run) {
  if (!is_long_form()) run.set_steps(16);
}

constexpr const char* foreign_name = "checkpoints/000000000032.h5";

const std::string& foreign_checkpoint() {
  static const std::string bytes = [] {
    BusyRun other;
    other.set("fluid.lambda", "4");
    other.set_steps(32);
    other.finish();
    return content_of(other.path(foreign_name));
  }();
  return bytes;
}

/// A checkpoint of step 16, and one of another run that lies where this one will write its own at step 32.
void leave_two_checkpoints(BusyRun& run) {
  static const std::unique_ptr<BusyRun> begun = [] {
    auto made = std::make_unique<BusyRun>();
    made->set_steps(16);
    made->finish();
    set_content(made->path(foreign_name), foreign_checkpoint());
    return made;
  }();
  using std::filesystem::copy_options;
  std::filesystem::copy(begun->directory(), run.directory(),
                        copy_options::recursive | copy_options::overwrite_existing);
  run.set_steps(48);
}

void expect_superseded(Frozen& frozen, const Span& span) {
  const Finished older = frozen.thaw();
  // On a fast machine a run may make fewer checkpoints than the recorded one, and have been at its end.
  if (older.code == 0 && frozen.calls_since() <= span.rest) return;
  EXPECT_EQ(older.code, 76) << older.err;
  EXPECT_NE(older.err.find("has taken over"), std::string::npos) << older.err;
}

void expect_undisturbed_end(const BusyRun& run, const std::string& end) {
  const std::string found = run.fingerprint();
  if (found != end) ++tally().lost_samples;
  EXPECT_EQ(found, end);
  if (!is_long_form()) return;  // it has no time to ask the solver as well
  run.finish();
  const nlohmann::json record = run.exit_record();
  EXPECT_EQ(record.at("resumed_from"), "checkpoints/000000000048.h5");
  EXPECT_TRUE(record.at("rejected_checkpoints").empty()) << record;
}

/// At a sample of all calls, and at all of `wanted`: where the older one is past its fence.
void expect_older_stops_behind_a_finished_newer(int ranks, int sample, std::vector<std::int64_t> Span::*wanted) {
  const Undisturbed undisturbed(ranks, shorten);
  const Span& span = undisturbed.span;
  std::set<std::int64_t> places((span.*wanted).begin(), (span.*wanted).end());
  for (const std::int64_t place : planned_places(span.last - span.first + 1, sample))
    places.insert(span.first + place - 1);
  int at_a_checkpoint = 0;
  for (const std::int64_t at : places) {
    BusyRun run;
    shorten(run);
    Frozen older(run, ranks, at);
    if (!older.is_frozen()) continue;
    const StruckCall call = older.call();
    SCOPED_TRACE(fmt::format("frozen at call {}, {} {} {}; {} to {} are fenced", at, call.name, call.path, call.other,
                             span.first, span.last));
    at_a_checkpoint += call.name == "rename" && is_checkpoint(call.other) ? 1 : 0;
    ++tally().freezes;
    run.finish(ranks);
    const auto before = shared_files(run);
    expect_superseded(older, span);
    expect_same_files(before, shared_files(run));
    expect_undisturbed_end(run, undisturbed.end);
    if (::testing::Test::HasFailure() && !is_long_form()) return;
  }
  EXPECT_GT(at_a_checkpoint, 0);
}

TEST(Fencing, OlderAttemptFrozenAtAnyCallStopsBehindAFinishedNewerOne) {
  expect_older_stops_behind_a_finished_newer(1, 3, &Span::commits);
}

TEST(Fencing, OlderAttemptOnTwoRanksToo) { expect_older_stops_behind_a_finished_newer(2, 1, &Span::checkpoints); }

TEST(Fencing, OlderAttemptFrozenInItsResumeStopsToo) {
  const Undisturbed undisturbed(1, leave_two_checkpoints);
  const Span& span = undisturbed.span;
  std::set<std::int64_t> places(span.renames.begin(), span.renames.end());
  for (const std::int64_t place : planned_places(span.resumed - span.first + 1, 4))
    places.insert(span.first + place - 1);
  for (const std::int64_t at : places) {
    SCOPED_TRACE(fmt::format("frozen at call {}, {} to {} are the resume", at, span.first, span.resumed));
    BusyRun run;
    leave_two_checkpoints(run);
    Frozen older(run, 1, at);
    ASSERT_TRUE(older.is_frozen());
    ++tally().freezes;
    run.finish();
    const auto before = shared_files(run);
    EXPECT_EQ(before.at(std::string(foreign_name) + ".foreign"), foreign_checkpoint());
    expect_superseded(older, span);
    expect_same_files(before, shared_files(run));
    expect_undisturbed_end(run, undisturbed.end);
    if (::testing::Test::HasFailure() && !is_long_form()) return;
  }
}

TEST(Fencing, OlderAttemptThatFindsNothingToGoOnFromStillSaysThatItIsSuperseded) {
  const Undisturbed undisturbed(1, leave_two_checkpoints);
  BusyRun run;
  leave_two_checkpoints(run);
  Frozen older(run, 1, undisturbed.span.first);
  ASSERT_TRUE(older.is_frozen());
  ++tally().freezes;
  std::filesystem::create_directories(run.path("attempts/3"));
  set_content(run.path("attempts/3/owner"), "another\n");
  for (const auto& entry : std::filesystem::directory_iterator(run.path("checkpoints"))) set_content(entry, "torn");
  expect_superseded(older, undisturbed.span);
}

TEST(Fencing, NewerAttemptInMidRunDoesNotNoticeTheOlderOne) {
  const Undisturbed undisturbed(1);
  const Span& span = undisturbed.span;
  // Both are frozen at several calls each; coprime strides bring many pairs.
  const std::int64_t length = span.last - span.first + 1;
  int freezes = 0;
  for (const std::int64_t place : planned_places(length, 6)) {
    const std::int64_t older_at = span.first + place - 1;
    const std::int64_t newer_at = span.first + (7 * place) % length;
    SCOPED_TRACE(fmt::format("older frozen at call {}, newer at {} of {}", older_at, newer_at, span.last));
    const BusyRun run;
    Frozen older(run, 1, older_at);
    if (!older.is_frozen()) continue;
    Frozen newer(run, 1, newer_at);
    freezes += newer.is_frozen() ? 1 : 0;
    tally().freezes += 1 + (newer.is_frozen() ? 1 : 0);
    expect_superseded(older, span);
    const Finished end = newer.thaw();
    EXPECT_EQ(end.code, 0) << end.err;
    expect_undisturbed_end(run, undisturbed.end);
    if (::testing::Test::HasFailure() && !is_long_form()) return;
  }
  EXPECT_GT(freezes, 0) << "of the newer one, while the older one was frozen too";
}

}  // namespace
}  // namespace rouleau::testing
