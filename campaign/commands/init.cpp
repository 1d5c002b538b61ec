// SPDX-License-Identifier: BSD-3-Clause
// `rouleau init STUDY DIR`: makes a campaign, or brings one up to date with a changed study.
#include <algorithm>
#include <ostream>

#include "commands/campaign_files.hpp"
#include "commands/verbs.hpp"
#include "executor/lock.hpp"
#include "executor/solver.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

constexpr std::size_t most_named = 10;

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("yes,y", po::bool_switch(), "go on although points of the campaign leave the study");
  add("help-study", po::bool_switch(), "how a study file is written, with every setting");
}

void refuse_foreign_directory(const std::filesystem::path& directory) {
  if (!std::filesystem::exists(directory)) return;
  if (!std::filesystem::is_directory(directory))
    fail(Exit::usage, "{}: is a file, not a directory.", directory.string());
  // The lock is the first thing that init makes: a directory with one is ours, even if a kill came right after.
  const bool is_ours =
      std::filesystem::exists(directory / "campaign.db") || std::filesystem::exists(directory / ".lock");
  if (!is_ours && !std::filesystem::is_empty(directory)) {
    fail(Exit::usage, "{}: holds other files and no campaign. Name a new or empty directory.", directory.string());
  }
}

std::string listed(const std::vector<Point>& points) {
  std::string text;
  for (std::size_t i = 0; i < std::min(points.size(), most_named); ++i) {
    text += fmt::format("{}#{} ({})", i == 0 ? "" : ", ", points[i].ordinal, points[i].label());
  }
  return points.size() > most_named ? text + ", ..." : text;
}

int init(const CommandLine& line) {
  if (line.is_set("help-study")) {
    line.io.out << study_help();
    return static_cast<int>(Exit::ok);
  }
  if (line.words.size() != 2) {
    fail(Exit::usage,
         "rouleau init: takes a study file and a directory, {} words were given. `rouleau init --help` explains.",
         line.words.size());
  }
  const Study study = read_study(line.words[0]);
  const std::filesystem::path directory = line.words[1];
  refuse_foreign_directory(directory);
  const Expansion expansion = expand(study, solver_checker(find_solver()));
  const auto say = [&](const std::string& text) {
    if (!line.quiet) line.io.err << text << "\n";
  };
  for (const std::string& note : expansion.notes) say("note: " + note);

  make_directories(directory);
  const CampaignLock lock(directory, "init");
  const Merge merged = merge(existing_points(directory, expansion), expansion);
  if (!merged.dropped.empty()) {
    const std::string what =
        fmt::format("{} points of the campaign are not in the study any more, and {} new ones come: {}",
                    merged.dropped.size(), merged.added.size(), listed(merged.dropped));
    if (!line.is_set("yes")) {
      fail(Exit::usage, "{}: {}. Their data would be kept, but they would not be run. Give --yes if that is meant.",
           directory.string(), what);
    }
    say(directory.string() + ": " + what);
  }
  write_campaign(directory, study, expansion, merged);
  const auto grown = std::count_if(merged.kept.begin(), merged.kept.end(), Merge::has_grown);
  say(fmt::format("{}: {} points ({} new, {} kept, {} of them with a later end). `rouleau run {}` runs them.",
                  directory.string(), merged.added.size() + merged.kept.size(), merged.added.size(), merged.kept.size(),
                  grown, directory.string()));
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb init_verb = {
    "init",
    "make a campaign from a study file, or bring one up to date with it",
    "STUDY DIR [--yes]",
    "  rouleau init study.ini my-campaign     one directory a point, and the database\n"
    "  rouleau init study.ini my-campaign     again, after values were added to the study: adds points\n",
    "Points are known by their physical parameters: 4.75 and 4.750 are one point, and a point that is there already\n"
    "is kept with its data. A later end time lets finished points go on. The study file and the files it names\n"
    "(meshes) are copied, so that DIR may be moved.\n",
    Words::free,
    false,
    describe,
    init,
};

}  // namespace rouleau::campaign
