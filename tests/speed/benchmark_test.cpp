// SPDX-License-Identifier: BSD-3-Clause
// The benchmark program on a tiny point: it runs, and its result holds what was promised. Times are not judged.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/process.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::speed {
namespace {

using testing::Finished;

Finished run_benchmark(const std::filesystem::path& result, const std::vector<std::string>& options) {
  std::vector<std::string> words = testing::launcher(2);
  words.insert(words.end(), {ROULEAU_BENCHMARK, "--tiny", "--studies", ROULEAU_STUDIES, "--out", result.string()});
  words.insert(words.end(), options.begin(), options.end());
  return testing::run_program(words);
}

TEST(Benchmark, ResultHasEveryPromisedFigure) {
  const testing::TemporaryDirectory directory;
  const auto file = directory.path() / "benchmark.json";
  const Finished finished = run_benchmark(file, {});
  ASSERT_EQ(finished.code, 0) << finished.err;
  const auto json = nlohmann::json::parse(testing::content_of(file));

  std::vector<std::string> figures{
      "tracking_share",          "correction_share",       "volume_share",           "sampling_share",
      "checkpoint_share",        "two_rank_speedup",       "two_jobs_throughput",    "tracking_exponent",
      "shell_raycast_exponent",  "full_raycast_exponent",  "core_hours_paper_point", "core_hours_large_step",
      "run_ratio_shell_raycast", "run_ratio_full_raycast", "checkpoint_write_ms",    "checkpoint_verify_mb_per_s"};
  for (const std::string name :
       {"attainable_mlups", "fluid_mlups", "fluid_over_attainable", "fluid_ms", "coupled_ms_2pt", "coupled_ms_4pt",
        "coupled_over_fluid_2pt", "coupled_over_fluid_4pt"})
    for (const std::string precision : {"_single", "_double"}) figures.push_back(name + precision);
  for (const std::string& name : figures) {
    ASSERT_TRUE(json.contains(name)) << name;
    EXPECT_TRUE(json.at(name).is_number()) << name;
    EXPECT_TRUE(json.at("spread").at(name).contains("relative")) << name;
    EXPECT_EQ(json.at("spread").at(name).at("rounds"), 2) << name;
  }
  for (const char* name : {"machine", "versions", "load", "parts", "sweep", "targets"})
    EXPECT_FALSE(json.at(name).empty()) << name;
  EXPECT_EQ(json.at("point").at("steps"), 60'000'000 + 4800);  // 9.26 s of 25/162 us
  EXPECT_NE(finished.out.find("NOT REACHED"), std::string::npos) << "a tiny point reaches no target";
}

TEST(Benchmark, OneSectionAloneMeasuresNoOther) {
  const testing::TemporaryDirectory directory;
  const auto file = directory.path() / "benchmark.json";
  const Finished finished = run_benchmark(file, {"--only", "fluid"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  const auto json = nlohmann::json::parse(testing::content_of(file));
  EXPECT_TRUE(json.contains("fluid_over_attainable_single"));
  EXPECT_FALSE(json.contains("coupled_ms_4pt_single"));
  EXPECT_FALSE(json.contains("sweep"));
}

TEST(Benchmark, UnknownSectionIsRefused) {
  const testing::TemporaryDirectory directory;
  const Finished finished = run_benchmark(directory.path() / "benchmark.json", {"--only", "everything"});
  EXPECT_NE(finished.code, 0);
  EXPECT_NE(finished.err.find("everything"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace rouleau::speed
