// SPDX-License-Identifier: BSD-3-Clause
// A case's study as a campaign of `rouleau`: made, run to its end and read, or only read if an earlier call has run it.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "suite.hpp"

namespace rouleau::validation {

/// One point of a campaign that has run to its end.
struct CampaignPoint {
  std::filesystem::path directory;                     ///< holds run.ini, samples.csv and checkpoints
  nlohmann::json columns;                              ///< of `rouleau export`: parameters and results by name
  std::map<std::string, std::vector<double>> samples;  ///< [lines] of samples.csv, first cell, by column

  /// A parameter or result. throws Error(bad_input) if it is no number
  [[nodiscard]] double number(const std::string& column) const;
  [[nodiscard]] std::string text(const std::string& column) const;
  /// A column of the samples. throws Error(bad_input) if the solver has not written it
  [[nodiscard]] const std::vector<double>& series(const std::string& column) const;
};

/// Brings the campaign of `<studies>/<study>.ini` up to date in `<scratch>/<study>` without running it.
/// Points that an earlier call has run stay, unless another build of the solver made them: then all is made anew.
/// returns the points in the study's order, without samples
/// throws Error(io) if `rouleau` fails
std::vector<CampaignPoint> make_campaign(const Places& places, const std::string& study);

/// The same, and runs it to its end.
/// throws Error(physics) naming a point that did not reach its end
std::vector<CampaignPoint> run_campaign(const Places& places, const std::string& study);

}  // namespace rouleau::validation
