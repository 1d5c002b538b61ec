// SPDX-License-Identifier: BSD-3-Clause
#include "plan.hpp"

#include <sstream>

#include "base/error.hpp"

namespace rouleau::speed {

namespace {

constexpr const char* usage =
    "benchmark [--quick] [--only SECTION,...] [--studies DIRECTORY] [--out FILE]\n"
    "  --quick   fewer rounds and sizes\n"
    "  --tiny    a small point and two rounds: does it work at all?\n"
    "  --only    of fluid, coupled, ranks, jobs, checkpoint, sweep; what they are compared with is measured, too";

void make_quick(Plan& plan) {
  plan.rounds = 7;
  plan.edges = {24, 48, 96};
}

void make_tiny(Plan& plan) {
  plan.rounds = 2;
  plan.steps = 4;
  plan.enough_s = 1e-3;
  plan.edges = {12, 24};
  plan.changes = {{"channel.length_x_um", "16"},         {"numerics.node_spacing_um", "2/3"},
                  {"numerics.time_step_us", "50/81"},    {"cell.subdivisions", "3"},
                  {"output.sample_interval_steps", "4"}, {"numerics.correction_interval", "4"}};
}

std::set<std::string> sections_of(const std::string& list, const std::set<std::string>& known) {
  std::set<std::string> sections;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    if (!known.contains(word)) fail(Exit::usage, "there is no section `{}`\n{}", word, usage);
    sections.insert(word);
  }
  if (!sections.contains("fluid") || sections.size() > 1) sections.insert({"fluid", "coupled"});
  return sections;
}

}  // namespace

Plan parse_plan(int argc, char** argv) {
  Plan plan;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t w = 0; w < words.size(); ++w) {
    const auto value = [&] {
      if (w + 1 == words.size()) fail(Exit::usage, "{} needs a value\n{}", words[w], usage);
      return words[++w];
    };
    if (words[w] == "--quick")
      make_quick(plan);
    else if (words[w] == "--tiny")
      make_tiny(plan);
    else if (words[w] == "--only")
      plan.sections = sections_of(value(), plan.sections);
    else if (words[w] == "--studies")
      plan.studies = value();
    else if (words[w] == "--out")
      plan.result = value();
    else
      fail(Exit::usage, "unknown option {}\n{}", words[w], usage);
  }
  return plan;
}

}  // namespace rouleau::speed
