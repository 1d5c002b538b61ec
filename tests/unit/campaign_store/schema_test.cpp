// SPDX-License-Identifier: BSD-3-Clause
// Versions of the schema: refused, migrated, backed up; and what the tables refuse to hold.
#include "store/schema.hpp"

#include <gmock/gmock.h>

#include <array>

#include "sample_rows.hpp"
#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::TemporaryDirectory;
using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

class SchemaTest : public ::testing::Test {
 protected:
  SchemaTest() : file_(directory_.path() / "campaign.db") { Store::create(file_, testing::a_campaign()); }

  TemporaryDirectory directory_;
  std::filesystem::path file_;
};

TEST_F(SchemaTest, NewerSchemaIsRefusedByReadersAndWriters) {
  Database(file_, Access::read_write).execute("PRAGMA user_version = 99;");
  for (const auto& open : {Store::open, Store::open_reader}) {
    const std::string error = error_of([&] { open(file_); });
    EXPECT_THAT(error, HasSubstr("newer rouleau (schema 99"));
    EXPECT_THAT(error, HasSubstr("rouleau rebuild"));
  }
}

TEST_F(SchemaTest, DatabaseOfAnotherProgramIsRefused) {
  Database(file_, Access::read_write).execute("PRAGMA application_id = 7;");
  EXPECT_THAT(error_of([&] { Store::open(file_); }), HasSubstr("not a campaign database"));
}

TEST_F(SchemaTest, MigrationGoesStepByStepBehindABackup) {
  const Database database(file_, Access::read_write);
  const std::array<Migration, 2> steps = {{{schema_version + 1, "ALTER TABLE extra ADD COLUMN second TEXT;"},
                                           {schema_version, "CREATE TABLE extra (first TEXT);"}}};
  migrate(database, steps, schema_version + 2);
  EXPECT_EQ(database.select_integer("PRAGMA user_version"), schema_version + 2);
  EXPECT_EQ(database.select("SELECT first, second FROM extra").columns.size(), 2U);
  const Database backup(file_.string() + fmt::format(".v{}.backup", schema_version), Access::read_only);
  EXPECT_EQ(backup.select_integer("PRAGMA user_version"), schema_version);
  EXPECT_EQ(backup.select_integer("SELECT count(*) FROM campaign"), 1);
}

TEST_F(SchemaTest, FailingMigrationChangesNothing) {
  const Database database(file_, Access::read_write);
  const std::array<Migration, 2> steps = {
      {{schema_version, "CREATE TABLE extra (first TEXT);"}, {schema_version + 1, "NO SUCH STATEMENT;"}}};
  EXPECT_THROW(migrate(database, steps, schema_version + 2), Error);
  EXPECT_EQ(database.select_integer("PRAGMA user_version"), schema_version);
  EXPECT_EQ(database.select_integer("SELECT count(*) FROM sqlite_schema WHERE name = 'extra'"), 0);
}

TEST_F(SchemaTest, MissingMigrationStepIsNamed) {
  const Database database(file_, Access::read_write);
  EXPECT_THAT(error_of([&] { migrate(database, {}, schema_version + 1); }), HasSubstr("cannot be brought to"));
}

TEST_F(SchemaTest, TablesRefuseWrongTypesAndUnknownStates) {
  Store store = Store::open(file_);
  const PointRow point = testing::a_point(1);
  store.add_point(point, testing::its_parameters(point), "added");
  const Database& database = store.database();
  for (const char* statement :
       {"UPDATE point SET state = 'sleeping';", "UPDATE point SET end_time_s = 'soon';",
        "INSERT INTO parameter VALUES (99, 'a', 'b', 1.0, 0, 1);",
        "INSERT INTO sample (point, step, cell, time_s, d_um, finite) VALUES (1, 0, 0, 0.0, 'far', 1);",
        "DELETE FROM event;", "UPDATE event SET evidence = 'other';"})
    EXPECT_NE(error_of([&] { database.execute(statement); }), "no error") << statement;
}

TEST_F(SchemaTest, ViewsHaveTheDocumentedColumns) {
  const Store store = Store::open_reader(file_);
  const auto columns = [&](const char* view) {
    return store.database().select(fmt::format("SELECT * FROM {}", view)).columns;
  };
  EXPECT_THAT(columns("v_points"), ::testing::IsSupersetOf({"ordinal", "key", "state", "lambda", "swept", "core_h"}));
  EXPECT_THAT(columns("v_phase"), ::testing::IsSupersetOf({"lambda", "class", "d_mean_um", "d_error_um", "window_s"}));
  EXPECT_THAT(columns("v_samples"), ::testing::IsSupersetOf({"lambda", "step", "cell", "time_s", "d_um"}));
  EXPECT_THAT(columns("v_attempts"), ::testing::IsSupersetOf({"attempt", "started_utc", "exit_code", "resumed_from"}));
}

}  // namespace
}  // namespace rouleau::campaign
