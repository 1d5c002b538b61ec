// SPDX-License-Identifier: BSD-3-Clause
#include "run/progress_bar.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace rouleau {

namespace {

constexpr double interval_s = 0.5;
constexpr std::size_t bar_width = 20, usual_columns = 80;
constexpr const char* to_line_start = "\r";
constexpr const char* erase_the_rest = "\033[K";

/// "41 s", "3 min 10 s", "2 h 05 min", "4 d 07 h"
std::string duration_text(double seconds) {
  const auto s = static_cast<std::int64_t>(std::max(0.0, seconds));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  if (s < 86400) return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
  return fmt::format("{} d {:02} h", s / 86400, s / 3600 % 24);
}

bool can_be_drawn_over() {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::size_t columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual_columns;
}

}  // namespace

std::string progress_line(const Progress& p, std::size_t width) {
  const double fraction =
      p.end_step > 0 ? std::clamp(static_cast<double>(p.step) / static_cast<double>(p.end_step), 0.0, 1.0) : 0;
  const auto full = static_cast<std::size_t>(fraction * bar_width);
  std::vector<std::string> parts = {
      fmt::format("[{}{}] {:3.0f} %", std::string(full, '#'), std::string(bar_width - full, '.'), 100 * fraction),
      fmt::format("step {} / {}", p.step, p.end_step)};
  if (p.eta_s) parts.push_back(duration_text(*p.eta_s) + " left");
  parts.push_back(fmt::format("{:.1f} MLUPS", p.mlups));
  if (p.d_um) parts.push_back(fmt::format("d {:.3f} um", *p.d_um));
  if (p.checkpoint_unix_s > 0)
    parts.push_back(fmt::format("checkpoint {} ago", duration_text(p.updated_unix_s - p.checkpoint_unix_s)));
  std::string line;
  for (const std::string& part : parts) {
    const std::string gap = line.empty() ? "" : "  ";
    if (line.size() + gap.size() + part.size() > width) break;
    line += gap + part;
  }
  return line;
}

ProgressBar::ProgressBar(bool wanted) : is_shown_(wanted && can_be_drawn_over()) {}

ProgressBar::~ProgressBar() {
  if (is_drawn_) fmt::print(stderr, "\n");
}

void ProgressBar::draw(const Progress& progress, double now_s) {
  // One column stays free: behind the last one some terminals have wrapped already.
  fmt::print(stderr, "{}{}{}", to_line_start, progress_line(progress, columns() - 1), erase_the_rest);
  is_drawn_ = true;
  next_s_ = now_s + interval_s;
}

}  // namespace rouleau
