// SPDX-License-Identifier: BSD-3-Clause
// A database that is made beside its place and put there once it is whole and closed: campaign.db is never half of one.
#pragma once

#include <filesystem>
#include <string>

#include "study/whole_file.hpp"

namespace rouleau::campaign {

/// Where a new database is made. What was not put in place is gone at the end.
class NewDatabase {
 public:
  /// Removes what a killed command has left there.   throws std::filesystem::filesystem_error if that stays
  explicit NewDatabase(const std::filesystem::path& database) : database_(database), file_(database.string() + ".new") {
    for (const char* ending : endings) std::filesystem::remove(file_.string() + ending);
  }
  ~NewDatabase() {
    std::error_code ignored;
    for (const char* ending : endings) std::filesystem::remove(file_.string() + ending, ignored);
  }
  NewDatabase(const NewDatabase&) = delete;
  NewDatabase& operator=(const NewDatabase&) = delete;

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// Replaces the database, if there is one.   throws std::filesystem::filesystem_error, Error
  void put_in_place() const {
    std::filesystem::rename(file_, database_);
    sync_directory(database_.parent_path());
  }

 private:
  static constexpr const char* endings[] = {"", "-journal"};
  std::filesystem::path database_, file_;
};

}  // namespace rouleau::campaign
