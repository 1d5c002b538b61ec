// SPDX-License-Identifier: BSD-3-Clause
// `cmake --install` as its user meets it: a prefix that is moved afterwards, programs, manual and completion from
// there.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>

#include "support/process.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Words = std::vector<std::string>;

/// One installation for all tests; each looks at it only.
class InstallTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    place_ = std::make_unique<TemporaryDirectory>();
    const Finished done = run_program(
        {CMAKE_PROGRAM, "--install", BUILD_FOLDER, "--strip", "--prefix", (place_->path() / "elsewhere").string()});
    ASSERT_EQ(done.code, 0) << done.out << done.err;
    fs::rename(place_->path() / "elsewhere", prefix());
  }
  static void TearDownTestSuite() { place_.reset(); }

  static fs::path prefix() { return place_->path() / "p"; }

  /// Runs words in a directory of this test, with nothing on the PATH but the installation and the system's programs.
  [[nodiscard]] Finished in_shell(const Words& words, const std::string& first_on_path = bin()) const {
    Words command = {"env",
                     "-i",
                     "-C",
                     work_.path(),
                     "TERM=dumb",
                     "HOME=" + work_.path().string(),
                     "LC_ALL=C.UTF-8",
                     "PATH=" + first_on_path + ":/usr/bin:/bin:/usr/sbin:/sbin"};
    for (const char* name : {"ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS"})
      if (const char* value = std::getenv(name)) command.push_back(fmt::format("{}={}", name, value));
    command.insert(command.end(), words.begin(), words.end());
    return run_program(command);
  }
  /// Types keys into an interactive shell; returns what it drew.
  [[nodiscard]] std::string type(const std::string& shell, const std::string& keys) const {
    set_content(work_.path() / "keys", keys + "exit\n");
    const Finished done = in_shell({"bash", "-c", "script -qec '" + shell + "' /dev/null < keys"});
    return done.out + done.err;
  }
  void write_study() const {
    set_content(
        work_.path() / "study.ini",
        "[study]\nname = small\n[sweep]\nfluid.lambda = 1, 20\n[channel]\nlength_x_um = 16\nlength_y_um = 12\n"
        "length_z_um = 10\n[flow]\nmean_velocity_mm_per_s = 1.5\ninitial = developed\n[cell]\nsubdivisions = 3\n"
        "offset_y_um = 0.5\n[membrane]\nbending_modulus_J = 1e-18\n[numerics]\nnode_spacing_um = 2/3\n"
        "time_step_us = 1.25\n[time]\nend_time_s = 0.0005\n[output]\nsample_interval_steps = 20\n"
        "[execution]\njobs = 2\noversubscribe = 1\n[analysis]\nwindow_s = 0.0002\n"
        "oscillation_window_s = 0.0004\n");
    const Finished made = in_shell({"rouleau", "init", "study.ini", "c"});
    ASSERT_EQ(made.code, 0) << made.err;
  }
  [[nodiscard]] std::string written(const char* file) const { return content_of(work_.path() / file); }

  static std::string bin() { return (prefix() / "bin").string(); }
  static fs::path man(const std::string& page) {
    return prefix() / "share/man" / ("man" + page.substr(page.size() - 1)) / page;
  }

  TemporaryDirectory work_;

 private:
  static inline std::unique_ptr<TemporaryDirectory> place_;
};

/// All words of a text that are long options.
std::set<std::string> options_in(const std::string& text) {
  std::set<std::string> options;
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 2)) {
    std::size_t end = at + 2;
    while (end < text.size() && (std::islower(static_cast<unsigned char>(text[end])) != 0 || text[end] == '-')) ++end;
    if (end > at + 2 && text[end - 1] != '-') options.insert(text.substr(at, end - at));
  }
  return options;
}

Words verbs_in(const std::string& help) {
  Words verbs;
  std::istringstream lines(help.substr(help.find("\nVerbs")));
  std::string line;
  std::getline(lines, line);
  for (std::getline(lines, line); std::getline(lines, line) && line.starts_with("  ");)
    verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
  return verbs;
}

TEST_F(InstallTest, ProgramsRunACampaignToItsEnd) {
  write_study();
  const Finished run = in_shell({"rouleau", "run", "c"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(in_shell({"rouleau", "query", "c", "--columns", "state", "--format", "csv", "--no-header"}).out,
            "done\r\ndone\r\n");
}

TEST_F(InstallTest, SolverIsTheOneBesideRouleauThroughASymbolicLinkToo) {
  write_study();
  fs::create_directories(work_.path() / "links");
  fs::create_symlink(prefix() / "bin/rouleau", work_.path() / "links/rouleau");
  EXPECT_EQ(in_shell({"rouleau", "plan", "study.ini"}, (work_.path() / "links").string()).code, 0);
}

TEST_F(InstallTest, WithoutItsSolverRouleauFindsNoOther) {
  fs::create_directories(work_.path() / "alone");
  fs::copy(prefix() / "bin/rouleau", work_.path() / "alone");
  set_content(work_.path() / "study.ini", "[study]\nname = s\n");
  const Finished answer = in_shell({"rouleau", "init", "study.ini", "c"}, (work_.path() / "alone").string());
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.err, HasSubstr("neither beside"));
}

TEST_F(InstallTest, NoFileNamesTheFoldersItWasMadeIn) {
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(prefix())) {
    if (!entry.is_regular_file()) continue;
    ++files;
#ifndef NDEBUG
    if (entry.path().parent_path().filename() == "bin") continue;  // assertions name their files
#endif
    const std::string bytes = content_of(entry.path());
    for (const char* folder : {BUILD_FOLDER, SOURCE_FOLDER})
      EXPECT_EQ(bytes.find(folder), std::string::npos) << entry.path() << " names " << folder;
  }
  EXPECT_GT(files, 20);
}

TEST_F(InstallTest, HoldsContractLicenceClustersExamplesAndStudies) {
  for (const char* file :
       {"doc/rouleau/contract.md", "doc/rouleau/LICENSE", "doc/rouleau/database.md", "rouleau/clusters/small.ini",
        "rouleau/examples/README.md", "rouleau/studies/quick/study.ini"})
    EXPECT_TRUE(fs::is_regular_file(prefix() / "share" / file)) << file;
}

TEST_F(InstallTest, StagesBelowDestdir) {
  const std::string stage = "DESTDIR=" + work_.path().string();
  const Finished done = in_shell({"env", stage, CMAKE_PROGRAM, "--install", BUILD_FOLDER, "--prefix", "/opt/r"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(fs::is_regular_file(work_.path() / "opt/r/bin/rouleau"));
}

TEST_F(InstallTest, ManualPagesAreReadWithoutAWarning) {
  for (const char* page :
       {"rouleau.1", "rouleau-solver.1", "rouleau-study.5", "rouleau-cluster.5", "rouleau-run-file.5"}) {
    const Finished shown = in_shell({"man", "--warnings", "-E", "UTF-8", "-l", man(page).string()});
    EXPECT_EQ(shown.code, 0) << "is man-db installed? " << shown.err;
    EXPECT_EQ(shown.err, "") << page;
    EXPECT_THAT(shown.out, HasSubstr("SEE ALSO")) << page;
  }
}

TEST_F(InstallTest, ManualIsFoundBesideTheProgramsOnThePath) {
  const Finished found = in_shell({"man", "-w", "rouleau"});
  EXPECT_EQ(found.out, man("rouleau.1").string() + "\n") << found.err;
}

TEST_F(InstallTest, ManualAndCompletionKnowEveryVerbAndOption) {
  // Warped lines would cut options in two.
  const auto text = [&](const char* page) {
    return in_shell({"env", "MANWIDTH=1000", "man", "-E", "ascii", "-l", man(page).string()}).out;
  };
  const std::string manual = text("rouleau.1");
  const Words verbs = verbs_in(in_shell({"rouleau", "--help"}).out);
  EXPECT_GE(verbs.size(), 16U);
  for (const std::string& verb : verbs) {
    EXPECT_THAT(manual, HasSubstr("rouleau " + verb)) << verb;
    const std::string candidates = in_shell({"rouleau", "--complete", verb, "--"}).out;
    const std::string help = in_shell({"rouleau", verb, "--help"}).out;
    const std::set<std::string> options = options_in(help.substr(help.find("\nOptions")));
    EXPECT_THAT(options, Not(IsEmpty())) << verb;
    for (const std::string& option : options) {
      EXPECT_THAT(manual, HasSubstr(option)) << verb;
      if (help.find("  " + option) == std::string::npos && help.find(", " + option) == std::string::npos) continue;
      EXPECT_THAT("\n" + candidates, HasSubstr("\n" + option + "\t")) << verb;
    }
  }
  const std::string help = in_shell({"rouleau-solver", "--help"}).out;
  const std::string solver_manual = text("rouleau-solver.1");
  const std::string candidates = in_shell({"rouleau-solver", "--complete", "--"}).out;
  for (const std::string& option : options_in(help)) {
    EXPECT_THAT(solver_manual, HasSubstr(option));
    EXPECT_THAT("\n" + candidates, HasSubstr("\n" + option + "\t"));
  }
}

const char* const keys =
    "rouleau que\tc --columns stat\t --form\tcsv --no-h\t > columns\n"
    "rouleau show -C c lambda=2\t --form\tcsv > values\n"
    "rouleau show -C c '#1\t --format=cs\t > quoted\n"
    "rouleau show -C c \\#2\t --format=cs\t > escaped\n"
    "rouleau-solver che\tr\t --format=js\t > checked\n"
    "rouleau query --dir=one-cam\t --where=state=wai\t --format=csv --no-h\t --columns ordinal > directory\n";

TEST_F(InstallTest, CompletionWorksInBashAndZsh) {
  write_study();
  fs::rename(work_.path() / "c", work_.path() / "one-campaign");
  fs::create_directory_symlink(work_.path() / "one-campaign", work_.path() / "c");
  const auto point = fs::directory_iterator(work_.path() / "c/points")->path();
  fs::copy_file(point / "run.ini", work_.path() / "run.ini");
  const std::string share = (prefix() / "share").string();
  const std::pair<std::string, std::string> shells[] = {
      {"bash --norc --noprofile -i", "source " + share + "/bash-completion/completions/rouleau\n"},
      {"zsh -f -i", "fpath=(" + share + "/zsh/site-functions $fpath); autoload -U compinit; compinit -u -D\n"}};
  for (const auto& [shell, preparation] : shells) {
    const std::string drawn = type(shell, preparation + keys);
    SCOPED_TRACE(shell + ":\n" + drawn);
    EXPECT_EQ(written("columns"), "waiting\r\nwaiting\r\n");
    EXPECT_THAT(written("values"), HasSubstr("fluid.lambda = 20"));
    EXPECT_THAT(written("quoted"), HasSubstr("fluid.lambda = 1\r"));
    EXPECT_THAT(written("escaped"), HasSubstr("fluid.lambda = 20"));
    EXPECT_THAT(written("checked"), HasSubstr("\"contract\": 1"));
    EXPECT_EQ(written("directory"), "1\r\n2\r\n");
    for (const char* file : {"columns", "values", "quoted", "escaped", "checked", "directory"})
      fs::remove(work_.path() / file);
  }
}

}  // namespace
}  // namespace rouleau::testing
