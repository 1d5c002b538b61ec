// SPDX-License-Identifier: BSD-3-Clause
// A new database from nothing but the run directories and the study file.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "jobs/judge.hpp"
#include "store/store.hpp"
#include "study/study.hpp"

namespace rouleau::campaign {

struct Rebuilt {
  int points = 0;
  int attempts = 0;
  std::int64_t samples = 0;
  std::vector<std::string> warnings;  ///< what could not be read; the rest was taken in
};

/// Whether the process of an attempt lives; asked about the newest attempt of a point only.
using AttemptLife = std::function<Life(const AttemptRow& attempt)>;

/// Makes the database `file` (it must not exist) from points/*/ of the campaign. Points, parameters, attempts, samples
/// and results are those of the database that was; the states are found by judging the attempts one after the other.
/// Events are reconstructed: creation, start and end of each attempt with the evidence of its files, the last retry or
/// cancel of a user. Lost are what no file holds: words of earlier evidence, earlier retries and cancels, pauses before
/// retries.
Rebuilt rebuild_store(const std::filesystem::path& campaign_directory, const std::filesystem::path& file,
                      const CampaignRow& campaign, const Study& study, const AttemptLife& life_of);

}  // namespace rouleau::campaign
