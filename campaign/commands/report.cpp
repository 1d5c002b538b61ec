// SPDX-License-Identifier: BSD-3-Clause
// `rouleau report`: the campaign as one HTML file, and its figures as files.
#include <algorithm>
#include <chrono>
#include <ostream>

#include "commands/report_contents.hpp"
#include "commands/report_gnuplot.hpp"
#include "commands/verbs.hpp"
#include "executor/signals.hpp"
#include "executor/solver.hpp"
#include "report/cell_tiles.hpp"
#include "report/inline_svg.hpp"
#include "study/numbers.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

struct ReportWish {
  std::filesystem::path campaign, file;
  std::optional<FigureFormat> figures;
  std::filesystem::path figures_directory;
  std::optional<double> watch_s;
};

void describe(po::options_description& options) {
  auto add = options.add_options();
  add("output,o", po::value<std::string>()->value_name("FILE"),
      "the file, FILE.html (default: report.html in the campaign)");
  add("watch", po::value<std::string>()->implicit_value("60")->value_name("SECONDS"),
      "write it anew so often (60) until all points are through or Ctrl-C");
  add("figures", po::value<std::string>()->value_name("pdf|svg"),
      "also write every figure as a file, with its data and its gnuplot script");
  add("figures-dir", po::value<std::string>()->value_name("DIR"), "where (default: report-figures beside the report)");
}

ReportWish wish_of(const CommandLine& line) {
  ReportWish wish;
  wish.campaign = line.directory;
  wish.file =
      line.has("output") ? std::filesystem::path(line.get<std::string>("output")) : line.directory / "report.html";
  // A slip of the hand (-o campaign.db) must not write over what is no report.
  if (wish.file.extension() != ".html" && wish.file.extension() != ".htm")
    fail(Exit::usage, "rouleau report: -o {}: the name of a report ends in .html", wish.file.string());
  if (line.has("figures")) {
    const auto& format = line.get<std::string>("figures");
    if (format != "pdf" && format != "svg")
      fail(Exit::usage, "rouleau report: --figures {}: there are pdf and svg", format);
    wish.figures = format == "pdf" ? FigureFormat::pdf : FigureFormat::svg;
  } else if (line.has("figures-dir")) {
    fail(Exit::usage, "rouleau report: --figures-dir goes with --figures pdf or --figures svg");
  }
  wish.figures_directory = line.has("figures-dir") ? std::filesystem::path(line.get<std::string>("figures-dir"))
                                                   : wish.file.parent_path() / (wish.file.stem().string() + "-figures");
  if (line.has("watch")) {
    wish.watch_s = parse_number(line.get<std::string>("watch"));
    if (!wish.watch_s || !(*wish.watch_s >= 1) || *wish.watch_s > 86400)
      fail(Exit::usage, "rouleau report: --watch={}: seconds from 1 to 86400 are needed, or none",
           line.get<std::string>("watch"));
  }
  return wish;
}

/// Puts drawn figures where the page shows them.
void add_figures(PageParts& parts, const ReportData& data, const std::vector<Figure>& figures,
                 const std::filesystem::path& drawn_in) {
  const auto drawn = [&](const Figure& figure) -> DrawnFigure {
    const auto text = read_whole_file(drawn_in / (figure.name + ".svg"));
    return {figure, text ? inline_svg(figure, *text) : std::nullopt};
  };
  std::map<std::string, int> ordinal_of;
  for (const ReportPoint& point : data.points)
    ordinal_of[fmt::format("point-{}", point.row.ordinal)] = point.row.ordinal;
  for (const Figure& figure : figures) {
    if (figure.name == "phase") parts.phase = drawn(figure);
    if (figure.name == "map") parts.map = drawn(figure);
    if (figure.name == "overlay") parts.overlay = drawn(figure);
    if (figure.name == "timeline") parts.timeline = drawn(figure);
    if (const auto found = ordinal_of.find(figure.name); found != ordinal_of.end())
      parts.series[found->second] = drawn(figure);
  }
}

/// Figures and film strips as files.
std::string write_figures(const ReportWish& wish, const ReportData& data, const std::vector<Figure>& figures,
                          const PageParts& parts) {
  make_directories(wish.figures_directory);
  for (const ReportPoint& point : data.points) {
    const auto found = parts.shapes.find(point.row.ordinal);
    if (found == parts.shapes.end()) continue;
    write_whole_file(wish.figures_directory / fmt::format("cells-{}.svg", point.row.ordinal),
                     film_strip(found->second, fmt::format("#{}: {}", point.row.ordinal, point.label())));
  }
  return draw_figures(figures, wish.figures_directory, *wish.figures);
}

/// Writes the report once.   returns whether every point is through
bool write_report(const CommandLine& line, const ReportWish& wish, ShapeReader& reader) {
  const ReportData data = report_data(wish.campaign, wish.file);
  const std::vector<Figure> figures = report_figures(data);
  PageParts parts;
  const ScratchDirectory scratch;
  if (std::string problem = draw_figures(figures, scratch.path(), FigureFormat::svg); !problem.empty())
    parts.notes.push_back(std::move(problem));
  add_figures(parts, data, figures, scratch.path());
  add_shapes(parts, data, wish.campaign, reader);
  const bool is_finished = data.is_finished();
  if (wish.watch_s && !is_finished) parts.refresh_s = static_cast<int>(*wish.watch_s);
  if (wish.figures) {
    const std::string problem = write_figures(wish, data, figures, parts);
    if (!problem.empty() && parts.notes.empty()) parts.notes.push_back(problem);
  }
  const std::string page = report_page(data, parts);
  if (wish.file.has_parent_path()) make_directories(wish.file.parent_path());
  write_whole_file(wish.file, page);
  if (!line.quiet) {
    for (const std::string& note : parts.notes) line.io.err << "note: " << note << '\n';
    line.io.err << fmt::format("{}: {} point{}, {:.1f} MB\n", wish.file.string(), data.points.size(),
                               data.points.size() == 1 ? "" : "s", static_cast<double>(page.size()) / 1e6);
    if (wish.figures)
      line.io.err << fmt::format("{}: {} figures with data and scripts\n", wish.figures_directory.string(),
                                 figures.size());
  }
  return is_finished;
}

/// Waits so many seconds.   returns false if the user wants an end
bool wait(SignalWatch& signals, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  while (true) {
    const double left_ms = std::chrono::duration<double, std::milli>(until - Clock::now()).count();
    if (left_ms <= 0) return true;
    const int signal = signals.wait(static_cast<int>(std::min(left_ms + 1, 1e6)));
    if (signal != 0 && signal != SIGCHLD) return false;
  }
}

int report(const CommandLine& line) {
  const ReportWish wish = wish_of(line);
  ShapeReader reader;
  if (!wish.watch_s) {
    write_report(line, wish, reader);
    return static_cast<int>(Exit::ok);
  }
  SignalWatch signals;
  bool is_finished = write_report(line, wish, reader);
  while (!is_finished) {
    if (!wait(signals, *wish.watch_s)) return static_cast<int>(Exit::interrupted);
    try {
      is_finished = write_report(line, wish, reader);
    } catch (const Error& error) {  // a disk that is full for a moment is no reason to stop looking
      line.io.err << error.what() << "\n";
    }
  }
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb report_verb = {
    "report",
    "the campaign as one HTML file: phase diagram, series, cells, cost",
    "[DIR] [-o FILE] [--watch[=SECONDS]] [--figures pdf|svg] [--figures-dir DIR]",
    "  rouleau report my-campaign                     writes my-campaign/report.html\n"
    "  rouleau report my-campaign --watch             anew every minute while the campaign runs\n"
    "  rouleau report my-campaign -o sent/lambda.html somewhere else; links to run directories are relative\n"
    "  rouleau report my-campaign --figures pdf       figures in print size, with data and scripts to restyle\n",
    "One file without scripts that asks no network for anything: send it, print it, read it on a phone. Reads only, "
    "and\n"
    "works while `rouleau run` runs. Figures need gnuplot, pictures of cells rouleau-solver and checkpoints or "
    "snapshots\n"
    "on the disk; what is missing is said in the report.\n",
    Words::campaign,
    false,
    describe,
    report,
};

}  // namespace rouleau::campaign
