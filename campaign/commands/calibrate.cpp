// SPDX-License-Identifier: BSD-3-Clause
// A short run by hand, read back from its exit.json.
#include "commands/calibrate.hpp"

#include <chrono>

#include "executor/cores.hpp"
#include "executor/local.hpp"
#include "executor/solver.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"
#include "study/numbers.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

Calibration calibrate(const std::string& run_file, const std::filesystem::path& files, double seconds, int ranks) {
  const ScratchDirectory scratch;
  const std::filesystem::path run = scratch.path() / "points" / "calibration";
  std::filesystem::create_directories(run);
  if (std::filesystem::exists(files)) {
    std::filesystem::create_directory_symlink(std::filesystem::absolute(files), scratch.path() / "files");
  }
  write_whole_file(run / "run.ini", run_file);

  std::vector<std::string> command = mpi_prefix(ranks, static_cast<int>(allowed_cores().size()));
  command.insert(command.end(), {find_solver().string(), "run.ini", "--quiet", "--deadline-s", shortest(seconds)});
  const auto start = std::chrono::steady_clock::now();
  const Capture capture = run_and_capture(command, run);
  Calibration result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

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

}  // namespace rouleau::campaign
