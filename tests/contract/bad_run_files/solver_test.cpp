// SPDX-License-Identifier: BSD-3-Clause
// Each wrong run file makes the program end with 65 and one line on stderr, without a trace in the run directory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "contract/bad_run_files/bad_run_files.hpp"

namespace rouleau::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Outcome {
  int code = -1;
  std::string out, err;
};

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class SolverTest : public testing::TestWithParam<BadRunFile> {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "bad_run_file_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    fs::create_directory(folder_ / "run");
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run_solver(const std::string& text, const std::string& arguments) const {
    std::ofstream(folder_ / "run" / "run.ini", std::ios::binary) << text;
    const std::string command = "cd '" + (folder_ / "run").string() + "' && '" ROULEAU_SOLVER "' " + arguments +
                                " > ../out 2> ../err < /dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder_ / "out"), content(folder_ / "err")};
  }

  fs::path folder_;
};

using GoodRunFileTest = SolverTest;

TEST_P(GoodRunFileTest, IsAcceptedByCheck) {
  const Outcome outcome = run_solver(text_of({"", {}, 0, {}}), "check run.ini --format json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"identity\""));
}

INSTANTIATE_TEST_SUITE_P(Once, GoodRunFileTest, testing::Values(BadRunFile{}));

TEST_P(SolverTest, RefusesWithExitCode65) {
  const BadRunFile& bad = GetParam();
  const Outcome outcome = run_solver(text_of(bad), "run.ini");
  EXPECT_EQ(outcome.code, 65);
  if (bad.line > 0) EXPECT_THAT(outcome.err, HasSubstr("run.ini:" + std::to_string(bad.line) + ": "));
  for (const auto& part : bad.parts) EXPECT_THAT(outcome.err, HasSubstr(part));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "run" / "attempts"));
  EXPECT_FALSE(fs::exists(folder_ / "run" / "samples.csv"));
}

INSTANTIATE_TEST_SUITE_P(Table, SolverTest, testing::ValuesIn(bad_run_files()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace rouleau::test
