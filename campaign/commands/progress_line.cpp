// SPDX-License-Identifier: BSD-3-Clause
// Writing progress.
#include "commands/progress_line.hpp"

#include <fmt/chrono.h>

#include <ostream>

#include "commands/duration.hpp"
#include "ingest/run_files.hpp"
#include "study/point.hpp"

namespace rouleau::campaign {

namespace {

constexpr auto terminal_interval = std::chrono::seconds(1);
constexpr auto plain_interval = std::chrono::seconds(60);
constexpr std::size_t most_jobs = 8;  // told one by one
constexpr const char* to_line_start_and_erase = "\r\033[K";

std::string job_text(const Manager& manager, const LivingJob& job) {
  std::vector<std::string> ignored;  // progress.json is replaced all the time; a bad one is not worth a word
  const auto progress = read_progress_file(point_directory(manager.directory(), job.key) / "progress.json", ignored);
  if (!progress || progress->attempt != job.attempt || progress->end_step <= 0)
    return fmt::format("#{} {}", job.ordinal, job.words.empty() ? "starts" : job.words);
  const double percent = 100.0 * static_cast<double>(progress->step) / static_cast<double>(progress->end_step);
  std::string text = fmt::format("#{} {:.0f} %", job.ordinal, percent);
  if (progress->eta_s) text += fmt::format(" {} left", duration_text(*progress->eta_s));
  return text;
}

}  // namespace

std::string counts_text(const StateCounts& counts) {
  std::string text;
  for (const State state : {State::done, State::running, State::waiting, State::stopped, State::crashed, State::failed,
                            State::refused, State::exhausted, State::cancelled}) {
    const auto found = counts.find(state);
    if (found == counts.end()) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", found->second, word_of(state));
  }
  return text.empty() ? "no points" : text;
}

std::string progress_text(const Manager& manager) {
  std::string text = counts_text(manager.counts());
  const char* separator = " | ";
  std::size_t shown = 0;
  for (const LivingJob& job : manager.living()) {
    text += separator;
    if (++shown > most_jobs) {
      text += fmt::format("{} more", manager.living().size() - most_jobs);
      break;
    }
    text += job_text(manager, job);
    separator = ", ";
  }
  if (!manager.engine_trouble().empty()) text += " | Slurm does not answer";
  if (const double pause = manager.next_retry_in_s(); manager.living().empty() && pause > 0) {
    text += fmt::format(" | next retry in {}", duration_text(pause));
  }
  return text;
}

void ProgressLine::say(const std::string& message) {
  if (quiet_) return;
  clear();
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  io_.err << fmt::format("{:%H:%M:%S} ", fmt::localtime(now)) << message << std::endl;
}

void ProgressLine::show(const Manager& manager) {
  const Clock::time_point now = Clock::now();
  if (quiet_ || now < next_) return;
  const bool is_first = next_ == Clock::time_point{};
  next_ = now + (io_.err_is_terminal ? terminal_interval : plain_interval);
  if (!io_.err_is_terminal) {
    if (!is_first) say(progress_text(manager));
    return;
  }
  std::string text = progress_text(manager);
  const auto room = static_cast<std::size_t>(std::max(20, io_.columns - 1));
  if (text.size() > room) text.resize(room);
  io_.err << to_line_start_and_erase << text << std::flush;
  is_shown_ = true;
}

void ProgressLine::clear() {
  if (is_shown_) io_.err << to_line_start_and_erase << std::flush;
  is_shown_ = false;
}

}  // namespace rouleau::campaign
