// SPDX-License-Identifier: BSD-3-Clause
// A real Slurm for a test, on loopback, as an ordinary user: started by the constructor, gone with the object.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "executor/solver.hpp"

// Set by the build: the script that does it.
#if !defined(SLURM_SANDBOX_PROGRAM)
#error "link slurm_test_support"
#endif

namespace rouleau::testing {

class SlurmSandbox {
 public:
  using Capture = rouleau::campaign::Capture;

  /// `settings`: SANDBOX_... for the script, as NAME=VALUE.   throws std::runtime_error with Slurm's logs
  explicit SlurmSandbox(const std::vector<std::string>& settings = {}) {
    std::string pattern = "/tmp/rouleau-slurm-XXXXXX";  // sockets lie in it: a short path
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no directory for Slurm below /tmp");
    directory_ = pattern;
    std::vector<std::string> command = {"env"};
    command.insert(command.end(), settings.begin(), settings.end());
    command.insert(command.end(), {SLURM_SANDBOX_PROGRAM, "start", pattern, std::to_string(::getpid())});
    const Capture started = rouleau::campaign::run_and_capture(command);
    if (started.status != 0) {
      std::error_code ignored;
      std::filesystem::remove_all(directory_, ignored);
      throw std::runtime_error(started.err);
    }
    ::setenv("SLURM_CONF", (directory_ / "slurm.conf").c_str(), 1);
  }
  ~SlurmSandbox() {
    ::unsetenv("SLURM_CONF");
    call({"purge"});
  }
  SlurmSandbox(const SlurmSandbox&) = delete;
  SlurmSandbox& operator=(const SlurmSandbox&) = delete;

  /// `slurm-sandbox VERB DIR ...`; its own text says what there is.   returns what it prints
  std::string call(std::vector<std::string> words) const {
    words.insert(words.begin() + 1, directory_.string());
    words.insert(words.begin(), SLURM_SANDBOX_PROGRAM);
    const Capture capture = rouleau::campaign::run_and_capture(words);
    EXPECT_EQ(capture.status, 0) << words[1] << ": " << capture.err;
    return capture.out;
  }
  /// Lines that `call` prints.
  [[nodiscard]] std::vector<std::string> lines_of(const std::vector<std::string>& words) const {
    std::vector<std::string> lines;
    std::istringstream in(call(words));
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }
  [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path directory_;
};

}  // namespace rouleau::testing
