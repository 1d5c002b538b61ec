// SPDX-License-Identifier: BSD-3-Clause
// Running a program in a test: its exit code and what it printed, killed or signalled after a while if wanted.
#pragma once

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rouleau::testing {

struct Finished {
  int code = -1;   ///< exit code; -1 if a signal ended it
  int signal = 0;  ///< that signal
  std::string out, err;
};

/// A signal to send once, so long after the start, or after a file has so many bytes.
struct Interruption {
  double after_s = 0;
  int signal = SIGKILL;
  std::filesystem::path file{};  ///< none: counted from the start
  std::uintmax_t bytes = 0;      ///< that the file must have
};

/// Runs `words` (the program first) in a process group of its own, standard input empty, and waits for its end. On
/// SIGKILL as interruption the whole group is killed, as a failing node does; any other signal goes to the program
/// alone.
Finished run_program(const std::vector<std::string>& words, std::optional<Interruption> interruption = {});

/// The words in front of a program that is to run on so many ranks; none for one rank.
std::vector<std::string> launcher(int ranks);

}  // namespace rouleau::testing
