// SPDX-License-Identifier: BSD-3-Clause
// `rouleau export`: what its files hold, and what it does not write over.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "report/table.hpp"
#include "store/store.hpp"
#include "three_points.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::content_of;
using ::rouleau::testing::set_content;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::json;
using testing::Answer;
using testing::call;

class ExportTest : public ::testing::Test {
 protected:
  Answer exported(std::vector<std::string> words) const {
    words.insert(words.begin(), "export");
    words.insert(words.end(), {"--dir", points_.path()});
    return call(words);
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return place_.path() / name; }
  [[nodiscard]] std::string rows(const std::filesystem::path& database, const std::string& sql) const {
    std::string text;
    for (const std::vector<Value>& row : Database(database, Access::read_only).select(sql).rows) {
      for (const Value& value : row) text += exact_text(value) + " ";
      text.back() = '\n';
    }
    return text;
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(place_.path()))
      names.push_back(entry.path().filename().string());
    return names;
  }

  testing::ThreePoints points_;
  ::rouleau::testing::TemporaryDirectory place_;
};

TEST_F(ExportTest, TextHasPointsOrSamples) {
  EXPECT_THAT(exported({}).out, HasSubstr("\r\n1,000000abc001,done,"));
  const Json samples = Json::parse(exported({"--samples", "--where", "lambda = 5", "--format", "json"}).out);
  EXPECT_EQ(samples["rows"].size(), 1001U);
  EXPECT_EQ(exported({"--samples", "-o", file("samples.csv")}).code, 0);
  const std::string text = content_of(file("samples.csv"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2003);
  EXPECT_EQ(exported({"--no-header", "--where", "lambda = 9"}).out.substr(0, 15), "9,000000abc009,");
}

TEST_F(ExportTest, SqliteHoldsTheSameNumbersAsTheCampaign) {
  ASSERT_EQ(exported({"--format", "sqlite", "-o", file("all.sqlite")}).code, 0);
  for (const char* view : {"v_points", "v_phase", "v_samples"}) {
    const std::string sql = std::string("SELECT * FROM ") + view + " ORDER BY ordinal";
    const std::string wanted = rows(points_.path() / "campaign.db", sql);
    EXPECT_EQ(rows(file("all.sqlite"), sql), wanted) << view;
    EXPECT_THAT(wanted, ::testing::Not(IsEmpty()));
  }
  const std::string attempts = "SELECT ordinal, attempt, state, host, reason, wall_s, core_h, version FROM v_attempts";
  EXPECT_EQ(rows(file("all.sqlite"), attempts), rows(points_.path() / "campaign.db", attempts));
  const std::string study = "SELECT study_text, study_digest, version, git FROM campaign";
  EXPECT_EQ(rows(file("all.sqlite"), study), rows(points_.path() / "campaign.db", study));
  EXPECT_EQ(rows(file("all.sqlite"), "PRAGMA integrity_check"), "ok\n");
  EXPECT_EQ(rows(file("all.sqlite"), "PRAGMA foreign_key_check"), "");
}

TEST_F(ExportTest, SqliteHasOneViewOfAllColumnsOfTheCsv) {
  ASSERT_EQ(exported({"--format", "sqlite", "-o", file("all.sqlite")}).code, 0);
  const Rows all = Database(file("all.sqlite"), Access::read_only).select("SELECT * FROM v_all ORDER BY ordinal, cell");
  std::ostringstream csv;
  write_csv(csv, {"", all.columns, all.rows}, true);
  EXPECT_EQ(csv.str(), exported({}).out);
  EXPECT_EQ(rows(file("all.sqlite"), "SELECT lambda, shape FROM v_all WHERE ordinal = 5"), "5 sphere\n");
}

TEST_F(ExportTest, SqliteLeavesOutWhatOnlyTheCampaignCanUse) {
  ASSERT_EQ(exported({"--format", "sqlite", "-o", file("all.sqlite")}).code, 0);
  EXPECT_EQ(rows(points_.path() / "campaign.db", "SELECT count(*) FROM attempt WHERE token != ''"), "2\n");
  EXPECT_EQ(rows(file("all.sqlite"),
                 "SELECT count(*) FROM attempt WHERE token != '' OR boot_id != '' OR pid != 0 OR start_ticks != 0"),
            "0\n");
  EXPECT_EQ(content_of(file("all.sqlite")).find("token1"), std::string::npos);
  EXPECT_EQ(content_of(file("all.sqlite")).find(points_.path()), std::string::npos) << "a path of this machine";
}

TEST_F(ExportTest, SqliteHoldsTheChosenPointsOnly) {
  ASSERT_EQ(exported({"--format", "sqlite", "--where", "lambda > 1", "-o", file("some.sqlite")}).code, 0);
  EXPECT_EQ(rows(file("some.sqlite"), "SELECT ordinal FROM v_points ORDER BY 1"), "5\n9\n");
  for (const char* table : {"parameter", "attempt", "sample", "result", "event"})
    EXPECT_EQ(rows(file("some.sqlite"), fmt::format("SELECT count(*) FROM {} WHERE point = 1", table)), "0\n") << table;
  EXPECT_EQ(rows(file("some.sqlite"), "SELECT value FROM setting WHERE name = 'export.where'"), "lambda > 1\n");
}

TEST_F(ExportTest, AnSqliteFileCanBeAskedByRouleauElsewhere) {
  ASSERT_EQ(exported({"--format", "sqlite", "-o", file("campaign.db")}).code, 0);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"query", "--format", "csv"}, {"query", "--window", "0.2", "--format", "csv"}}) {
    std::vector<std::string> here = words, there = words;
    here.push_back(points_.path());
    there.push_back(place_.path());
    EXPECT_EQ(call(there).code, 0);
    EXPECT_EQ(call(there).out, call(here).out);
  }
}

TEST_F(ExportTest, AnExistingFileIsReplacedOnlyWhenAskedFor) {
  for (const char* format : {"csv", "sqlite"}) {
    set_content(file("kept"), "precious");
    Answer answer = exported({"--format", format, "-o", file("kept")});
    EXPECT_EQ(answer.code, 2);
    EXPECT_THAT(answer.err, HasSubstr("kept: exists already; --overwrite replaces it"));
    EXPECT_EQ(content_of(file("kept")), "precious");
    answer = exported({"--format", format, "--overwrite", "-o", file("kept")});
    EXPECT_EQ(answer.code, 0) << answer.err;
    EXPECT_NE(content_of(file("kept")), "precious");
    EXPECT_THAT(files(), ::testing::ElementsAre("kept"));
  }
}

TEST_F(ExportTest, WhatItMayNotReplaceIsNeverReplaced) {
  std::filesystem::create_symlink(file("elsewhere"), file("link"));
  const std::string before = content_of(points_.path() / "campaign.db");
  for (const std::filesystem::path& taken : {points_.path() / "campaign.db", file("link"), place_.path()}) {
    const Answer answer = exported({"--format", "sqlite", "--overwrite", "-o", taken});
    EXPECT_EQ(answer.code, 2) << taken;
    EXPECT_THAT(answer.err, HasSubstr("name another")) << taken;
  }
  EXPECT_EQ(content_of(points_.path() / "campaign.db"), before);
}

TEST_F(ExportTest, MistakesAreNamedAndLeaveNoFile) {
  const auto refused = [&](const std::vector<std::string>& words, int code, const std::string& part) {
    const Answer answer = exported(words);
    EXPECT_EQ(answer.code, code) << part;
    EXPECT_THAT(answer.err, HasSubstr(part));
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
  };
  refused({"--format", "table"}, 2, "`rouleau query` prints tables");
  refused({"--format", "sqlit"}, 2, "Did you mean `sqlite`?");
  refused({"--format", "sqlite"}, 2, "needs a file's name");
  refused({"--format", "sqlite", "--samples", "-o", file("x")}, 2, "leave --samples out");
  refused({"-o", file("no") / "such" / "x"}, 2, "make it first");
  refused({"-o", file("x"), "--where", "lambda = 7"}, 3, "no point matches `lambda = 7`");
  refused({"-o", file("x"), "--where", "lamda = 7"}, 2, "Did you mean `lambda`?");
  EXPECT_THAT(files(), IsEmpty());
}

/// The exit code of `rouleau export WORDS` in a process that may write files of so many bytes only; stderr to `err`.
int exported_without_room(const std::vector<std::string>& words, rlim_t bytes, const std::filesystem::path& err) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);  // so that the write fails instead, as on a full disk
    const Answer answer = [&] {
      const rlimit limit{bytes, RLIM_INFINITY};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      return call(words);
    }();
    const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
    ::setrlimit(RLIMIT_FSIZE, &none);
    set_content(err, answer.err);
    ::_exit(answer.code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(ExportTest, WithoutRoomItSaysSoOnceAndLeavesNothing) {
  const ::rouleau::testing::TemporaryDirectory messages;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--format", "sqlite"}, {"--samples"}, {"--samples", "--format", "json"}}) {
    std::vector<std::string> command = {"export", "--dir", points_.path(), "-o", file("x")};
    command.insert(command.end(), words.begin(), words.end());
    EXPECT_EQ(exported_without_room(command, 60000, messages.path() / "err"), 1);
    const std::string message = content_of(messages.path() / "err");
    EXPECT_THAT(message, HasSubstr(file("x").string()));
    EXPECT_THAT(message, HasSubstr("room"));
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
    EXPECT_THAT(files(), IsEmpty());
  }
}

}  // namespace
}  // namespace rouleau::campaign
