// SPDX-License-Identifier: BSD-3-Clause
// The fake solver's command line, share/contract.md section 2.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "check.hpp"
#include "run.hpp"

namespace {

int check(const std::string& file) {
  fmt::print("{}\n", fake::check_json(fake::read_run_file(file)));
  return 0;
}

int run_with(const std::vector<std::string>& words) {
  fake::Options options;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] == "--quiet") continue;
    if (i + 1 == words.size()) return 64;
    if (words[i] == "--attempt") {
      options.attempt = std::atoi(words[++i].c_str());
    } else if (words[i] == "--token") {
      options.token = words[++i];
    } else if (words[i] == "--deadline-s") {
      options.deadline_s = std::atof(words[++i].c_str());
    } else {
      return 64;
    }
  }
  const std::filesystem::path directory = std::filesystem::path(words[0]).parent_path();
  if (!directory.empty()) std::filesystem::current_path(directory);
  return fake::run(options);
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  // Under mpirun the first rank does the work and the others have none.
  if (const char* rank = std::getenv("OMPI_COMM_WORLD_RANK"); rank != nullptr && *rank != '0') return 0;
  if (words.empty()) return 64;
  try {
    return words[0] == "check" && words.size() > 1 ? check(words[1]) : run_with(words);
  } catch (const fake::Failure& failure) {
    fmt::print(stderr, "{}\n", failure.what());
    return failure.code;
  }
}
