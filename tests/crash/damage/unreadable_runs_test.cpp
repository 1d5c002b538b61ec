// SPDX-License-Identifier: BSD-3-Clause
// One run directory that cannot be read keeps nobody from the others.
#include <gmock/gmock.h>

#include <functional>

#include "crash/damage/figures.hpp"
#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

namespace fs = std::filesystem;
using rouleau::testing::CampaignProgram;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

/// What befalls the run directory of point 2.
struct Trouble {
  const char* name;
  std::function<void(const fs::path& run)> strike;
};

void make_a_folder_of(const fs::path& file) {
  fs::remove_all(file);
  fs::create_directories(file / "within");
}
void make_a_file_of(const fs::path& folder) {
  fs::remove_all(folder);
  set_content(folder, "not a folder");
}

const std::vector<Trouble> troubles = {
    {"SamplesAreAFolder", [](const fs::path& run) { make_a_folder_of(run / "samples.csv"); }},
    {"ProgressIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "progress.json"); }},
    {"RunFileIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "run.ini"); }},
    {"RunFileIsGone", [](const fs::path& run) { fs::remove(run / "run.ini"); }},
    {"PointFileIsRubbish", [](const fs::path& run) { set_content(run / "point.json", std::string(300, '\xff')); }},
    {"PointFileIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "point.json"); }},
    {"AttemptsAreAFile", [](const fs::path& run) { make_a_file_of(run / "attempts"); }},
    {"CheckpointsAreAFile", [](const fs::path& run) { make_a_file_of(run / "checkpoints"); }},
    {"ExitRecordIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "attempts/1/exit.json"); }},
    {"OwnerIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "attempts/1/owner"); }},
    {"LogIsRubbish", [](const fs::path& run) { set_content(run / "samples.csv", std::string(9000, '\xff')); }},
    {"StopFileIsAFolder", [](const fs::path& run) { make_a_folder_of(run / "stop"); }},
    {"EverythingIsGone", [](const fs::path& run) { fs::remove_all(run); }},
    {"TheDirectoryIsAFile", [](const fs::path& run) { make_a_file_of(run); }},
};

class UnreadableRun : public ::testing::TestWithParam<Trouble> {};

TEST_P(UnreadableRun, DoesNotKeepAnybodyFromTheOthers) {
  const CampaignProgram program;
  program.write_study("fluid.lambda = 1, 5, 8", CampaignProgram::execution("retries = 1\n"));
  ASSERT_EQ(program.init().status, 0);
  GetParam().strike(program.run_directory(2));
  ++rouleau::testing::figures().damage_positions;

  const auto before = program.rouleau({"status", "c"});
  EXPECT_EQ(before.status, 0) << before.err;
  for (const char* point : {"#1", "#2", "#3"}) EXPECT_THAT(before.out, HasSubstr(point));
  const auto run = program.run();
  EXPECT_TRUE(run.status == 0 || run.status == 4) << run.status << run.err;
  EXPECT_EQ(program.state(1), State::done) << run.err;
  EXPECT_EQ(program.state(3), State::done) << run.err;
  for (const char* verb : {"sync", "status", "verify", "query", "rebuild"}) {
    const auto answer = program.rouleau({verb, "c"});
    EXPECT_LT(answer.status, 8) << verb << " died: " << answer.err;
  }
  EXPECT_EQ(program.point(1).state, State::done);
}

INSTANTIATE_TEST_SUITE_P(, UnreadableRun, ::testing::ValuesIn(troubles),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace rouleau::campaign
