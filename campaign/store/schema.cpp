// SPDX-License-Identifier: BSD-3-Clause
// Creation, check and migration of the schema.
#include "store/schema.hpp"

#include <array>

#include "store/tables.hpp"
#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {
namespace {

/// A complete copy of the database in a file of its own, whole or absent.
void back_up(const Database& database, const std::filesystem::path& copy) {
  make_whole_file(copy, [&](const std::filesystem::path& aside) {
    Statement statement = database.prepare("VACUUM INTO ?");
    statement.bind(aside.string()).run();
  });
}

/// Version 2 has the shape of the cell and its markers in the samples, and the tank-treading frequency in the results.
/// The samples are dropped: they are read anew from the run directories, which may hold the new columns already.
const char* const from_1_to_2 = R"sql(
ALTER TABLE sample ADD COLUMN taylor_deformation REAL CHECK (typeof(taylor_deformation) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN angle_xz_deg REAL CHECK (typeof(angle_xz_deg) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN angle_xy_deg REAL CHECK (typeof(angle_xy_deg) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN extent_x_um REAL CHECK (typeof(extent_x_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN extent_y_um REAL CHECK (typeof(extent_y_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN extent_z_um REAL CHECK (typeof(extent_z_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN marker_y_dx_um REAL CHECK (typeof(marker_y_dx_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN marker_y_dy_um REAL CHECK (typeof(marker_y_dy_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN marker_y_dz_um REAL CHECK (typeof(marker_y_dz_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN marker_z_dx_um REAL CHECK (typeof(marker_z_dx_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN marker_z_dy_um REAL CHECK (typeof(marker_z_dy_um) IN ('real', 'null'));
ALTER TABLE sample ADD COLUMN marker_z_dz_um REAL CHECK (typeof(marker_z_dz_um) IN ('real', 'null'));
ALTER TABLE result ADD COLUMN tank_treading_per_s REAL CHECK (typeof(tank_treading_per_s) IN ('real', 'null'));
ALTER TABLE result ADD COLUMN tank_treading_error_per_s REAL
  CHECK (typeof(tank_treading_error_per_s) IN ('real', 'null'));
ALTER TABLE result ADD COLUMN tank_treading_reason TEXT NOT NULL DEFAULT '';
DELETE FROM result;
DELETE FROM sample;
UPDATE point SET log_offset = 0, log_tail_hash = '';
)sql";

/// Version 3 knows engines besides this machine.
const char* const from_2_to_3 = R"sql(
ALTER TABLE attempt ADD COLUMN engine TEXT NOT NULL DEFAULT 'local';
ALTER TABLE attempt ADD COLUMN job_id TEXT NOT NULL DEFAULT '';
ALTER TABLE attempt ADD COLUMN job_state TEXT NOT NULL DEFAULT '';
)sql";

const std::array<Migration, 2> all_migrations = {{{1, from_1_to_2}, {2, from_2_to_3}}};

}  // namespace

std::span<const Migration> migrations() { return all_migrations; }

void create_schema(const Database& database) {
  Transaction transaction(database);
  database.execute(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};", application_id, schema_version));
  database.execute(table_statements);
  database.execute(view_statements);
  transaction.commit();
}

void check_schema(const Database& database, int newest) {
  const std::string name = database.file().string();
  if (database.select_integer("PRAGMA application_id") != application_id)
    fail(Exit::failed, "{}: not a campaign database (its application_id is not Rouleau's); name another directory",
         name);
  const std::int64_t version = database.select_integer("PRAGMA user_version");
  if (version > newest)
    fail(
        Exit::failed,
        "{}: written by a newer rouleau (schema {}, this program reads up to {}); use that rouleau, or make a database "
        "for this one with `rouleau rebuild`",
        name, version, newest);
}

void migrate(const Database& database, std::span<const Migration> steps, int newest) {
  const auto version_of = [&] { return static_cast<int>(database.select_integer("PRAGMA user_version")); };
  const int found = version_of();
  if (found == newest) return;
  check_schema(database, newest);
  back_up(database, fmt::format("{}.v{}.backup", database.file().string(), found));

  Transaction transaction(database);
  database.execute(drop_view_statements);
  for (int version = version_of(); version < newest; ++version) {
    const Migration* step = nullptr;
    for (const Migration& candidate : steps)
      if (candidate.from == version) step = &candidate;
    if (step == nullptr)
      fail(Exit::failed, "{}: schema {} cannot be brought to {}; make the database anew with `rouleau rebuild`",
           database.file().string(), version, newest);
    database.execute(step->sql);
    database.execute(fmt::format("PRAGMA user_version = {};", version + 1));
  }
  database.execute(view_statements);
  transaction.commit();
}

}  // namespace rouleau::campaign
