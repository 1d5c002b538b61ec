// SPDX-License-Identifier: BSD-3-Clause
// `validate`: runs the validation suite, or the cases that are named.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "cases.hpp"
#include "parallel/communicator.hpp"
#include "program.hpp"

namespace {

using namespace rouleau;
using namespace rouleau::validation;

constexpr const char* help =
    "validate --studies DIR [--only CASE,...] [--results FILE] | --list\n"
    "  --studies DIR    the cases' input files\n"
    "  --only CASE,...  these cases only, in the suite's order\n"
    "  --results FILE   FILE.json and FILE.txt are written, campaigns are kept in FILE/ (default: build/validation)\n"
    "Ends with 0 if all checks hold, 1 if one does not, 64 for a wrong command line.\n";

struct Wish {
  std::vector<Case> cases;
  std::filesystem::path studies, results = "build/validation";
};

std::vector<Case> named(const std::string& names) {
  std::vector<Case> chosen;
  std::string known;
  for (const Case& each : all_cases()) {
    known += fmt::format(" {}", each.name);
    if (("," + names + ",").find(fmt::format(",{},", each.name)) != std::string::npos) chosen.push_back(each);
  }
  const auto wanted = static_cast<std::size_t>(std::count(names.begin(), names.end(), ',')) + 1;
  if (chosen.size() != wanted) fail(Exit::usage, "--only {}: not all are cases; there are{}", names, known);
  return chosen;
}

Wish parse(const std::vector<std::string>& words) {
  Wish wish{{all_cases().begin(), all_cases().end()}, {}};
  for (std::size_t i = 0; i < words.size(); i += 2) {
    if (i + 1 == words.size()) fail(Exit::usage, "{}: needs a value, or is not known\n{}", words[i], help);
    if (words[i] == "--only")
      wish.cases = named(words[i + 1]);
    else if (words[i] == "--studies")
      wish.studies = words[i + 1];
    else if (words[i] == "--results")
      wish.results = words[i + 1];
    else
      fail(Exit::usage, "{}: is not known\n{}", words[i], help);
  }
  if (wish.studies.empty()) fail(Exit::usage, "--studies is missing\n{}", help);
  return wish;
}

int run(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words == std::vector<std::string>{"--list"}) {
    for (const Case& each : all_cases()) fmt::print("{:<24} {}\n", each.name, each.title);
    return 0;
  }
  const Wish wish = parse(words);
  const std::filesystem::path programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return run_cases(wish.cases, {wish.studies, wish.results, programs}, wish.results, std::cout);
}

}  // namespace

int main(int argc, char** argv) {
  keep_environment();
  const rouleau::MpiSession session(&argc, &argv);
  try {
    return run(argc, argv);
  } catch (const rouleau::Error& error) {
    fmt::print(stderr, "validate: {}\n", error.what());
    return static_cast<int>(error.code());
  }
}
