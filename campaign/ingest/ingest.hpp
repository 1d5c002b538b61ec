// SPDX-License-Identifier: BSD-3-Clause
// Run directory -> database: repeatable, in any order, any number of times, with the same end.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "store/store.hpp"
#include "study/point.hpp"
#include "study/settings.hpp"

namespace rouleau::campaign {

/// What an ingest did.
struct Ingested {
  std::int64_t new_samples = 0;
  bool reread = false;                ///< the log was read from its start: it is new, was cut back or has changed
  std::vector<std::string> warnings;  ///< damaged files, by name; each was left aside, the others were not
};

/// The database's rows of a point; the state is waiting.
PointRow row_of(const Point& point);
std::vector<ParameterRow> parameter_rows_of(const Point& point);

/// The [analysis] settings stored in the database (settings analysis.<name>); defaults where there are none.
Analysis stored_analysis(const Store& store);

/// Stores them; when they differ from the stored ones, all results are computed anew.
void store_analysis(Store& store, const Analysis& analysis);

/// Brings the samples, the results and the known attempts of a point up to date from its directory. Of an attempt it
/// fills in what exit.json and process.json say; state, token and cores stay as recorded, and attempts that the
/// database does not know are left to whoever judges the point. Samples that the database has are replaced by what
/// may_replace() them only. Changes no state of the point. throws Error only when the database fails; a damaged file
/// becomes a warning
Ingested ingest_point(Store& store, const std::filesystem::path& campaign_directory, std::string_view key);

/// What the sample log lacks of a run that ended at `end_step`; "" = nothing: every line is sound, and the last sample
/// is the last one that was due.
[[nodiscard]] std::string sample_trouble(const Store& store, const std::filesystem::path& run_directory,
                                         std::string_view key, std::int64_t end_step);

/// How many of the newest attempts were started from the same checkpoint, so that all before the last came to nothing.
[[nodiscard]] int starts_in_vain(const std::vector<AttemptRow>& attempts);

/// What the files of attempts/<attempt.number>/ say, filled into the row.
void fill_from_files(AttemptRow& attempt, const std::filesystem::path& run_directory,
                     std::vector<std::string>& warnings);

}  // namespace rouleau::campaign
