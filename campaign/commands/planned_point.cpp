// SPDX-License-Identifier: BSD-3-Clause
#include "commands/planned_point.hpp"

#include <algorithm>

#include "study/numbers.hpp"

namespace rouleau::campaign {

namespace {

double MiB_in(const std::filesystem::path& directory) {
  double bytes = 0;
  std::error_code unseen;
  for (std::filesystem::recursive_directory_iterator it(directory, unseen), end; !unseen && it != end;
       it.increment(unseen)) {
    std::error_code vanished;  // a living job replaces files meanwhile
    const std::uintmax_t size = it->is_regular_file(vanished) ? it->file_size(vanished) : 0;
    if (!vanished) bytes += static_cast<double>(size);
  }
  return bytes / (1 << 20);
}

}  // namespace

PlannedPoint planned_point(const Point& point, State state, std::int64_t steps_done) {
  PlannedPoint planned;
  planned.steps_left = is_final(state) ? 0 : std::max<std::int64_t>(0, point.facts.steps - steps_done);
  planned.relative_cost_per_step = point.facts.relative_cost_per_step;
  planned.checkpoint_bytes = point.facts.checkpoint_bytes;
  if (const std::string* kept = point.find("output.checkpoints_kept")) {
    planned.checkpoints_kept = static_cast<int>(parse_number(*kept).value_or(planned.checkpoints_kept));
  }
  planned.snapshot_bytes = point.facts.snapshot_bytes;
  planned.samples = point.facts.samples;
  for (const Parameter& parameter : point.parameters) {
    if (parameter.name.starts_with("cell.") && parameter.name.ends_with(".shape") && parameter.name != "cell.shape") {
      ++planned.cells;
    }
  }
  if (const std::string* interval = point.find("output.progress_interval_s")) {
    planned.progress_interval_s = parse_number(*interval).value_or(planned.progress_interval_s);
  }
  return planned;
}

double missing_MiB(const PlannedPoint& point, State state, const std::filesystem::path& run_directory) {
  return is_final(state) ? 0 : std::max(0.0, disk_MiB(point) - MiB_in(run_directory));
}

}  // namespace rouleau::campaign
