// SPDX-License-Identifier: BSD-3-Clause
// Data and scripts into a directory, gnuplot over them.
#include "commands/report_gnuplot.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>

#include "executor/capture.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

constexpr double time_out_s = 300;

std::string ending_of(FigureFormat format) { return format == FigureFormat::svg ? ".svg" : ".pdf"; }

bool is_drawn(const Figure& figure, const std::filesystem::path& directory, FigureFormat format) {
  std::error_code error;
  const auto size = std::filesystem::file_size(directory / (figure.name + ending_of(format)), error);
  return !error && size > 0;
}

/// What gnuplot complains of: its last line, which names the place.
std::string complaint_of(const Capture& capture) {
  if (capture.timed_out) return fmt::format("it took longer than {:g} s", time_out_s);
  const std::size_t end = capture.err.find_last_not_of(" \n\t");
  if (end == std::string::npos) return fmt::format("it ended with status {}", capture.status);
  const std::size_t before = capture.err.rfind('\n', end);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return capture.err.substr(begin, end + 1 - begin);
}

Capture run_gnuplot(const std::string& script, const std::filesystem::path& directory) {
  return run_and_capture({"gnuplot", "-d", script},
                         {.directory = directory, .time_out_s = time_out_s, .environment = {}});
}

}  // namespace

std::optional<std::filesystem::path> find_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::filesystem::path place = std::filesystem::path(rest.substr(0, colon)) / program;
    std::error_code error;
    if (std::filesystem::is_regular_file(place, error) && ::access(place.c_str(), X_OK) == 0) return place;
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
  }
  return std::nullopt;
}

std::string draw_figures(std::span<const Figure> figures, const std::filesystem::path& directory, FigureFormat format) {
  if (figures.empty()) return "";
  std::string all;
  for (const Figure& figure : figures) {
    std::error_code ignored;
    std::filesystem::remove(directory / (figure.name + ending_of(format)), ignored);
    write_whole_file(directory / (figure.name + ".dat"), figure.data);
    write_whole_file(directory / (figure.name + ".gp"), figure_script(figure, format));
    all += fmt::format("load '{}.gp'\n", figure.name);
  }
  if (!find_on_path("gnuplot"))
    return "gnuplot is not on the PATH, so the figures are missing; the tables are complete. Install it (Debian: "
           "apt-get "
           "install gnuplot-nox) and call `rouleau report` again.";
  const std::filesystem::path script = directory / "all-figures.gp";
  write_whole_file(script, all);
  Capture capture = run_gnuplot(script.filename(), directory);
  std::error_code ignored;
  std::filesystem::remove(script, ignored);
  if (capture.status == 0) return "";
  std::string missing, complaint;
  for (const Figure& figure : figures) {
    capture = run_gnuplot(figure.name + ".gp", directory);
    if (capture.status == 0 && is_drawn(figure, directory, format)) continue;
    std::filesystem::remove(directory / (figure.name + ending_of(format)), ignored);
    missing += (missing.empty() ? "" : ", ") + figure.name;
    if (complaint.empty()) complaint = complaint_of(capture);
  }
  if (missing.empty()) return "";
  return fmt::format("gnuplot did not draw {}: {}. `--figures svg` leaves data and scripts to try by hand.", missing,
                     complaint);
}

}  // namespace rouleau::campaign
