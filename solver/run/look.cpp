// SPDX-License-Identifier: BSD-3-Clause
#include "run/look.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "run/check.hpp"
#include "run/conversion_table.hpp"
#include "run/setup.hpp"
#include "run/snapshots.hpp"
#include "storage/inspect.hpp"

namespace rouleau {

using nlohmann::ordered_json;

std::string check_text(const std::filesystem::path& run_file, bool json, FileSystem& files) {
  const Setup setup = set_up(run_file, files);
  if (json) {
    CheckCounts counts;
    counts.cells = static_cast<std::int64_t>(setup.cells.starts.size());
    counts.triangles = setup.cells.triangles();
    counts.vertices = setup.cells.vertices();
    counts.checkpoint_bytes = checkpoint_bytes(setup);
    counts.snapshot_bytes = snapshot_bytes(setup);
    return check_json(setup.run, setup.lattice, counts, setup.warnings).dump(2) + "\n";
  }
  std::string text = conversion_table(setup.run, setup.lattice, setup.units, setup.cells.meshes);
  text += fmt::format("a checkpoint takes {:.1f} MB\n", static_cast<double>(checkpoint_bytes(setup)) * 1e-6);
  const SnapshotPlan plan(setup);
  if (const std::int64_t cells = plan.cell_count(setup.lattice.steps), fields = plan.field_count(setup.lattice.steps);
      cells + fields > 0)
    text += fmt::format("{} snapshots of the fields and {} of the cells take about {:.1f} MB\n", fields, cells,
                        static_cast<double>(snapshot_bytes(setup)) * 1e-6);
  for (const auto& warning : setup.warnings) text += "warning: " + warning + "\n";
  return text;
}

namespace {

ordered_json report_json(const CheckpointReport& report) {
  ordered_json items = ordered_json::array(), cells = ordered_json::array();
  for (const ItemSummary& item : report.items)
    items.push_back({{"name", item.name},
                     {"type", element_name(item.type)},
                     {"shape", item.shape},
                     {"bytes", item.bytes},
                     {"checksums", item.checksums}});
  const auto vector = [](const Vec3& v) { return ordered_json{v[0], v[1], v[2]}; };
  for (const CellSummary& c : report.cells)
    cells.push_back({{"vertices", c.vertices},
                     {"triangles", c.triangles},
                     {"centre", vector(c.centre)},
                     {"lower", vector(c.lower)},
                     {"upper", vector(c.upper)}});
  return {{"file", report.file.string()},
          {"bytes", report.bytes},
          {"lattice", report.lattice},
          {"metadata", ordered_json::parse(to_json(report.metadata))},
          {"items", items},
          {"cells", cells},
          {"digest", report.digest}};
}

std::string report_lines(const CheckpointReport& report) {
  const CheckpointMetadata& m = report.metadata;
  std::string text = fmt::format("{}: step {}, t = {:.9g} s, {} x {} x {} nodes of {:.6g} um, {:.1f} MB\n",
                                 report.file.string(), m.step, m.time_s, report.lattice[0], report.lattice[1],
                                 report.lattice[2], m.node_spacing_um, static_cast<double>(report.bytes) * 1e-6);
  text += fmt::format("written by attempt {} of rouleau-solver {} ({}), layout {}\n", m.attempt, m.version, m.git,
                      m.layout);
  text += fmt::format("identity {}, digest of the state {}\n", m.identity, report.digest);
  text += fmt::format("samples.csv: {} bytes counted\n\n", m.samples.bytes);
  for (const ItemSummary& item : report.items)
    text += fmt::format("  {:<32} {:<4} {:<24} {:>12} bytes\n", item.name, element_name(item.type),
                        fmt::format("{}", fmt::join(item.shape, " x ")), item.bytes);
  for (std::size_t c = 0; c < report.cells.size(); ++c) {
    const CellSummary& cell = report.cells[c];
    text += fmt::format("\ncell {}: {} vertices, {} triangles, centre ({:.4f}, {:.4f}, {:.4f}) lattice units\n", c,
                        cell.vertices, cell.triangles, cell.centre[0], cell.centre[1], cell.centre[2]);
  }
  text += "\nparameters that differ from their defaults:\n";
  for (const auto& [name, p] : m.parameters)
    if (p.value != p.default_value) text += fmt::format("  {} = {}\n", name, p.value);
  return text;
}

}  // namespace

std::string inspect_text(const std::filesystem::path& file, bool json, FileSystem& files) {
  const CheckpointReport report = inspect_checkpoint(files, file);
  return json ? report_json(report).dump(2) + "\n" : report_lines(report);
}

VerifyAnswer verify_text(const std::filesystem::path& file, FileSystem& files) {
  const Verification verification = verify_checkpoint(files, file);
  VerifyAnswer answer{verification.sound, ""};
  for (const VerificationLine& line : verification.lines)
    answer.text += fmt::format("  {:<32} {}{}{}\n", line.what, line.sound ? "sound" : "DAMAGED",
                               line.detail.empty() ? "" : ": ", line.detail);
  answer.text += fmt::format("{}: {}\n", file.string(), verification.sound ? "sound" : "DAMAGED");
  return answer;
}

}  // namespace rouleau
