// SPDX-License-Identifier: BSD-3-Clause
// Each wrong run file makes the program end with 65 and one line on stderr, without a trace in the run directory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "contract/bad_run_files/bad_run_files.hpp"

namespace rouleau::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Outcome {
  int code = -1;
  std::string out, err;
  std::vector<std::string> left_behind;  // in the run directory, beside run.ini
};

std::string content(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Runs the solver on this run file in a directory of its own.
Outcome run_solver(const fs::path& folder, const std::string& run_file, const std::string& arguments) {
  fs::create_directories(folder / "run");
  std::ofstream(folder / "run" / "run.ini", std::ios::binary) << run_file;
  const std::string command =
      "cd '" + (folder / "run").string() + "' && '" ROULEAU_SOLVER "' " + arguments + " > ../out 2> ../err < /dev/null";
  const int status = std::system(command.c_str());
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(folder / "out"), content(folder / "err"), {}};
  for (const auto& entry : fs::directory_iterator(folder / "run"))
    if (entry.path().filename() != "run.ini") outcome.left_behind.push_back(entry.path().filename());
  return outcome;
}

class SolverTest : public testing::TestWithParam<BadRunFile> {
 protected:
  // Starting MPI is mostly waiting, so the whole table runs several at a time before the cases look at their outcomes.
  static void SetUpTestSuite() {
    std::string name = (fs::temp_directory_path() / "bad_run_files_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    const auto table = bad_run_files();
    for (const auto& bad : table) outcomes_[bad.name];
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < table.size(); i = next++)
        outcomes_.at(table[i].name) = run_solver(fs::path(name) / table[i].name, text_of(table[i]), "run.ini");
    };
    std::vector<std::jthread> workers;
    for (int i = 0; i < 8; ++i) workers.emplace_back(work);
    workers.clear();  // joins
    good_ = run_solver(fs::path(name) / "good", text_of({"", {}, 0, {}}), "check run.ini --format json");
    fs::remove_all(name);
  }

  inline static std::map<std::string, Outcome> outcomes_;
  inline static Outcome good_;
};

TEST_P(SolverTest, RefusesWithExitCode65) {
  const BadRunFile& bad = GetParam();
  const Outcome& outcome = outcomes_.at(bad.name);
  EXPECT_EQ(good_.code, 0) << good_.err;  // else all would be refused for another reason
  EXPECT_THAT(good_.out, HasSubstr("\"identity\""));
  EXPECT_EQ(outcome.code, 65);
  EXPECT_THAT(outcome.err, HasSubstr("run.ini:" + std::to_string(bad.line) + ": "));
  for (const auto& part : bad.parts) EXPECT_THAT(outcome.err, HasSubstr(part));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_THAT(outcome.left_behind, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Table, SolverTest, testing::ValuesIn(bad_run_files()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace rouleau::test
