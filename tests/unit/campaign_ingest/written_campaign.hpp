// SPDX-License-Identifier: BSD-3-Clause
// A campaign's directory written by the test itself, byte by byte as share/contract.md says.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "ingest/ingest.hpp"
#include "study/point.hpp"
#include "study/study.hpp"
#include "study/whole_file.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign::testing {

inline const std::string log_header =
    "step,time_s,cell,d_um,x_um,y_um,z_um,asphericity,volume_ratio,area_ratio,inclination_deg,inside_nodes,inside_"
    "ratio,"
    "flips,mean_velocity_mm_per_s,pressure_gradient_Pa_per_m,velocity_x_mm_per_s,check\n";

/// A line with its check. `d` as text, so that it may be "nan".
inline std::string log_line(std::int64_t step, const std::string& d, int cell = 0) {
  const std::string line = fmt::format("{},{},{},{},1,0.5,0.25,0.15,1,0.99,-12.5,801,1.01,3,1.5,120.5,2.1", step,
                                       1e-5 * static_cast<double>(step), cell, d);
  return fmt::format("{},{}\n", line, digest_of(line));
}

/// Lines of steps from, from + 100 ... up to `to`, d = 0.9 + 0.2 sin: a slipper of period 0.2 s = 20000 steps.
inline std::string log_lines(std::int64_t from, std::int64_t to) {
  std::string text;
  for (std::int64_t step = from; step <= to; step += 100)
    text += log_line(step, fmt::format("{}", 0.9 + 0.2 * std::sin(static_cast<double>(step) * 3.14159265358979e-4)));
  return text;
}

class WrittenCampaign {
 public:
  WrittenCampaign() {
    ::rouleau::testing::set_content(path() / "study.ini",
                                    "[study]\nname = small\n[channel]\nlength_x_um = 20\n[sweep]\nfluid.lambda = 1, 5\n"
                                    "[execution]\nretries = 2\n[analysis]\nwindow_s = 0.1\n");
  }

  [[nodiscard]] const std::filesystem::path& path() const { return directory_.path(); }
  [[nodiscard]] Study study() const { return read_study(path() / "study.ini"); }
  [[nodiscard]] std::filesystem::path run(const std::string& key) const { return point_directory(path(), key); }
  [[nodiscard]] std::filesystem::path log(const std::string& key) const { return run(key) / "samples.csv"; }

  /// A point of λ = ordinal with a directory and a point.json, of 100000 steps.
  Point add_point(int ordinal) {
    Point point;
    point.key = fmt::format("{:012x}", 0xabc000 + ordinal);
    point.identity = point.key + "00000000000000000000";
    point.ordinal = ordinal;
    point.swept = {"fluid.lambda"};
    point.parameters = {{"fluid.lambda", fmt::format("{}", ordinal), true, true},
                        {"cell.shape", "sphere", true, false}};
    point.facts.steps = 100000;
    point.facts.end_time_s = 1;
    std::filesystem::create_directories(run(point.key) / "checkpoints");
    write_point(run(point.key) / "point.json", point);
    return point;
  }

  void add_checkpoint(const std::string& key, std::int64_t step) const {
    ::rouleau::testing::set_content(run(key) / "checkpoints" / fmt::format("{:012}.h5", step), "checkpoint");
  }

  /// attempts/<number>/ with owner and process.json, of a process that is gone.
  void add_attempt(const std::string& key, int number, std::int64_t checkpoint_step = -1) const {
    const std::filesystem::path folder = run(key) / "attempts" / std::to_string(number);
    std::filesystem::create_directories(folder);
    ::rouleau::testing::set_content(folder / "owner", fmt::format("token{}\n", number));
    ::rouleau::testing::set_content(
        folder / "process.json",
        fmt::format(R"({{"contract": 1, "host": "{}", "pid": 4711, "start_ticks": 99, "boot_id": "b", "ranks": 2,
                        "checkpoint_step": {}, "started_unix_s": {}}})",
                    host, checkpoint_step, 1.7e9 + 1000 * number));
  }

  void end_attempt(const std::string& key, int number, int code, std::int64_t start_step, std::int64_t step) const {
    ::rouleau::testing::set_content(
        run(key) / "attempts" / std::to_string(number) / "exit.json",
        fmt::format(R"({{"contract": 1, "code": {}, "reason": "test", "step": {}, "end_step": 100000, "start_step": {},
                        "wall_s": 10.5, "core_s": 21.0, "ranks": 2, "mlups": 20.5, "host": "n1",
                        "resumed_from": "checkpoints/x.h5", "rejected_checkpoints": [], "version": "0.1.0",
                        "git": "abc", "finished_unix_s": {}}})",
                    code, step, start_step, 1.7e9 + 1000 * number + 500));
  }

  std::string host = "n1";  ///< where attempts are said to run

 private:
  ::rouleau::testing::TemporaryDirectory directory_;
};

}  // namespace rouleau::campaign::testing
