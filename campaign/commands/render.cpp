// SPDX-License-Identifier: BSD-3-Clause
// `rouleau render POINT`: a picture of the cell in its channel, or a film strip.
#include <algorithm>
#include <cmath>
#include <ostream>

#include "commands/report_gnuplot.hpp"
#include "commands/report_shapes.hpp"
#include "commands/verbs.hpp"
#include "commands/wish.hpp"
#include "executor/solver.hpp"
#include "report/cell_tiles.hpp"
#include "report/channel_picture.hpp"
#include "report/thin.hpp"
#include "study/numbers.hpp"
#include "study/point.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

constexpr int most_of_a_film = 60;
constexpr double time_out_s = 120;

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("at", po::value<std::string>()->value_name("T"),
      "physical time in s: the picture nearest to it (default: the newest)");
  add("film", po::value<int>()->value_name("N"), "so many pictures over time, side by side");
  add("output,o", po::value<std::string>()->value_name("FILE"),
      "FILE.svg or FILE.png; svg or png alone: point-<number> of that kind (default: svg)");
}

std::filesystem::path output_of(const CommandLine& line, const PointRow& point) {
  const std::string wish = line.has("output") ? line.get<std::string>("output") : "svg";
  if (wish == "svg" || wish == "png") return fmt::format("point-{}.{}", point.ordinal, wish);
  const std::filesystem::path file = wish;
  if (file.extension() != ".svg" && file.extension() != ".png")
    fail(Exit::usage, "rouleau render: -o {}: a name that ends with .svg or .png is needed", wish);
  return file;
}

PointRow only_point(const CommandLine& line) {
  const std::vector<PointRow> points = named_points(line, "render");
  if (points.size() > 1)
    fail(Exit::usage, "rouleau render: these words name {} points (#{}, #{}{}); name one", points.size(),
         points[0].ordinal, points[1].ordinal, points.size() > 2 ? ", ..." : "");
  return points.front();
}

/// The files to draw, oldest first.
std::vector<ShapeFile> chosen_files(const CommandLine& line, const std::vector<ShapeFile>& files, double time_step_s) {
  std::vector<double> times;
  for (const ShapeFile& file : files) times.push_back(static_cast<double>(file.step) * time_step_s);
  if (line.has("film")) {
    const int count = line.get<int>("film");
    if (count < 1 || count > most_of_a_film)
      fail(Exit::usage, "rouleau render: --film {}: 1 to {} pictures are possible", count, most_of_a_film);
    std::vector<ShapeFile> chosen;
    for (const std::size_t i : spread_evenly(times, static_cast<std::size_t>(count))) chosen.push_back(files[i]);
    return chosen;
  }
  if (!line.has("at")) return {files.back()};
  const std::optional<double> wanted = parse_number(line.get<std::string>("at"));
  if (!wanted) fail(Exit::usage, "rouleau render: --at {} is no time in seconds", line.get<std::string>("at"));
  const auto nearest = std::min_element(
      times.begin(), times.end(), [&](double a, double b) { return std::abs(a - *wanted) < std::abs(b - *wanted); });
  return {files[static_cast<std::size_t>(nearest - times.begin())]};
}

/// A PNG of an SVG text.   throws Error (failed) saying what to install; the SVG is then left beside
void write_png(const std::filesystem::path& file, const std::string& svg) {
  std::filesystem::path beside = file;
  beside.replace_extension(".svg");
  if (!find_on_path("rsvg-convert")) {
    write_whole_file(beside, svg);
    fail(Exit::failed,
         "{}: rsvg-convert, which makes PNG files, is not on the PATH. Install it (Debian: apt-get install "
         "librsvg2-bin), or "
         "use {}, which was written.",
         file.string(), beside.string());
  }
  const ScratchDirectory scratch;
  write_whole_file(scratch.path() / "picture.svg", svg);
  const Capture capture = run_and_capture({"rsvg-convert", "-o", "picture.png", "picture.svg"},
                                          {.directory = scratch.path(), .time_out_s = time_out_s, .environment = {}});
  const auto png = read_whole_file(scratch.path() / "picture.png");
  if (capture.status != 0 || !png)
    fail(Exit::failed, "{}: rsvg-convert ended with status {}: {}. Write an .svg instead.", file.string(),
         capture.status, capture.err.substr(0, capture.err.find('\n')));
  write_whole_file(file, *png);
}

int render(const CommandLine& line) {
  const PointRow row = only_point(line);
  if (line.has("at") && line.has("film")) fail(Exit::usage, "rouleau render: --at and --film exclude each other");
  const std::filesystem::path file = output_of(line, row), run = point_directory(line.directory, row.key);
  const std::vector<ShapeFile> files = shape_files(run);
  if (files.empty())
    fail(Exit::not_found, "#{}: no checkpoint and no snapshot in {} yet; `rouleau status` says how far it is",
         row.ordinal, run.string());
  const Point point = read_point(run / "point.json");
  ShapeReader reader;
  std::vector<Shape> shapes;
  for (const ShapeFile& chosen : chosen_files(line, files, 1e-6 * point.facts.time_step_us))
    if (auto shape = reader.read(chosen, false)) shapes.push_back(std::move(*shape));
  const std::string problem = reader.take_problem();
  if (shapes.empty())
    fail(Exit::failed, "#{}: {}", row.ordinal,
         problem.empty() ? "the file has just been replaced; do the same again" : problem);
  if (!problem.empty()) line.io.err << problem << '\n';

  std::string name = fmt::format("#{}", row.ordinal);
  if (const std::string* lambda = point.find("fluid.lambda")) name += ", λ = " + *lambda;
  const std::string svg = line.has("film") ? film_strip(shapes, name) : channel_picture(shapes.front(), name);
  if (file.has_parent_path()) make_directories(file.parent_path());
  if (file.extension() == ".png")
    write_png(file, svg);
  else
    write_whole_file(file, svg);
  if (!line.quiet) {
    if (line.has("film"))
      line.io.err << fmt::format("{}: {} pictures, {:.4g} to {:.4g} s\n", file.string(), shapes.size(),
                                 shapes.front().time_s, shapes.back().time_s);
    else
      line.io.err << fmt::format("{}: at {:.4g} s\n", file.string(), shapes.front().time_s);
  }
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb render_verb = {
    "render",
    "a picture of a point's cell in its channel, or a film strip",
    "POINT [-C DIR] [--at T | --film N] [-o FILE.svg|FILE.png]",
    "  rouleau render '#3' -C my-campaign             newest checkpoint or snapshot, as point-3.svg\n"
    "  rouleau render lambda=5 --at 0.2 -o cell.png   the picture nearest to 0.2 s\n"
    "  rouleau render lambda=5 --film 6 -o film.svg   six pictures over time\n",
    "Draws what is on the disk: the newest checkpoints, and snapshots of cells if the study asks for them. Side view "
    "(the\n"
    "flow goes to the right) and front view, with walls and a scale. PNG needs rsvg-convert.\n",
    Words::points,
    false,
    describe,
    render,
};

}  // namespace rouleau::campaign
