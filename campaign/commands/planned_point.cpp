// SPDX-License-Identifier: BSD-3-Clause
#include "commands/planned_point.hpp"

#include <algorithm>

#include "study/numbers.hpp"

namespace rouleau::campaign {

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
  return planned;
}

}  // namespace rouleau::campaign
