// SPDX-License-Identifier: BSD-3-Clause
// Listing, asking, remembering.
#include "commands/report_shapes.hpp"

#include <fmt/format.h>

#include <charconv>

#include "executor/solver.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

constexpr double time_out_s = 60;
constexpr std::string_view snapshot_prefix = "cells-", ending = ".h5";

/// The step of snapshots/cells-<step>.h5, or nothing.
std::optional<std::int64_t> snapshot_step(const std::string& name) {
  if (!name.starts_with(snapshot_prefix) || !name.ends_with(ending)) return std::nullopt;
  const std::string digits = name.substr(snapshot_prefix.size(), name.size() - snapshot_prefix.size() - ending.size());
  std::int64_t step = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), step);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return step;
}

}  // namespace

std::vector<ShapeFile> shape_files(const std::filesystem::path& run_directory) {
  std::map<std::int64_t, ShapeFile> by_step;
  for (const std::int64_t step : checkpoint_steps(run_directory))
    by_step[step] = {run_directory / "checkpoints" / fmt::format("{:012}.h5", step), step, true};
  std::error_code error;
  for (std::filesystem::directory_iterator entry(run_directory / "snapshots", error), end; !error && entry != end;
       entry.increment(error)) {
    if (const auto step = snapshot_step(entry->path().filename().string()))
      by_step[*step] = {entry->path(), *step, false};
  }
  std::vector<ShapeFile> files;
  for (const auto& [step, file] : by_step) files.push_back(file);
  return files;
}

ShapeReader::ShapeReader() {
  try {
    solver_ = find_solver();
  } catch (const Error& error) {
    no_solver_ = error.what();
  }
}

std::optional<Shape> ShapeReader::read(const ShapeFile& file, bool with_slice) {
  std::error_code error;
  const auto written = std::filesystem::last_write_time(file.path, error);
  if (error) return std::nullopt;
  const auto found = remembered_.find({file.path, with_slice});
  if (found != remembered_.end() && found->second.written == written) {
    found->second.is_read = true;
    return found->second.shape;
  }
  if (solver_.empty()) {
    problem_ = "Pictures of the cells are missing: " + no_solver_;
    return std::nullopt;
  }
  std::vector<std::string> command = {solver_, "shape", std::filesystem::absolute(file.path).string()};
  if (with_slice) command.insert(command.end(), {"--slice", "y"});
  std::string why;
  try {
    const Capture capture = run_and_capture(command, {.directory = {}, .time_out_s = time_out_s, .environment = {}});
    if (capture.status == 0) {
      Shape shape = parse_shape(capture.out, solver_ + " shape " + file.path.string());
      remembered_[{file.path, with_slice}] = {written, shape, true};
      return shape;
    }
    why = capture.timed_out     ? fmt::format("rouleau-solver shape took longer than {:g} s", time_out_s)
          : capture.err.empty() ? fmt::format("rouleau-solver shape ended with status {}", capture.status)
                                : capture.err;
  } catch (const Error& failure) {
    why = failure.what();
  }
  if (!std::filesystem::exists(file.path, error)) return std::nullopt;
  if (failures_++ == 0) problem_ = why.substr(0, why.find('\n'));
  return std::nullopt;
}

std::string ShapeReader::take_problem() {
  std::string problem = failures_ > 0 ? fmt::format("{} picture{} of cells could not be read: {}", failures_,
                                                    failures_ == 1 ? "" : "s", problem_)
                                      : problem_;
  problem_.clear();
  failures_ = 0;
  return problem;
}

void ShapeReader::forget_unread() {
  std::erase_if(remembered_, [](const auto& entry) { return !entry.second.is_read; });
  for (auto& [file, remembered] : remembered_) remembered.is_read = false;
}

}  // namespace rouleau::campaign
