// SPDX-License-Identifier: BSD-3-Clause
// A campaign of the fake solver on the fake Slurm, driven pass by pass with the real `rouleau` program.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "support/campaign_program.hpp"
#include "support/slurm/fake_slurm.hpp"

namespace rouleau::testing {

class FakeCampaign {
 public:
  using Capture = rouleau::campaign::Capture;
  using State = rouleau::campaign::State;

  FakeSlurm slurm;
  CampaignProgram program;

  /// A campaign of these λ (100 steps a point). `cluster` and `execution` add lines.
  explicit FakeCampaign(const std::string& lambdas = "5", const std::string& cluster = "",
                        const std::string& execution = "", int places = 2)
      : slurm(places) {
    program.write_study("fluid.lambda = " + lambdas, CampaignProgram::execution("engine = slurm\n" + execution));
    const Capture made = program.init();
    EXPECT_EQ(made.status, 0) << made.err;
    set_cluster(cluster);
  }
  /// cluster.ini with a limit in minutes; `more` adds lines.
  void set_cluster(const std::string& more, int limit_min = 60) const {
    set_content(program.campaign() / "cluster.ini",
                fmt::format("time_limit = {}\npartition = short\npoll_s = 1\npatience_min = 1\n{}", limit_min, more));
  }
  /// What the fake solver does at its next starts (tests/support/fake_solver/README.md).
  void script(int ordinal, const std::string& lines) const {
    set_content(program.run_directory(ordinal) / "fake", lines);
  }

  [[nodiscard]] Capture sync() const { return program.rouleau({"sync", "c"}); }
  /// Passes until the condition holds.
  [[nodiscard]] bool sync_until(const std::function<bool()>& condition) const {
    return eventually([&] {
      last_ = sync();
      return condition();
    });
  }
  [[nodiscard]] bool sync_until_all(State state) const {
    return sync_until([&] {
      for (const auto& point : program.store().points()) {
        if (point.state != state) return false;
      }
      return true;
    });
  }
  /// What the newest pass said.
  [[nodiscard]] std::string last_words() const {
    return fmt::format("sync ended with {}: {}{}", last_.status, last_.err, program.rouleau({"status", "c"}).out);
  }
  /// Starts point 1 and waits until its solver has come to a step at which its script keeps it.
  [[nodiscard]] bool start_and_reach(int step) const {
    const std::string file = fmt::format("{:012d}.h5", step);
    return sync().status == 0 && eventually([&] {
             return step < 50 ? std::filesystem::exists(program.run_directory(1) / "attempts/1/started.json")
                              : std::filesystem::exists(program.run_directory(1) / "checkpoints" / file);
           });
  }
  /// As if submissions whose job is not known were made an hour ago.
  void age_submissions() const {
    rouleau::campaign::Store store = rouleau::campaign::Store::open(program.campaign() / "campaign.db");
    rouleau::campaign::Transaction transaction = store.begin();
    for (const auto& point : store.points()) {
      for (rouleau::campaign::AttemptRow& attempt : store.attempts(point.key)) {
        if (attempt.state == rouleau::campaign::AttemptState::ended || !attempt.job_id.empty()) continue;
        attempt.started_unix_s -= 3600;
        store.put_attempt(attempt);
      }
    }
    transaction.commit();
  }
  [[nodiscard]] std::string status_text() const { return program.rouleau({"status", "c"}).out; }
  [[nodiscard]] std::string why(int ordinal) const {
    return program.rouleau({"why", fmt::format("#{}", ordinal), "-C", "c"}).out;
  }
  [[nodiscard]] int attempts(int ordinal) const {
    return static_cast<int>(program.store().attempts(program.point(ordinal).key).size());
  }

  /// The points' keys by the names of jobs that were made for them.
  [[nodiscard]] std::multimap<std::string, std::string> points_of_jobs() const {
    std::multimap<std::string, std::string> found;
    for (const auto& point : program.store().points()) {
      for (const auto& entry : std::filesystem::directory_iterator(program.campaign() / "points" / point.key)) {
        if (entry.path().filename() != "attempts") continue;
        for (const auto& attempt : std::filesystem::directory_iterator(entry.path())) {
          std::istringstream job(content_of(attempt.path() / "job"));
          std::string engine, id, name;
          job >> engine >> id >> name;
          found.emplace(name, point.key);
        }
      }
    }
    return found;
  }
  /// The most jobs that one point has in the queue, queued or running.
  [[nodiscard]] int most_living_jobs_of_a_point() const {
    const auto points = points_of_jobs();
    std::map<std::string, int> counts;
    int most = 0;
    for (const FakeSlurm::Job& job : slurm.living()) {
      const auto [begin, end] = points.equal_range(job.name);
      std::set<std::string> keys;
      for (auto found = begin; found != end; ++found) keys.insert(found->second);
      for (const std::string& key : keys) most = std::max(most, ++counts[key]);
    }
    return most;
  }

 private:
  mutable Capture last_;
};

}  // namespace rouleau::testing
