// SPDX-License-Identifier: BSD-3-Clause
// Ten thousand points, and ten thousand jobs of others that Slurm knows: planned, submitted and listed. The times are
// printed and recorded, not asserted: they are this machine's.
#include <sys/resource.h>

#include "slurm/fake_campaign.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::CampaignProgram;
using rouleau::testing::FakeSlurm;

constexpr int points = 10000, points_per_job = 48, jobs = 25;

/// Processor time of all children so far, s: what a busy machine does not change.
double children_s() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// `rouleau WORDS` to its end; prints and records what it took.
Capture timed(const CampaignProgram& program, const std::string& name, const std::vector<std::string>& words) {
  const auto begin = std::chrono::steady_clock::now();
  const double before_s = children_s();
  Capture capture = program.rouleau(words);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  const std::string figure = fmt::format("{:.2f} s, {:.2f} s of a core", took.count(), children_s() - before_s);
  fmt::print("10000 points: {} took {}\n", name, figure);
  ::testing::Test::RecordProperty("time of " + name, figure);
  return capture;
}

TEST(TenThousandPoints, ArePlannedSubmittedAndListed) {
  const FakeSlurm slurm(1000);
  slurm.control({"crowd", "10000"});
  const CampaignProgram program;
  program.write_study(fmt::format("fluid.lambda = 1:{}:0.001", 1 + 0.001 * (points - 1)),
                      CampaignProgram::execution("engine = slurm\n"));
  const Capture made = timed(program, "init", {"init", "study.ini", "c"});
  ASSERT_EQ(made.status, 0) << made.err;
  rouleau::testing::set_content(program.campaign() / "cluster.ini",
                                fmt::format("time_limit = 60\npoints_per_job = {}\njobs = {}\nsubmissions_per_pass = "
                                            "5\n",
                                            points_per_job, jobs));
  slurm.set("pending_reason", "Licenses");

  const Capture first = timed(program, "first pass, 240 of them submitted", {"sync", "c"});
  EXPECT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(slurm.living().size(), 5U);
  const Capture listed = timed(program, "status", {"status", "c"});
  EXPECT_EQ(listed.status, 0) << listed.err;
  EXPECT_EQ(std::count(listed.out.begin(), listed.out.end(), '\n'), points + 1);
  const Capture idle = timed(program, "a pass that finds nothing new", {"sync", "c", "--no-start"});
  EXPECT_EQ(idle.status, 0) << idle.err;

  // They run now, all at once.
  slurm.unset("pending_reason");
  CampaignProgram::set_speed(1, 50);
  for (const FakeSlurm::Job& job : slurm.living()) slurm.control({"pend", job.id, "None"});
  ASSERT_EQ(program.rouleau({"sync", "c", "--no-start"}).status, 0);
  ASSERT_TRUE(rouleau::testing::eventually([&] { return slurm.living().empty(); }));
  const Capture harvest = timed(program, "a pass that records 240 ends", {"sync", "c", "--no-start"});
  EXPECT_EQ(harvest.status, 0) << harvest.err;
  int done = 0;
  for (const PointRow& point : program.store().points()) done += point.state == State::done ? 1 : 0;
  EXPECT_EQ(done, 240);
}

}  // namespace
}  // namespace rouleau::campaign
