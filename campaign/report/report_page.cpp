// SPDX-License-Identifier: BSD-3-Clause
// Sections in the order in which a reader asks: what came out, how it went, what it cost, where it is from.
#include "report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/cell_tiles.hpp"
#include "report/markup.hpp"
#include "report/palette.hpp"
#include "report/report_style.hpp"
#include "report/report_tables.hpp"

namespace rouleau::campaign {
namespace {

/// A section with a heading that can be linked to.
struct Section {
  std::string id, heading, body;
};

std::string figure_element(const DrawnFigure& drawn, bool with_title) {
  if (!drawn.svg) return "";
  return fmt::format("<figure>{}<figcaption>{}{}</figcaption></figure>\n", *drawn.svg,
                     with_title ? fmt::format("<strong>{}</strong>. ", escaped(drawn.figure.title)) : "",
                     escaped(drawn.figure.description));
}

std::string figure_element(const std::optional<DrawnFigure>& drawn) {
  return drawn ? figure_element(*drawn, false) : "";
}

std::string folded(bool is_open, const std::string& summary, const std::string& body) {
  return fmt::format("<details{}><summary>{}</summary>\n{}</details>\n", is_open ? " open" : "", escaped(summary),
                     body);
}

std::string heading_of(const ReportPoint& point) { return fmt::format("#{}: {}", point.row.ordinal, point.label()); }

/// One point after the other, or, when they are many, folded by class; in an element of class `box` if one is named.
template <class BodyOf>
std::string by_point(const ReportData& data, const std::string& box, const BodyOf& body_of) {
  const auto boxed = [&](const std::string& body) {
    return box.empty() || body.empty() ? body : fmt::format("<div class=\"{}\">\n{}</div>\n", box, body);
  };
  std::array<std::string, class_looks.size() + 1> bodies;
  std::array<int, class_looks.size() + 1> counts{};
  const bool is_spread = data.points.size() <= most_spread_points;
  for (const ReportPoint& point : data.points) {
    std::size_t group = class_looks.size();
    for (std::size_t look = 0; look < class_looks.size() && !is_spread; ++look)
      if (point.result() != nullptr && point.result()->phase == class_looks[look].name) group = look;
    const std::string body = body_of(point);
    bodies[group] += body;
    counts[group] += body.empty() ? 0 : 1;
  }
  if (is_spread) return boxed(bodies.back());
  std::string text;
  for (std::size_t group = 0; group < bodies.size(); ++group) {
    if (counts[group] == 0) continue;
    const std::string name = group < class_looks.size() ? std::string(class_looks[group].name) : "without a result";
    text += folded(false, fmt::format("{}: {} point{}", name, counts[group], counts[group] == 1 ? "" : "s"),
                   boxed(bodies[group]));
  }
  return text;
}

std::string series_section(const ReportData& data, const PageParts& parts) {
  return by_point(data, "figures", [&](const ReportPoint& point) {
    const auto found = parts.series.find(point.row.ordinal);
    return found == parts.series.end() ? std::string() : figure_element(found->second, true);
  });
}

std::string shape_row(const ReportPoint& point, const std::vector<Shape>& shapes, double window) {
  std::string text = fmt::format("<h3>{}</h3>\n<div class=\"tiles\">\n", escaped(heading_of(point)));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Shape& shape = shapes[i];
    const std::string id = fmt::format("shape-{}-{}", point.row.ordinal, i);
    text += tile_element(shape_tile(shape, window, id), id,
                         fmt::format("Cell of {} at {:.3g} s", heading_of(point), shape.time_s),
                         fmt::format("Side view above, front view below; its centre is {:.2f} µm from the axis.",
                                     displacement_um(shape, shape.cells.front())));
  }
  return text + "</div>\n";
}

std::string shape_section(const ReportData& data, const PageParts& parts) {
  double window = 0;  // one for all, so that they can be compared
  for (const auto& [ordinal, shapes] : parts.shapes)
    for (const Shape& shape : shapes) window = std::max(window, window_um(shape));
  const std::string rows = by_point(data, "", [&](const ReportPoint& point) {
    const auto found = parts.shapes.find(point.row.ordinal);
    return found == parts.shapes.end() ? std::string() : shape_row(point, found->second, window);
  });
  if (rows.empty()) return "";
  return "<p>From checkpoints and snapshots on the disk, oldest first. Above: from the side, the flow goes to the "
         "right; "
         "below: from the front, the flow comes towards the eye. Lines are walls.</p>\n" +
         rows;
}

std::string slice_section(const ReportData& data, const PageParts& parts) {
  double window = 0;
  for (const auto& [ordinal, shape] : parts.slices) window = std::max(window, window_um(shape));
  std::string text;
  for (const ReportPoint& point : data.points) {
    const auto found = parts.slices.find(point.row.ordinal);
    if (found == parts.slices.end()) continue;
    const Shape& shape = found->second;
    text += fmt::format(
        "<figure>{}<figcaption>{}</figcaption></figure>\n",
        tile_element(slice_tile(shape, window), fmt::format("slice-{}", point.row.ordinal),
                     fmt::format("Inside and outside of the cell of {} at {:.3g} s", heading_of(point), shape.time_s),
                     "Nodes inside the cell are squares, nodes outside are dots, the membrane is a line."),
        escaped(heading_of(point)));
  }
  if (text.empty()) return "";
  return "<p>The flag of each node in a plane through the cell, of the newest checkpoint: squares have the viscosity "
         "of the "
         "inside, dots that of the outside. The line is the membrane in that plane, which the flags must follow.</p>\n"
         "<div class=\"slices\">\n" +
         text + "</div>\n";
}

std::vector<Section> sections_of(const ReportData& data, const PageParts& parts) {
  const bool is_large = data.points.size() > 60;
  std::vector<Section> sections = {
      {"phase-diagram", "Phase diagram", figure_element(parts.phase) + figure_element(parts.map)},
      {"points", "Points",
       is_large ? folded(false, fmt::format("Table of {} points", data.points.size()), point_table(data))
                : point_table(data)},
      {"series", "Over time", figure_element(parts.overlay)},
      {"single-series", "Each point over time", series_section(data, parts)},
      {"shapes", "Shapes of the cells", shape_section(data, parts)},
      {"slices", "Inside and outside", slice_section(data, parts)}};
  std::size_t attempts = 0;
  for (const ReportPoint& point : data.points) attempts += point.attempts.size();
  if (attempts > 0)
    sections.push_back({"starts", "Starts of the solver",
                        figure_element(parts.timeline) +
                            folded(attempts <= 20, fmt::format("Table of {} starts", attempts), attempt_table(data))});
  sections.push_back({"cost", "Cost", cost_table(data)});
  sections.push_back({"provenance", "Provenance", provenance(data)});
  std::erase_if(sections, [](const Section& section) { return section.body.empty(); });
  return sections;
}

std::string header_of(const ReportData& data, const std::vector<std::string>& notes) {
  std::size_t with_result = 0;
  for (const ReportPoint& point : data.points) with_result += point.results.empty() ? 0 : 1;
  std::string text = fmt::format("<h1>{}</h1>\n<p>{} point{}: {}. Written {}{}.</p>\n", escaped(data.campaign.name),
                                 data.points.size(), data.points.size() == 1 ? "" : "s", escaped(state_counts(data)),
                                 moment_text(data.written_unix_s),
                                 data.is_finished() ? "" : "; the campaign is not finished, figures will change");
  if (with_result == 0)
    text += "<p class=\"note\">No point has a result yet: figures appear with the first samples.</p>\n";
  for (const std::string& note : notes) text += fmt::format("<p class=\"note\">{}</p>\n", escaped(note));
  return text;
}

}  // namespace

std::string report_page(const ReportData& data, const PageParts& parts) {
  const std::vector<Section> sections = sections_of(data, parts);
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  text += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  if (parts.refresh_s) text += fmt::format("<meta http-equiv=\"refresh\" content=\"{}\">\n", *parts.refresh_s);
  text += fmt::format("<title>{}: report</title>\n<style>{}</style>\n</head>\n<body>\n<header>\n",
                      escaped(data.campaign.name), report_style);
  text += header_of(data, parts.notes) + "<nav aria-label=\"Sections\">";
  for (const Section& section : sections)
    text += fmt::format("<a href=\"#{}\">{}</a> ", section.id, escaped(section.heading));
  text += "</nav>\n</header>\n<main>\n";
  for (const Section& section : sections)
    text += fmt::format("<section aria-labelledby=\"{0}\"><h2 id=\"{0}\">{1}</h2>\n{2}</section>\n", section.id,
                        escaped(section.heading), section.body);
  return text + "</main>\n</body>\n</html>\n";
}

}  // namespace rouleau::campaign
