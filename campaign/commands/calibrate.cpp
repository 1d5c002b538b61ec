// SPDX-License-Identifier: BSD-3-Clause
// Short runs by hand, read back from their exit.json.
#include "commands/calibrate.hpp"

#include <chrono>
#include <future>

#include "executor/cores.hpp"
#include "executor/local.hpp"
#include "executor/solver.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"
#include "study/numbers.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

/// One of the solvers.
Calibration run_one(const std::string& run_file, const std::filesystem::path& run, double seconds, int ranks) {
  std::filesystem::create_directories(run);
  write_whole_file(run / "run.ini", run_file);
  std::vector<std::string> command = mpi_prefix(ranks, static_cast<int>(allowed_cores().size()));
  command.insert(command.end(), {find_solver().string(), "run.ini", "--quiet", "--deadline-s", shortest(seconds)});
  const Capture capture = run_and_capture(command, run);

  Calibration result;
  std::vector<std::string> warnings;
  const auto exit = read_exit_file(run / "attempts" / "1" / "exit.json", warnings);
  if (!exit || !exit->mlups || *exit->mlups <= 0) {
    result.trouble = fmt::format("the solver ended with {} and no speed: {}", capture.status,
                                 capture.err.empty() ? "no message" : capture.err);
  } else {
    result.mlups = *exit->mlups;
  }
  return result;
}

}  // namespace

Calibration calibrate(const std::string& run_file, const std::filesystem::path& files, double seconds, int ranks,
                      int jobs) {
  const ScratchDirectory scratch;
  if (std::filesystem::exists(files)) {
    std::filesystem::create_directory_symlink(std::filesystem::absolute(files), scratch.path() / "files");
  }
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::future<Calibration>> runs;
  for (int job = 0; job < jobs; ++job) {
    runs.push_back(std::async(std::launch::async, run_one, run_file,
                              scratch.path() / "points" / fmt::format("calibration-{}", job), seconds, ranks));
  }
  Calibration mean;
  for (auto& run : runs) {
    const Calibration one = run.get();
    mean.mlups += one.mlups / jobs;
    if (mean.trouble.empty()) mean.trouble = one.trouble;
  }
  mean.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return mean;
}

}  // namespace rouleau::campaign
