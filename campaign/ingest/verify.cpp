// SPDX-License-Identifier: BSD-3-Clause
// The comparisons, one function a file of the run directory.
#include "ingest/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ingest/ingest.hpp"
#include "ingest/result_file.hpp"
#include "ingest/run_files.hpp"
#include "ingest/sample_log.hpp"
#include "report/analysis.hpp"
#include "study/error.hpp"
#include "study/input_files.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {
namespace {

/// What the database says of a point, all of one moment: `run` may be writing meanwhile. Files are read after it, so
/// they can only be newer.
struct Stored {
  Stored(const Store& reader, const std::string& key) {
    const Snapshot snapshot(reader.database());
    const std::optional<PointRow> row = reader.point(key);
    if (!row) fail(Exit::not_found, "{}: has no point {}", reader.database().file().string(), key);
    point = *row;
    parameters = reader.parameters(key);
    samples = reader.samples(key);
    mark = reader.sample_mark(key);
    results = reader.results(key);
    analysis = stored_analysis(reader);
    attempts = reader.attempts(key);
    result_text = result_json(reader, key);
  }

  PointRow point;
  std::vector<ParameterRow> parameters;
  std::vector<SampleRow> samples;
  SampleMark mark;
  std::vector<ResultRow> results;
  Analysis analysis;
  std::vector<AttemptRow> attempts;
  std::string result_text;
};

/// Collects the findings of one point.
class PointCheck {
 public:
  PointCheck(const Store& reader, const std::filesystem::path& campaign_directory, const std::string& key)
      : campaign_directory_(campaign_directory),
        database_file_(reader.database().file()),
        stored_(reader, key),
        directory_(point_directory(campaign_directory, key)) {}

  std::vector<Finding> findings() {
    for (const auto check : {&PointCheck::point_file, &PointCheck::samples, &PointCheck::results, &PointCheck::attempts,
                             &PointCheck::result_file}) {
      try {
        (this->*check)();
      } catch (const std::exception& trouble) {  // what cannot be seen of a point hides neither the rest nor the others
        damage(directory_, trouble.what());
      }
    }
    return std::move(findings_);
  }

 private:
  void damage(const std::filesystem::path& file, const std::string& problem) { add(file, true, problem); }
  void remark(const std::filesystem::path& file, const std::string& problem) { add(file, false, problem); }
  void add(const std::filesystem::path& file, bool is_damage, const std::string& problem) {
    findings_.push_back({stored_.point.key, file.lexically_relative(campaign_directory_).string(), is_damage, problem});
  }

  void point_file() {
    const std::filesystem::path file = directory_ / "point.json";
    try {
      const Point point = read_point(file);
      PointRow row = row_of(point);
      row.state = stored_.point.state;  // what the database alone knows
      row.retries_used = stored_.point.retries_used;
      row.retry_at_unix_s = stored_.point.retry_at_unix_s;
      if (!(row == stored_.point) || parameter_rows_of(point) != stored_.parameters)
        damage(file, "it describes another point than the database; `rouleau init STUDY DIR` writes both anew");
      require_input_files(directory_, point);
    } catch (const Error& error) {
      damage(file, error.what());
    }
  }

  void samples() {
    const std::filesystem::path file = directory_ / "samples.csv";
    const LogPart log = read_sample_log(file, {});
    for (const std::string& warning : log.warnings) damage(file, warning);
    if (log.unfinished_bytes > 0 && stored_.point.state == State::done)
      damage(file, fmt::format("its last {} bytes are no whole line, though the point is done", log.unfinished_bytes));

    const std::vector<SampleRow>& stored = stored_.samples;
    const auto [in_log, in_store] = std::mismatch(log.rows.begin(), log.rows.end(), stored.begin(), stored.end());
    if (in_store == stored.end()) {
      if (in_log != log.rows.end())
        remark(file, fmt::format("{} samples are not in the database yet; `rouleau sync` reads them",
                                 log.rows.end() - in_log));
      return;
    }
    if (in_log == log.rows.end() && !log.warnings.empty())
      return;  // named above; what the database still holds behind the damage is not at fault
    const LogPart since = read_sample_log(file, stored_.mark);
    if (since.from_start && !may_replace(since, stored.size(), stored_.point.state == State::done)) {
      damage(file, fmt::format("it has {} samples, the database keeps {}; put the file back from a copy",
                               log.rows.size(), stored.size()));
    } else if (since.from_start) {
      remark(file, "it was cut back or has changed since it was read; `rouleau sync` reads it anew");
    } else {
      damage(file,
             fmt::format("the database differs from it at step {}, cell {}; `rouleau rebuild` makes the database anew",
                         in_store->step, in_store->cell));
    }
  }

  void results() {
    const std::string& key = stored_.point.key;
    if (analyse(key, stored_.samples, stored_.analysis) != stored_.results)
      damage(database_file_,
             fmt::format("the results of point {} are not those of its samples; `rouleau rebuild` makes "
                         "the database anew",
                         key));
  }

  void attempts() {
    const std::vector<int> folders = attempt_numbers(directory_);
    const std::vector<AttemptRow>& rows = stored_.attempts;
    for (const int number : folders)
      if (std::none_of(rows.begin(), rows.end(), [&](const AttemptRow& row) { return row.number == number; }))
        remark(directory_ / "attempts" / std::to_string(number),
               "the database does not know this attempt; `rouleau sync` looks at it");
    for (const AttemptRow& row : rows) {
      const std::filesystem::path folder = directory_ / "attempts" / std::to_string(row.number);
      if (std::find(folders.begin(), folders.end(), row.number) == folders.end()) {
        // A manager killed between its intent and the launch leaves a row without a folder, closed by the next manager.
        const bool was_launched = row.state == AttemptState::launched || row.pid != 0 || row.exit_code || row.step;
        if (was_launched) damage(folder, "it is gone, the database knows it");
        continue;
      }
      std::vector<std::string> warnings;
      AttemptRow expected = row;
      fill_from_files(expected, directory_, warnings);
      for (const std::string& warning : warnings) damage(folder, warning);
      if (expected == row) continue;
      if (row.state == AttemptState::ended && row.exit_code)
        damage(folder, "its files say something else than the database; `rouleau rebuild` makes the database anew");
      else
        remark(folder, "its files are not in the database yet; `rouleau sync` reads them");
    }
  }

  void result_file() {
    if (stored_.point.state != State::done) return;
    const std::filesystem::path file = directory_ / "result.json";
    const std::optional<std::string> text = read_whole_file(file);
    if (!text)
      remark(file, "it is missing, though the point is done; `rouleau sync` writes it");
    else if (*text != stored_.result_text)
      damage(file, "it is not what the database says; remove it, and `rouleau sync` writes it anew");
  }

  const std::filesystem::path& campaign_directory_;
  std::filesystem::path database_file_;
  Stored stored_;
  std::filesystem::path directory_;
  std::vector<Finding> findings_;
};

/// study.ini against the database's copy, which is what `run` goes by; a rebuilt database would go by the file.
void compare_studies(std::vector<Finding>& findings, const Store& reader, const std::filesystem::path& directory) {
  const CampaignRow campaign = reader.campaign();
  if (digest_of(campaign.study_text) != campaign.study_digest) {
    const std::string database = reader.database().file().filename().string();
    findings.push_back({"", database, true, "its copy of the study is damaged; `rouleau rebuild` makes it anew"});
    return;
  }
  try {
    const std::optional<std::string> text = read_whole_file(directory / "study.ini");
    if (text == campaign.study_text) return;
    findings.push_back(
        {"", "study.ini", true,
         fmt::format("it {}; `rouleau init STUDY DIR` with your own study file writes both anew (`rouleau "
                     "rebuild` would take what is there)",
                     text ? "is not the study that the database holds: it is damaged or was edited, or "
                            "`rouleau init` was cut short"
                          : "is missing")});
  } catch (const Error& error) {
    findings.push_back({"", "study.ini", true, error.what()});
  }
}

}  // namespace

std::vector<Finding> verify_database(const Store& reader, const std::filesystem::path& campaign_directory) {
  std::vector<Finding> findings;
  const std::string file = reader.database().file().filename().string();
  for (const std::vector<Value>& row : reader.database().select("PRAGMA integrity_check").rows)
    if (const std::string text = std::get<std::string>(row[0]); text != "ok")
      findings.push_back({"", file, true, text + "; `rouleau rebuild` makes it anew"});
  for (const std::vector<Value>& row : reader.database().select("PRAGMA foreign_key_check").rows)
    findings.push_back({"", file, true,
                        fmt::format("a row of `{}` belongs to no point; `rouleau rebuild` makes it anew",
                                    std::get<std::string>(row[0]))});
  compare_studies(findings, reader, campaign_directory);
  std::error_code error;
  for (std::filesystem::directory_iterator it(campaign_directory / "points", error), end; !error && it != end;
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::error_code unseen;
    if (it->is_directory(unseen) && !reader.point(name))
      findings.push_back(
          {name, "points/" + name, false, "the database does not know it; `rouleau rebuild` takes it in"});
  }
  if (error) findings.push_back({"", "points", true, "cannot be read: " + error.message()});
  std::sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) { return a.file < b.file; });
  return findings;
}

std::vector<Finding> verify_point(const Store& reader, const std::filesystem::path& campaign_directory,
                                  const std::string& key) {
  return PointCheck(reader, campaign_directory, key).findings();
}

}  // namespace rouleau::campaign
