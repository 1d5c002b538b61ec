// SPDX-License-Identifier: BSD-3-Clause
// Opening the database, and the rows of the campaign itself.
#include "store/store.hpp"

#include <fmt/chrono.h>

#include <chrono>
#include <cmath>

#include "store/schema.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {

Store Store::create(const std::filesystem::path& file, const CampaignRow& campaign) {
  Store store(Database(file, Access::create));
  Transaction transaction = store.begin();
  create_schema(store.database_);
  store.database_
      .prepare(
          "INSERT INTO campaign (id, name, study_text, study_digest, created_unix_s, version, git) "
          "VALUES (1, ?, ?, ?, ?, ?, ?)")
      .bind(campaign.name, campaign.study_text, campaign.study_digest, campaign.created_unix_s, campaign.version,
            campaign.git)
      .run();
  transaction.commit();
  return store;
}

Store Store::open(const std::filesystem::path& file) {
  Store store(Database(file, Access::read_write));
  check_schema(store.database_);
  migrate(store.database_, migrations());
  return store;
}

Store Store::open_reader(const std::filesystem::path& file) {
  Store store(Database(file, Access::read_only));
  check_schema(store.database_);
  if (store.database_.select_integer("PRAGMA user_version") < schema_version)
    fail(Exit::failed, "{}: has an older schema; `rouleau sync` brings it up to date behind a backup", file.string());
  return store;
}

CampaignRow Store::campaign() const {
  Statement statement =
      database_.prepare("SELECT name, study_text, study_digest, created_unix_s, version, git FROM campaign");
  if (!statement.step())
    fail(Exit::damaged, "{}: has no campaign row; `rouleau rebuild` makes the database anew",
         database_.file().string());
  return {statement.text(0), statement.text(1), statement.text(2),
          statement.real(3), statement.text(4), statement.text(5)};
}

void Store::set_study(const std::string& name, const std::string& text, const std::string& digest) {
  database_.prepare("UPDATE campaign SET name = ?, study_text = ?, study_digest = ?").bind(name, text, digest).run();
}

std::optional<std::string> Store::setting(std::string_view name) const {
  Statement statement = database_.prepare("SELECT value FROM setting WHERE name = ?");
  statement.bind(name);
  return statement.step() ? std::optional(statement.text(0)) : std::nullopt;
}

void Store::set_setting(std::string_view name, std::string_view value) {
  database_
      .prepare(
          "INSERT INTO setting (name, value) VALUES (?, ?) ON CONFLICT (name) DO UPDATE SET value = excluded.value")
      .bind(name, value)
      .run();
}

double now_unix_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string iso_utc(double unix_s) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(static_cast<std::time_t>(std::floor(unix_s))));
}

}  // namespace rouleau::campaign
