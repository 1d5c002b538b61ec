// SPDX-License-Identifier: BSD-3-Clause
// Where the solver may be, and how it is asked.
#include "executor/solver.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "study/error.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

bool is_program(const std::filesystem::path& file) {
  return std::filesystem::is_regular_file(file) && ::access(file.c_str(), X_OK) == 0;
}

}  // namespace

std::filesystem::path find_solver() {
  const char* name = "rouleau-solver";
  if (const char* given = std::getenv("ROULEAU_SOLVER"); given != nullptr && *given != '\0') {
    if (!is_program(given)) fail(Exit::failed, "ROULEAU_SOLVER = {} is not a program. Correct or unset it.", given);
    return std::filesystem::absolute(given);
  }
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error && is_program(self.parent_path() / name)) return self.parent_path() / name;
  const char* path = std::getenv("PATH");
  std::string rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::filesystem::path place = std::filesystem::path(rest.substr(0, colon)) / name;
    if (is_program(place)) return std::filesystem::absolute(place);
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
  }
  fail(Exit::failed, "rouleau-solver is neither beside {} nor on the PATH. Build it, or set ROULEAU_SOLVER.",
       self.string());
}

Checker solver_checker(const std::filesystem::path& solver) {
  const auto scratch = std::make_shared<ScratchDirectory>();
  return [solver, scratch](const std::string& run_file) {
    const std::filesystem::path file = scratch->path() / "run.ini";
    write_whole_file(file, run_file);
    const Capture capture = run_and_capture({solver.string(), "check", "run.ini", "--format", "json"}, scratch->path());
    CheckOutcome outcome;
    if (capture.status == 0) {
      outcome.reply = parse_check(capture.out);
    } else if (capture.status == 65 && !capture.err.empty()) {
      outcome.error = capture.err;
    } else {
      fail(Exit::failed, "{} check ended with status {}: {}. Try it by hand on a run file.", solver.string(),
           capture.status, capture.err.empty() ? "no message" : capture.err);
    }
    return outcome;
  };
}

ScratchDirectory::ScratchDirectory() {
  std::string name = (std::filesystem::temp_directory_path() / "rouleau-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    fail(Exit::failed, "{}: cannot make a scratch directory: {}. Set TMPDIR to a writable one.", name,
         std::strerror(errno));
  }
  path_ = name;
}

ScratchDirectory::~ScratchDirectory() {
  std::error_code ignored;  // rubbish in the temporary directory is no reason to end a program
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace rouleau::campaign
