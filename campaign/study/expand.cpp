// SPDX-License-Identifier: BSD-3-Clause
// Expanding a study with the solver's help.
#include "study/expand.hpp"

#include <algorithm>
#include <map>

#include "study/error.hpp"
#include "study/ini.hpp"

namespace rouleau::campaign {

namespace {

constexpr std::size_t shortest_key = 12;

/// "fluid.lambda = 4.750": the swept part of a combination as the study writes it.
std::string title_of(const Study& study, const Combination& combination) {
  std::string title;
  for (const Entry& entry : combination.entries) {
    const bool is_swept =
        entry.name == "cell.replica" ||
        std::any_of(study.axes.begin(), study.axes.end(), [&](const Axis& axis) { return axis.name == entry.name; });
    if (is_swept) title += (title.empty() ? "" : ", ") + entry.name + " = " + entry.value;
  }
  return title.empty() ? "the only point" : title;
}

std::vector<std::string> swept_names(const Study& study) {
  std::vector<std::string> names;
  for (const Axis& axis : study.axes) names.push_back(axis.name);
  if (study.replicas > 0) names.emplace_back("cell.replica");
  return names;
}

/// The solver names files by their absolute place; the campaign must be movable, so its own name replaces it.
void use_stored_names(std::vector<Parameter>& parameters, const Combination& combination, const NamedFiles& files) {
  for (Parameter& parameter : parameters) {
    for (const Entry& entry : combination.entries) {
      if (entry.name == parameter.name && names_a_file(entry.name)) parameter.value = files.at(entry.value).stored;
    }
  }
}

int replica_of(const Combination& combination) {
  for (const Entry& entry : combination.entries) {
    if (entry.name == "cell.replica") return std::atoi(entry.value.c_str());
  }
  return 0;
}

std::string refusal(const Study& study, const Combination& combination, const RunFile& candidate,
                    const std::string& error) {
  std::string message = to_study_lines(trimmed(error), candidate, study.file_name());
  if (!message.starts_with(study.file_name())) message = study.file_name() + ": " + message;
  if (!study.axes.empty()) message += " (at " + title_of(study, combination) + ")";
  return message;
}

}  // namespace

Expansion expand(const Study& study, const Checker& check) {
  Expansion expansion;
  expansion.files = find_named_files(study);
  std::map<std::string, std::string> title_of_identity;
  const auto count = static_cast<std::size_t>(count_of(study));
  for (std::size_t index = 0; index < count; ++index) {
    const Combination combination = combination_of(study, index);
    const std::string title = title_of(study, combination);
    const RunFile candidate = run_file_of(combination, expansion.files, FileNames::source, title);
    CheckOutcome outcome = check(candidate.text);
    if (!outcome.error.empty()) throw Error(Exit::usage, refusal(study, combination, candidate, outcome.error));

    CheckReply& reply = outcome.reply;
    expansion.solver_version = reply.version;
    expansion.solver_git = reply.git;
    for (const std::string& warning : reply.warnings) {
      const std::string note = to_study_lines(warning, candidate, study.file_name());
      if (std::find(expansion.notes.begin(), expansion.notes.end(), note) == expansion.notes.end()) {
        expansion.notes.push_back(note);
      }
    }
    const auto [known, is_new] = title_of_identity.emplace(reply.identity, title);
    if (!is_new) {
      expansion.notes.push_back(study.file_name() + ": " + title + " and " + known->second +
                                " are the same point; it is run once.");
      continue;
    }
    use_stored_names(reply.parameters, combination, expansion.files);
    Candidate point;
    point.point.identity = reply.identity;
    point.point.replica = replica_of(combination);
    point.point.swept = swept_names(study);
    point.point.parameters = std::move(reply.parameters);
    point.point.facts = reply.facts;
    point.run_file =
        run_file_of(combination, expansion.files, FileNames::stored, "study " + study.name + ": " + title).text;
    expansion.candidates.push_back(std::move(point));
  }
  return expansion;
}

std::string key_of(const std::string& identity, const std::set<std::string>& taken) {
  std::size_t length = shortest_key;
  while (length < identity.size() && taken.contains(identity.substr(0, length))) ++length;
  return identity.substr(0, length);
}

}  // namespace rouleau::campaign
