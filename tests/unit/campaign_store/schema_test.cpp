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

/// The tables of version 2, whose attempts know no engine.
void make_version_2(const std::filesystem::path& file) {
  const Database database(file, Access::read_write);
  database.execute("DROP VIEW v_attempts;");
  for (const char* column : {"engine", "job_id", "job_state"})
    database.execute(fmt::format("ALTER TABLE attempt DROP COLUMN {};", column));
  database.execute("CREATE VIEW v_attempts AS SELECT * FROM attempt; PRAGMA user_version = 2;");
}

/// The tables of version 1, whose samples have no shape and no markers.
void make_version_1(const std::filesystem::path& file) {
  make_version_2(file);
  const Database database(file, Access::read_write);
  database.execute("DROP VIEW v_phase; DROP VIEW v_samples;");
  for (const char* column :
       {"taylor_deformation", "angle_xz_deg", "angle_xy_deg", "extent_x_um", "extent_y_um", "extent_z_um",
        "marker_y_dx_um", "marker_y_dy_um", "marker_y_dz_um", "marker_z_dx_um", "marker_z_dy_um", "marker_z_dz_um"})
    database.execute(fmt::format("ALTER TABLE sample DROP COLUMN {};", column));
  for (const char* column : {"tank_treading_per_s", "tank_treading_error_per_s", "tank_treading_reason"})
    database.execute(fmt::format("ALTER TABLE result DROP COLUMN {};", column));
  database.execute(
      "CREATE VIEW v_phase AS SELECT * FROM result; CREATE VIEW v_samples AS SELECT * FROM sample;"
      "PRAGMA user_version = 1;");
}

std::vector<std::string> columns_of(const Database& database, const char* table) {
  return database.select(fmt::format("SELECT * FROM {}", table)).columns;
}

TEST_F(SchemaTest, VersionOneBecomesWhatANewFileIsAndReadsItsSamplesAnew) {
  const PointRow point = testing::a_point(1);
  {
    Store store = Store::open(file_);
    store.add_point(point, testing::its_parameters(point), "added");
    store.put_samples(point.key, std::vector<SampleRow>{testing::a_sample(0, 0.5)});
    store.set_sample_mark(point.key, {120, "abc"});
  }
  make_version_1(file_);
  EXPECT_THAT(error_of([&] { Store::open_reader(file_); }), HasSubstr("rouleau sync"));

  const Store migrated = Store::open(file_);
  const std::filesystem::path fresh_file = directory_.path() / "fresh.db";
  const Store fresh = Store::create(fresh_file, testing::a_campaign());
  for (const char* table : {"attempt", "sample", "result", "v_points", "v_phase", "v_samples", "v_attempts"})
    EXPECT_EQ(columns_of(migrated.database(), table), columns_of(fresh.database(), table)) << table;
  EXPECT_EQ(migrated.point(point.key), point);
  EXPECT_TRUE(migrated.samples(point.key).empty());
  EXPECT_EQ(migrated.sample_mark(point.key), SampleMark());
}

TEST_F(SchemaTest, AttemptsOfVersionTwoWereOfThisMachine) {
  const PointRow point = testing::a_point(1);
  AttemptRow attempt;
  attempt.point = point.key;
  attempt.number = 1;
  {
    Store store = Store::open(file_);
    store.add_point(point, testing::its_parameters(point), "added");
    store.put_attempt(attempt);
  }
  make_version_2(file_);
  const Store migrated = Store::open(file_);
  EXPECT_EQ(migrated.attempts(point.key), std::vector<AttemptRow>{attempt});
  EXPECT_EQ(migrated.attempts(point.key).front().engine, local_engine);
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
