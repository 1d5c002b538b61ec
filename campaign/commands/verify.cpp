// SPDX-License-Identifier: BSD-3-Clause
// `rouleau verify`: everything that is stored is read and computed again, and compared.
#include "ingest/verify.hpp"

#include <algorithm>
#include <ostream>

#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "executor/solver.hpp"
#include "ingest/run_files.hpp"
#include "study/point.hpp"

namespace rouleau::campaign {

namespace {

namespace po = boost::program_options;

void describe(po::options_description& options) {
  options.add_options()("checkpoints", po::bool_switch(),
                        "also let `rouleau-solver verify` read every checkpoint (as slow as the disk)");
}

/// What the solver's verify says of the first damaged part, or, if it could not look, why.
std::string problem_in(const Capture& capture) {
  constexpr std::string_view mark = "DAMAGED: ";
  const std::size_t at = capture.out.find(mark);
  const std::string text = at == std::string::npos ? capture.err : capture.out.substr(at + mark.size());
  const std::string words = text.substr(0, text.find('\n'));
  return words.empty() ? fmt::format("the solver's verify ended with {}", capture.status) : words;
}

/// Asks the solver, the only one who knows the format, about each checkpoint of a point.
std::vector<Finding> verify_checkpoints(const std::filesystem::path& solver, const std::filesystem::path& campaign,
                                        const std::string& key) {
  std::vector<Finding> findings;
  const std::filesystem::path run = point_directory(campaign, key);
  for (const std::int64_t step : checkpoint_steps(run)) {
    const std::filesystem::path file = run / "checkpoints" / fmt::format("{:012}.h5", step);
    const Capture capture = run_and_capture({solver.string(), "verify", file.string()});
    std::error_code unseen;
    if (capture.status == 0 || !std::filesystem::exists(file, unseen)) continue;  // a running job removes old ones
    findings.push_back({key, file.lexically_relative(campaign).string(), true,
                        problem_in(capture) + "; a continuation passes it over for the one before"});
  }
  return findings;
}

int verify(const CommandLine& line) {
  const Store store = Store::open_reader(line.directory / "campaign.db");
  std::vector<Finding> all = verify_database(store, line.directory);
  const auto add = [&](std::vector<Finding> findings) {
    all.insert(all.end(), std::make_move_iterator(findings.begin()), std::make_move_iterator(findings.end()));
  };
  const std::filesystem::path solver = line.is_set("checkpoints") ? find_solver() : "";
  const std::vector<PointRow> points = store.points();
  for (const PointRow& point : points) {
    add(verify_point(store, line.directory, point.key));
    if (!solver.empty()) add(verify_checkpoints(solver, line.directory, point.key));
  }

  Table table{"findings", {"severity", "point", "file", "problem"}, {}};
  for (const Finding& finding : all)
    table.rows.push_back({std::string(finding.damage ? "damage" : "remark"),
                          finding.key.empty() ? Value() : Value(finding.key), finding.file, finding.problem});
  if (!all.empty() || line.format != Format::table) print(line, table);
  const auto damages = std::count_if(all.begin(), all.end(), [](const Finding& finding) { return finding.damage; });
  if (!line.quiet)
    line.io.err << fmt::format("{} points verified{}: {} damaged, {} remarks\n", points.size(),
                               solver.empty() ? "" : " with their checkpoints", damages,
                               static_cast<std::ptrdiff_t>(all.size()) - damages);
  return static_cast<int>(damages == 0 ? Exit::ok : Exit::damaged);
}

}  // namespace

const Verb verify_verb = {
    "verify",
    "read and compute everything again, and compare",
    "[DIR] [--checkpoints] [--format csv|json]",
    "  rouleau verify my-campaign                 samples, results, records against the run directories\n"
    "  rouleau verify my-campaign --checkpoints   and all checkpoints by the solver's own verify\n",
    "Ends with 0 when nothing is damaged (remarks are only news that `rouleau sync` will take note of), with 7 when\n"
    "something is; every line names the remedy.\n",
    Words::campaign,
    true,
    describe,
    verify,
};

}  // namespace rouleau::campaign
