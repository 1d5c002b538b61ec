// SPDX-License-Identifier: BSD-3-Clause
// From a merged study to files and rows.
#include "commands/campaign_files.hpp"

#include "commands/version.hpp"
#include "ingest/ingest.hpp"
#include "store/store.hpp"
#include "study/error.hpp"
#include "study/input_files.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

Point stand_in(const PointRow& row, const Expansion& expansion) {
  Point point;
  point.key = row.key;
  point.identity = row.key;
  point.ordinal = row.ordinal;
  point.replica = row.replica;
  point.in_study = row.in_study;
  point.cancelled = row.state == State::cancelled;
  point.facts.steps = row.end_step;
  for (const Candidate& candidate : expansion.candidates) {
    if (candidate.point.identity.starts_with(row.key)) point.identity = candidate.point.identity;
  }
  return point;
}

void store_named_files(const std::filesystem::path& directory, const NamedFiles& files) {
  for (const auto& [text, file] : files) {
    const std::filesystem::path target = directory / file.stored;
    const std::string content = read_whole_file(file.source).value();
    // Compared, not only looked for: a copy that was damaged is written anew.
    if (read_whole_file(target) == content) continue;
    make_directories(target.parent_path());
    write_whole_file(target, content);
  }
}

void write_point_files(const std::filesystem::path& directory, const Candidate& candidate) {
  const std::filesystem::path run = point_directory(directory, candidate.point.key);
  make_directories(run);
  // Left alone when nothing changed: a running solver's file should not move under it.
  if (read_whole_file(run / "run.ini") != candidate.run_file) write_whole_file(run / "run.ini", candidate.run_file);
  Point point = candidate.point;
  point.run_file_digest = digest_of(candidate.run_file);
  const std::string sums = input_sums(run);
  if (read_whole_file(run / "inputs") != sums) write_whole_file(run / "inputs", sums);
  write_point(run / "point.json", point);
}

std::string free_parameters_text(const KeptPoint& point) {
  std::string text;
  for (const Parameter& now : point.now.point.parameters) {
    const std::string* before = point.before.find(now.name);
    if (before == nullptr || *before == now.value) continue;
    text += fmt::format("{}{} {} -> {}", text.empty() ? "" : ", ", now.name, *before, now.value);
  }
  return text;
}

void update_kept_point(Store& store, const std::filesystem::path& directory, const KeptPoint& kept) {
  PointRow row = row_of(kept.now.point);
  store.update_point(row, parameter_rows_of(kept.now.point));
  if (!Merge::has_grown(kept) || store.point(row.key)->state != State::done) return;
  // The result is one of a shorter run now.
  std::filesystem::remove(point_directory(directory, row.key) / "result.json");
  store.change_state(row.key, State::done, State::stopped,
                     fmt::format("the study asks for more: {} (was {} steps, is {})", free_parameters_text(kept),
                                 kept.before.facts.steps, row.end_step));
}

void update_database(Store& store, const std::filesystem::path& directory, const Study& study, const std::string& text,
                     const Merge& merge) {
  Transaction transaction = store.begin();
  store.set_study(study.name, text, digest_of(text));
  store_analysis(store, study.analysis);
  for (const Candidate& candidate : merge.added) {
    store.add_point(row_of(candidate.point), parameter_rows_of(candidate.point), "added by the study " + study.name);
  }
  for (const KeptPoint& kept : merge.kept) update_kept_point(store, directory, kept);
  for (Point point : merge.dropped) {
    PointRow row = store.point(point.key).value();
    row.in_study = false;
    store.update_point(row, store.parameters(point.key));
  }
  transaction.commit();
}

}  // namespace

std::vector<Point> existing_points(const std::filesystem::path& directory, const Expansion& expansion) {
  std::vector<Point> points;
  if (!std::filesystem::exists(directory / "campaign.db")) return points;
  for (const PointRow& row : Store::open_reader(directory / "campaign.db").points()) {
    try {
      points.push_back(read_point(point_directory(directory, row.key) / "point.json"));
    } catch (const Error&) {
      points.push_back(stand_in(row, expansion));  // written anew below, which is what the error's text advises
    }
  }
  return points;
}

void write_campaign(const std::filesystem::path& directory, const Study& study, const Expansion& expansion,
                    const Merge& merge) {
  store_named_files(directory, expansion.files);
  for (const Candidate& candidate : merge.added) write_point_files(directory, candidate);
  for (const KeptPoint& kept : merge.kept) write_point_files(directory, kept.now);
  for (Point point : merge.dropped) {
    point.in_study = false;
    write_point(point_directory(directory, point.key) / "point.json", point);
  }
  const std::string text = with_stored_files(study, expansion.files);
  write_whole_file(directory / "study.ini", text);

  const std::filesystem::path database = directory / "campaign.db";
  if (std::filesystem::exists(database)) {
    Store store = Store::open(database);
    update_database(store, directory, study, text, merge);
    return;
  }
  make_whole_file(database, [&](const std::filesystem::path& aside) {
    Store store = Store::create(aside, {study.name, text, digest_of(text), now_unix_s(), version(), git_hash()});
    update_database(store, directory, study, text, merge);
  });
}

}  // namespace rouleau::campaign
