// SPDX-License-Identifier: BSD-3-Clause
// Names and paths out of a study file stay words: none leaves the campaign's directory, none reaches a shell.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <set>

#include "support/campaign_program.hpp"

namespace rouleau::campaign {
namespace {

namespace fs = std::filesystem;
using rouleau::testing::CampaignProgram;
using rouleau::testing::content_of;
using rouleau::testing::set_content;
using ::testing::HasSubstr;

/// Each would leave a file `struck` behind, or one outside, if anything took it for more than a word.
const std::vector<std::string> hostile = {
    "../x",
    "a/b",
    "/struck",
    "$(touch struck)",
    "`touch struck`",
    ";touch struck",
    "|touch struck",
    "&touch struck",
    "> struck",
    "-rf",
    "..",
    "~",
    "%n%s",
    "a\\nb",
    "'\"; touch struck",
    "\xff\xfe",
    std::string(5000, 'a'),
};

class HostileNames : public ::testing::Test {
 protected:
  /// Everything beside the campaign, and every file called `struck`.
  std::set<std::string> beside() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(program_.path())) {
      const std::string name = entry.path().lexically_relative(program_.path()).string();
      if (!name.starts_with("c/") && name != "c") names.insert(name);
      EXPECT_NE(entry.path().filename(), "struck");
    }
    return names;
  }
  /// Makes and runs the study as it stands: nothing may happen outside of c.
  CampaignProgram::Capture make() {
    fs::remove_all(program_.campaign());
    const std::set<std::string> before = beside();
    const CampaignProgram::Capture made = program_.init();
    if (made.status == 0) static_cast<void>(program_.run());
    EXPECT_EQ(beside(), before);
    EXPECT_LT(made.status, 8) << "init died: " << made.err;
    return made;
  }
  CampaignProgram program_;
};

TEST_F(HostileNames, OfTheStudyAreRefusedWithTheirLineOrPlain) {
  for (const std::string& name : hostile) {
    program_.write_study("fluid.lambda = 5", CampaignProgram::execution());
    std::string text = content_of(program_.study());
    text.replace(text.find("name = small"), 12, "name = " + name);
    set_content(program_.study(), text);
    const auto made = make();
    const bool is_plain = name == ".." || name == "-rf";
    EXPECT_EQ(made.status, is_plain ? 0 : 2) << name;
    if (!is_plain) {
      EXPECT_THAT(made.err, HasSubstr("study.ini:2: ")) << name;
    }
  }
}

TEST_F(HostileNames, OfValuesAndParametersStayWords) {
  for (const std::string& name : hostile) {
    program_.write_study("fluid.lambda = " + name, CampaignProgram::execution());
    EXPECT_NE(make().status, 0) << name;
    program_.write_study("fluid." + name + " = 1, 2", CampaignProgram::execution());
    EXPECT_NE(make().status, 0) << name;
    program_.write_study(name + ".lambda = 1, 2", CampaignProgram::execution());
    EXPECT_NE(make().status, 0) << name;
  }
}

TEST_F(HostileNames, OfMeshFilesAreCopiedUnderTheirDigest) {
  for (const std::string& name : hostile) {
    if (name.find('/') != std::string::npos || name == ".." || name.size() > 200) continue;
    set_content(program_.path() / (name + ".off"), "OFF");
    program_.write_study("fluid.lambda = 5", CampaignProgram::execution() + "[cell]\nmesh_file = " + name + ".off\n");
    const auto made = make();
    if (name == "\xff\xfe") continue;  // no text: that is the solver's to say
    EXPECT_EQ(made.status, 0) << name << ": " << made.err;
    EXPECT_EQ(program_.state(1), State::done) << name;
  }
}

TEST_F(HostileNames, OfFilesWithoutEndOrContentAreRefusedAtOnce) {
  ASSERT_EQ(::mkfifo((program_.path() / "pipe").c_str(), 0600), 0);
  for (const char* name : {"/dev/zero", "/dev/stdin", "pipe", ".", "..", "/", "/proc/self/mem", "nothing.off"}) {
    program_.write_study("fluid.lambda = 5", CampaignProgram::execution() + "[cell]\nmesh_file = " + name + "\n");
    const auto made = make();
    EXPECT_NE(made.status, 0) << name;
    EXPECT_THAT(made.err, HasSubstr(name)) << made.err;
  }
}

TEST_F(HostileNames, OfTheCampaignsOwnDirectoryAreWordsToo) {
  const std::string odd = "c $(touch struck) `touch struck`;touch struck&'\"\n*";
  program_.write_study("fluid.lambda = 1, 5", CampaignProgram::execution());
  for (const char* verb : {"init", "run", "status", "verify", "rebuild"}) {
    const auto answer =
        std::string(verb) == "init" ? program_.rouleau({"init", "study.ini", odd}) : program_.rouleau({verb, odd});
    EXPECT_EQ(answer.status, 0) << verb << answer.err;
  }
  EXPECT_TRUE(fs::exists(program_.path() / odd / "campaign.db"));
  static_cast<void>(beside());
}

}  // namespace
}  // namespace rouleau::campaign
