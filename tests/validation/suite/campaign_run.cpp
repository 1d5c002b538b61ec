// SPDX-License-Identifier: BSD-3-Clause
#include "campaign_run.hpp"

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "program.hpp"
#include "run/value_text.hpp"
#include "storage/checksum.hpp"
#include "storage/files.hpp"

namespace rouleau::validation {
namespace {

namespace fs = std::filesystem;

std::string rouleau_says(const Places& places, std::vector<std::string> words) {
  words.insert(words.begin(), (places.programs / "rouleau").string());
  const Ended ended = run_program(words);
  if (ended.status != 0)
    fail(Exit::io, "rouleau {} {} ended with status {}; its message stands above", words[1], words.back(),
         ended.status);
  return ended.out;
}

/// Removes a campaign that another solver has made, and notes this one for the next call.
void forget_other_solvers(const Places& places, const fs::path& campaign) {
  FileSystem& files = posix_file_system();
  const std::string solver = text_digest(read_file(files, places.programs / "rouleau-solver"));
  const fs::path note = campaign.string() + ".solver";
  std::string made_by;
  if (read_file_if_there(files, note, made_by) && made_by == solver) return;
  fs::remove_all(campaign);
  write_aside(files, note, solver);
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

std::map<std::string, std::vector<double>> read_samples(const fs::path& file) {
  std::istringstream text(read_file(posix_file_system(), file));
  std::string line;
  std::getline(text, line);
  std::vector<std::string> names = split(line);
  if (names.empty() || names.back() != "check")
    fail(Exit::bad_input, "{}: its first line is no header of a sample log", file.string());
  names.pop_back();
  const auto cell = static_cast<std::size_t>(std::find(names.begin(), names.end(), "cell") - names.begin());
  std::map<std::string, std::vector<double>> samples;
  while (std::getline(text, line)) {
    const std::vector<std::string> fields = split(line);
    if (fields.size() != names.size() + 1)
      fail(Exit::bad_input, "{}: a line has {} fields, the header {}", file.string(), fields.size(), names.size() + 1);
    if (cell < names.size() && fields[cell] != "0") continue;
    for (std::size_t c = 0; c < names.size(); ++c) samples[names[c]].push_back(parse_real(fields[c]));
  }
  return samples;
}

std::vector<CampaignPoint> read_points(const Places& places, const fs::path& campaign) {
  const auto table = nlohmann::json::parse(rouleau_says(places, {"export", "--format", "json", campaign.string()}));
  std::vector<CampaignPoint> points;
  for (const auto& row : table.at("rows")) {
    if (row.at("in_study") != 1) continue;
    points.push_back({campaign / "points" / row.at("key").get<std::string>(), row, {}});
  }
  return points;
}

}  // namespace

double CampaignPoint::number(const std::string& column) const {
  const auto found = columns.find(column);
  if (found == columns.end() || !found->is_number())
    fail(Exit::bad_input, "{}: `{}` is no number of this point", directory.string(), column);
  return found->get<double>();
}

std::string CampaignPoint::text(const std::string& column) const {
  const auto found = columns.find(column);
  if (found == columns.end() || !found->is_string())
    fail(Exit::bad_input, "{}: `{}` is no text of this point", directory.string(), column);
  return found->get<std::string>();
}

const std::vector<double>& CampaignPoint::series(const std::string& column) const {
  const auto found = samples.find(column);
  if (found == samples.end()) fail(Exit::bad_input, "{}: samples.csv has no column `{}`", directory.string(), column);
  return found->second;
}

std::vector<CampaignPoint> make_campaign(const Places& places, const std::string& study) {
  fs::create_directories(places.scratch);
  const fs::path campaign = places.scratch / study;
  forget_other_solvers(places, campaign);
  rouleau_says(places, {"init", "--yes", (places.studies / (study + ".ini")).string(), campaign.string()});
  return read_points(places, campaign);
}

std::vector<CampaignPoint> run_campaign(const Places& places, const std::string& study) {
  make_campaign(places, study);
  const fs::path campaign = places.scratch / study;
  // Its status only says that some point has failed; which one, and why, is asked for below.
  run_program({(places.programs / "rouleau").string(), "run", campaign.string()});
  std::vector<CampaignPoint> points = read_points(places, campaign);
  for (CampaignPoint& point : points) {
    if (point.text("state") != "done")
      fail(Exit::physics, "point {} is {}. `rouleau why -C {} {}` says why", point.text("key"), point.text("state"),
           campaign.string(), point.text("key"));
    point.samples = read_samples(point.directory / "samples.csv");
  }
  return points;
}

}  // namespace rouleau::validation
