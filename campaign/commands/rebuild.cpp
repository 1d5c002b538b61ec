// SPDX-License-Identifier: BSD-3-Clause
// `rouleau rebuild`: the database anew from the run directories, made beside and put in place at once.
#include "ingest/rebuild.hpp"

#include <ostream>

#include "commands/verbs.hpp"
#include "commands/version.hpp"
#include "executor/lock.hpp"
#include "executor/process.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

/// When the campaign was made, by the old database if that can still be read. Opening it for writing also rolls back
/// what a killed writer left, so that no journal of the old file can be taken for one of the new.
double created_unix_s(const std::filesystem::path& database) {
  try {
    return Store::open(database).campaign().created_unix_s;
  } catch (const Error&) {
    return now_unix_s();
  }
}

/// A name that no earlier rebuild has used: what it kept may be the only place of samples whose log is lost.
std::filesystem::path place_for_the_old(const std::filesystem::path& database) {
  const std::string name = database.string() + ".before-rebuild";
  if (!std::filesystem::exists(name)) return name;
  for (int number = 2;; ++number)
    if (const std::string next = fmt::format("{}-{}", name, number); !std::filesystem::exists(next)) return next;
}

/// Keeps the old database, if there is one, as the copy `kept`.
void keep_the_old(const std::filesystem::path& database, const std::filesystem::path& kept) {
  const std::filesystem::path journal = database.string() + "-journal";
  if (std::filesystem::exists(database)) {
    make_whole_file(kept, [&](const std::filesystem::path& aside) { std::filesystem::copy_file(database, aside); });
  }
  // Only a database that could not be opened still has its journal here: the pair is kept together.
  if (std::filesystem::exists(journal)) std::filesystem::rename(journal, kept.string() + "-journal");
}

int rebuild(const CommandLine& line) {
  if (!std::filesystem::exists(line.directory / "study.ini"))
    fail(Exit::not_found, "{}: is no campaign (it has no study.ini). `rouleau init STUDY {}` makes one.",
         line.directory.string(), line.directory.string());
  const std::filesystem::path directory = std::filesystem::canonical(line.directory);
  const CampaignLock lock(directory, "rebuild");
  const Study study = read_study(directory / "study.ini");
  const std::filesystem::path database = directory / "campaign.db";
  const CampaignRow campaign{study.name, study.text, digest_of(study.text), created_unix_s(database),
                             version(),  git_hash()};

  const auto life_of_attempt = [](const AttemptRow& attempt) {
    // The scheduler is not asked here: the next pass does that.
    if (attempt.engine != local_engine) return Life::unknown;
    return life_of({attempt.host, attempt.boot_id, attempt.pid, attempt.start_ticks});
  };
  const std::filesystem::path kept = place_for_the_old(database);
  Rebuilt rebuilt;
  make_whole_file(database, [&](const std::filesystem::path& aside) {
    rebuilt = rebuild_store(directory, aside, campaign, study, life_of_attempt);
    keep_the_old(database, kept);
  });

  for (const std::string& warning : rebuilt.warnings) line.io.err << "warning: " << warning << '\n';
  if (!line.quiet)
    line.io.err << fmt::format("{}: {} points, {} attempts, {} samples{}\n", database.string(), rebuilt.points,
                               rebuilt.attempts, rebuilt.samples,
                               std::filesystem::exists(kept) ? "; the old file is " + kept.filename().string() : "");
  return static_cast<int>(rebuilt.warnings.empty() ? Exit::ok : Exit::damaged);
}

}  // namespace

const Verb rebuild_verb = {
    "rebuild",
    "make the database anew from the run directories",
    "[DIR]",
    "  rouleau rebuild my-campaign   after campaign.db was lost or damaged; the old file is kept\n",
    "Points, parameters, attempts, states, samples and results come back as they were. The events that `rouleau why`\n"
    "prints are reconstructed from the attempts' records; retries and cancels before the last one are lost.\n"
    "Ends with 7 when a file was damaged and left aside.\n",
    Words::campaign,
    false,
    nullptr,
    rebuild,
};

}  // namespace rouleau::campaign
