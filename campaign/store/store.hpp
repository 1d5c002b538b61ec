// SPDX-License-Identifier: BSD-3-Clause
// campaign.db as typed rows: what is read and written, and the one way to change a point's state.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "store/database.hpp"
#include "store/rows.hpp"

namespace rouleau::campaign {

/// The database of one campaign. A writer keeps one Store and groups what belongs together in a Transaction:
///
///     Transaction transaction = store.begin();
///     store.put_attempt(attempt);
///     store.change_state(key, State::waiting, State::running, "attempt 1 started", 1);
///     transaction.commit();
///
/// Every function that changes something is atomic by itself when no transaction is open. All throw Error when SQLite
/// fails.
class Store {
 public:
  /// Makes the file; it must not exist.
  static Store create(const std::filesystem::path& file, const CampaignRow& campaign);
  /// Opens for reading and writing; brings an older schema up to date behind a backup; refuses a newer one.
  static Store open(const std::filesystem::path& file);
  /// Opens for reading only: never waits longer than a second, never holds a lock between calls.
  static Store open_reader(const std::filesystem::path& file);

  [[nodiscard]] Transaction begin() const { return Transaction(database_); }
  [[nodiscard]] const Database& database() const { return database_; }

  // The campaign and its settings (name = value texts, such as analysis.window_s).
  [[nodiscard]] CampaignRow campaign() const;
  void set_study(const std::string& name, const std::string& text, const std::string& digest);
  [[nodiscard]] std::optional<std::string> setting(std::string_view name) const;
  void set_setting(std::string_view name, std::string_view value);

  // Points, in the order of their ordinals.
  [[nodiscard]] std::vector<PointRow> points() const;
  [[nodiscard]] std::optional<PointRow> point(std::string_view key) const;
  [[nodiscard]] std::vector<ParameterRow> parameters(std::string_view key) const;
  /// Of all points, by key: those that the study's [sweep] names.
  [[nodiscard]] std::map<std::string, std::vector<ParameterRow>> swept_parameters() const;
  /// Adds a point with its parameters and the event of its creation (now, or at unix_s). throws Error if the key is
  /// there already.
  void add_point(const PointRow& point, const std::vector<ParameterRow>& parameters, std::string_view evidence,
                 std::optional<double> unix_s = std::nullopt);
  /// Rewrites what a changed study may change: in_study, end_step, end_time_s and the parameters. Not the state.
  void update_point(const PointRow& point, const std::vector<ParameterRow>& parameters);
  void set_retry(std::string_view key, int retries_used, double retry_at_unix_s);

  /// Changes the state if it is `from`, and writes the event (of now, or of unix_s), in one transaction. Returns false
  /// (and writes nothing) when the point is in another state: somebody else was faster.
  bool change_state(std::string_view key, State from, State to, std::string_view evidence,
                    std::optional<int> attempt = std::nullopt, std::optional<double> unix_s = std::nullopt);
  [[nodiscard]] std::vector<EventRow> events(std::string_view key) const;  ///< oldest first

  // Attempts, in the order of their numbers.
  [[nodiscard]] std::vector<AttemptRow> attempts(std::string_view point) const;
  [[nodiscard]] std::optional<AttemptRow> newest_attempt(std::string_view point) const;
  [[nodiscard]] std::map<std::string, AttemptRow> newest_attempts() const;  ///< of every point that has one, by key
  [[nodiscard]] std::optional<AttemptRow> attempt_with_token(std::string_view token) const;
  [[nodiscard]] std::vector<AttemptRow> open_attempts() const;  ///< planned or launched, of all points
  /// Writes all columns, over those of the same (point, number) if there is one.
  void put_attempt(const AttemptRow& attempt);

  // Samples, in the order of (step, cell).
  [[nodiscard]] std::vector<SampleRow> samples(std::string_view point) const;
  /// Inserts, over those of the same (step, cell).
  void put_samples(std::string_view point, std::span<const SampleRow> samples);
  void delete_samples(std::string_view point);
  [[nodiscard]] SampleMark sample_mark(std::string_view point) const;
  void set_sample_mark(std::string_view point, const SampleMark& mark);

  // Results, one a cell.
  [[nodiscard]] std::vector<ResultRow> results(std::string_view point) const;
  void put_result(const ResultRow& result);
  void delete_results(std::string_view point);
  /// Puts results into a table of this connection alone (readers may, too), in place of earlier such ones.
  /// returns  the name of the table, of the same columns as `result`
  std::string put_temporary_results(std::span<const ResultRow> results);

 private:
  explicit Store(Database database) : database_(std::move(database)) {}
  void add_event(const EventRow& event);  ///< `id` is ignored

  Database database_;
};

/// Now, in seconds since 1970 UTC.
double now_unix_s();
/// 2026-01-31T12:00:00Z
std::string iso_utc(double unix_s);

}  // namespace rouleau::campaign
