// SPDX-License-Identifier: BSD-3-Clause
// The schema of campaign.db, its version number, and how an older file is brought up to date.
#pragma once

#include <filesystem>
#include <span>

#include "store/database.hpp"

namespace rouleau::campaign {

/// PRAGMA application_id of every campaign.db: the bytes "Roul".
inline constexpr std::int64_t application_id = 0x526f756c;

/// PRAGMA user_version that this program reads and writes.
inline constexpr int schema_version = 3;

/// One step of an upgrade: the statements that turn version `from` into version from + 1.
struct Migration {
  int from;
  const char* sql;
};

/// All steps up to schema_version, oldest first.
std::span<const Migration> migrations();

/// Tables, views and version numbers, in one transaction, in an empty database.
void create_schema(const Database& database);

/// throws  Error (failed) unless the file is a campaign.db of at most version `newest`
void check_schema(const Database& database, int newest = schema_version);

/// Brings an older file to version `newest` by the steps given and puts this program's views in place of its own, in
/// one exclusive transaction, behind a complete copy
/// `<file>.v<version>.backup`.   throws Error, and changes nothing, when a step is missing or fails
void migrate(const Database& database, std::span<const Migration> steps, int newest = schema_version);

}  // namespace rouleau::campaign
