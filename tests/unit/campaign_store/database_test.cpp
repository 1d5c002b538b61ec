// SPDX-License-Identifier: BSD-3-Clause
// The connection: waiting, killed writers, damage.
#include "store/database.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <limits>

#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::TemporaryDirectory;
using ::testing::HasSubstr;

template <class Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

double seconds_of(const std::function<void()>& action) {
  const auto begin = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

class DatabaseTest : public ::testing::Test {
 protected:
  DatabaseTest() : file_(directory_.path() / "campaign.db") {
    const Database database(file_, Access::create);
    database.execute("CREATE TABLE t (a INTEGER PRIMARY KEY, b TEXT); INSERT INTO t VALUES (1, 'one');");
  }

  TemporaryDirectory directory_;
  std::filesystem::path file_;
};

TEST_F(DatabaseTest, WriterIsDurableAndChecksForeignKeys) {
  const Database database(file_, Access::read_write);
  EXPECT_EQ(std::get<std::string>(database.select("PRAGMA journal_mode").rows[0][0]), "delete");
  EXPECT_EQ(database.select_integer("PRAGMA synchronous"), 3);  // EXTRA
  EXPECT_EQ(database.select_integer("PRAGMA foreign_keys"), 1);
  EXPECT_EQ(database.select_integer("PRAGMA trusted_schema"), 0);
}

TEST_F(DatabaseTest, ReaderCannotWrite) {
  const Database reader(file_, Access::read_only);
  EXPECT_THAT(error_of([&] { reader.execute("INSERT INTO t VALUES (2, 'two');"); }), HasSubstr("readonly"));
}

TEST_F(DatabaseTest, ReaderDoesNotDisturbAWriterBetweenItsReads) {
  const Database reader(file_, Access::read_only);
  EXPECT_EQ(reader.select_integer("SELECT count(*) FROM t"), 1);
  const Database writer(file_, Access::read_write);
  // A commit would wait for a lock that the reader still held.
  const double waited = seconds_of([&] { writer.execute("INSERT INTO t VALUES (2, 'two');"); });
  EXPECT_LT(waited, 1.0);
  EXPECT_EQ(reader.select_integer("SELECT count(*) FROM t"), 2);
}

TEST_F(DatabaseTest, ReaderReadsWhileATransactionIsOpen) {
  const Database writer(file_, Access::read_write);
  const Transaction transaction(writer);
  writer.execute("INSERT INTO t VALUES (2, 'two');");
  const Database reader(file_, Access::read_only);
  EXPECT_EQ(reader.select_integer("SELECT count(*) FROM t"), 1);
}

TEST_F(DatabaseTest, ReaderGivesUpAfterASecond) {
  const Database writer(file_, Access::read_write);
  const Database reader(file_, Access::read_only);
  writer.execute("BEGIN EXCLUSIVE;");
  std::string error;
  const double waited =
      seconds_of([&] { error = error_of([&] { (void)reader.select_integer("SELECT count(*) FROM t"); }); });
  EXPECT_THAT(error, HasSubstr("another process is writing"));
  EXPECT_LT(waited, 2.0);  // the busy time-out is 1 s; the rest is a loaded machine
}

TEST_F(DatabaseTest, ReaderNamesTheWriterThatItCannotWaitFor) {
  const std::filesystem::path lock = directory_.path() / ".lock";
  ::rouleau::testing::set_content(lock, "`rouleau run` (process 7 on node)\n");
  const Database writer(file_, Access::read_write);
  writer.execute("BEGIN EXCLUSIVE;");
  const auto error_of_reader = [&] { return error_of([&] { Database(file_, Access::read_only); }); };
  EXPECT_THAT(error_of_reader(), HasSubstr("another process is writing")) << "that of an earlier holder";
  const int held = ::open(lock.c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  EXPECT_THAT(error_of_reader(), HasSubstr("`rouleau run` (process 7 on node) is writing; try again in a moment"));
  ::close(held);
}

TEST_F(DatabaseTest, ReaderWaitsOneSecondInAllItsStatementsTogether) {
  const Database writer(file_, Access::read_write);
  const Database reader(file_, Access::read_only);
  writer.execute("BEGIN EXCLUSIVE;");
  const double waited = seconds_of([&] {
    for (int i = 0; i < 10; ++i)
      EXPECT_NE(error_of([&] { (void)reader.select_integer("SELECT 1 FROM t"); }), "no error");
  });
  EXPECT_LT(waited, 5.0);  // ten statements of a second each would take ten
}

TEST_F(DatabaseTest, TransactionWithoutCommitLeavesNothing) {
  const Database database(file_, Access::read_write);
  {
    const Transaction transaction(database);
    database.execute("INSERT INTO t VALUES (2, 'two');");
  }
  EXPECT_EQ(database.select_integer("SELECT count(*) FROM t"), 1);
}

TEST_F(DatabaseTest, InnerTransactionLeavesTheDecisionToTheOuterOne) {
  const Database database(file_, Access::read_write);
  {
    const Transaction outer(database);
    Transaction inner(database);
    database.execute("INSERT INTO t VALUES (2, 'two');");
    inner.commit();
  }
  EXPECT_EQ(database.select_integer("SELECT count(*) FROM t"), 1);
}

TEST_F(DatabaseTest, SnapshotSeesOneStateOnly) {
  const Database reader(file_, Access::read_only);
  const Database writer(file_, Access::read_write);
  {
    const Snapshot snapshot(reader);
    EXPECT_EQ(reader.select_integer("SELECT count(*) FROM t"), 1);
    writer.execute("PRAGMA busy_timeout = 1;");
    EXPECT_THAT(error_of([&] { writer.execute("INSERT INTO t VALUES (2, 'two');"); }), HasSubstr("try again"));
    EXPECT_EQ(reader.select_integer("SELECT count(*) FROM t"), 1);
  }
  writer.execute("INSERT INTO t VALUES (2, 'two');");
  EXPECT_EQ(reader.select_integer("SELECT count(*) FROM t"), 2);
}

/// Leaves what a `kill -9` in the middle of a commit leaves: changed pages in the file, the old ones in the journal.
void kill_a_writer_in_its_transaction(const std::filesystem::path& file) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const Database writer(file, Access::read_write);
    writer.execute("PRAGMA cache_size = 5;");  // so that pages reach the file before the commit
    writer.execute("BEGIN IMMEDIATE;");
    writer.execute(
        "WITH RECURSIVE n (i) AS (SELECT 10 UNION ALL SELECT i + 1 FROM n WHERE i < 5000) "
        "INSERT INTO t SELECT i, hex(zeroblob(200)) FROM n;");
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(std::filesystem::exists(file.string() + "-journal"));
}

TEST_F(DatabaseTest, ReaderRollsBackWhatAKilledWriterLeft) {
  kill_a_writer_in_its_transaction(file_);
  const Database reader(file_, Access::read_only);
  EXPECT_EQ(reader.select_integer("SELECT count(*) FROM t"), 1);
  EXPECT_FALSE(std::filesystem::exists(file_.string() + "-journal"));
}

TEST_F(DatabaseTest, ReaderOpenedEarlierSaysWhatToDoAboutAKilledWriter) {
  const Database reader(file_, Access::read_only);
  kill_a_writer_in_its_transaction(file_);
  EXPECT_THAT(error_of([&] { (void)reader.select_integer("SELECT count(*) FROM t"); }), HasSubstr("campaign.db"));
}

TEST_F(DatabaseTest, FileThatIsNoDatabaseIsNamedWithTheRemedy) {
  const std::filesystem::path other = directory_.path() / "other.db";
  ::rouleau::testing::set_content(other, std::string(5000, 'x'));
  const std::string error = error_of([&] { Database(other, Access::read_write); });
  EXPECT_THAT(error, HasSubstr("other.db"));
  EXPECT_THAT(error, HasSubstr("rouleau rebuild"));
}

TEST_F(DatabaseTest, MissingFileIsNotMade) {
  const std::filesystem::path missing = directory_.path() / "missing.db";
  EXPECT_THAT(error_of([&] { Database(missing, Access::read_write); }), HasSubstr("rouleau init"));
  EXPECT_FALSE(std::filesystem::exists(missing));
}

TEST_F(DatabaseTest, ExistingFileIsNotMadeAnew) {
  EXPECT_THAT(error_of([&] { Database(file_, Access::create); }), HasSubstr("exists already"));
}

TEST_F(DatabaseTest, ValuesComeBackBitByBit) {
  const Database database(file_, Access::read_write);
  database.execute("CREATE TABLE v (x REAL)");
  const double value = 0.1 + 0.2;
  database.prepare("INSERT INTO v VALUES (?)").bind(value).run();
  EXPECT_EQ(std::get<double>(database.select("SELECT x FROM v").rows[0][0]), value);
}

TEST_F(DatabaseTest, NumberThatIsNotFiniteIsRefusedRatherThanStoredAsNull) {
  const Database database(file_, Access::read_write);
  Statement statement = database.prepare("SELECT ?");
  EXPECT_THROW(statement.bind(std::numeric_limits<double>::quiet_NaN()), std::logic_error);
}

}  // namespace
}  // namespace rouleau::campaign
