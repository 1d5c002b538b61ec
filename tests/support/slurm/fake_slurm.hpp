// SPDX-License-Identifier: BSD-3-Clause
// A fake Slurm for one test: its programs come first on the PATH, its queue lives and dies with this object.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "executor/solver.hpp"
#include "support/temporary_directory.hpp"

// Set by the build: the folder with the fake programs.
#if !defined(FAKE_SLURM_PROGRAMS)
#error "link slurm_test_support"
#endif

namespace rouleau::testing {

class FakeSlurm {
 public:
  struct Job {
    std::string id, name, state, reason, node;
    int restarts = 0;
    double began_unix_s = 0;  ///< of its newest start; 0 = it never ran
    double ended_unix_s = 0;
    [[nodiscard]] bool is_over() const { return ended_unix_s > 0; }
  };

  /// Two nodes, n1 and n2, with so many places each.
  explicit FakeSlurm(int places = 2) : path_before_(std::getenv("PATH")) {
    ::setenv("PATH", (std::string(FAKE_SLURM_PROGRAMS) + ":" + path_before_).c_str(), 1);
    ::setenv("FAKE_SLURM_DIR", (place_.path() / "slurm").c_str(), 1);
    control({"start", std::to_string(::getpid()), std::to_string(places)});
  }
  ~FakeSlurm() {
    control({"stop"});
    ::setenv("PATH", path_before_.c_str(), 1);
  }
  FakeSlurm(const FakeSlurm&) = delete;
  FakeSlurm& operator=(const FakeSlurm&) = delete;

  /// `fake-slurm WORDS`; its own text says what there is.   returns what it prints
  std::string control(const std::vector<std::string>& words) const {
    std::vector<std::string> command = {std::string(FAKE_SLURM_PROGRAMS) + "/fake-slurm"};
    command.insert(command.end(), words.begin(), words.end());
    const auto capture = rouleau::campaign::run_and_capture(command);
    EXPECT_EQ(capture.status, 0) << "fake-slurm " << words.front() << ": " << capture.err;
    return capture.out;
  }
  void set(const std::string& name, const std::string& value) const { control({"set", name, value}); }
  void unset(const std::string& name) const { control({"unset", name}); }

  /// Jobs of campaigns, in the order of their submission.
  [[nodiscard]] std::vector<Job> jobs() const {
    std::vector<Job> jobs;
    std::istringstream lines(control({"jobs"}));
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> fields;
      std::istringstream in(line);
      for (std::string field; std::getline(in, field, '|');) fields.push_back(field);
      if (fields.size() < 15 || !fields[1].starts_with("rouleau-")) continue;
      jobs.push_back({fields[0], fields[1], fields[2], fields[3], fields[4], std::stoi(fields[10]),
                      std::stod(fields[14]), std::stod(fields[8])});
    }
    return jobs;
  }
  /// Jobs that are queued or run.
  [[nodiscard]] std::vector<Job> living() const {
    std::vector<Job> all = jobs();
    std::erase_if(all, [](const Job& job) { return job.is_over(); });
    return all;
  }
  /// How often a client was called.
  [[nodiscard]] int calls(const std::string& client) const {
    std::istringstream lines(content_of(place_.path() / "slurm" / "calls"));
    int count = 0;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t space = line.find(' ');
      count += line.compare(space + 1, client.size() + 1, client + ' ') == 0 ? 1 : 0;
    }
    return count;
  }

 private:
  std::string path_before_;
  TemporaryDirectory place_;
};

}  // namespace rouleau::testing
