// SPDX-License-Identifier: BSD-3-Clause
// Expanding the sweep.
#include "study/sweep.hpp"

#include <algorithm>
#include <stdexcept>

#include "study/error.hpp"
#include "study/ini.hpp"
#include "study/numbers.hpp"

namespace rouleau::campaign {

namespace {

/// Whether a colon makes the item a range: a file name may hold one too, but none of its parts is a number.
bool is_range(const std::vector<std::string>& parts) {
  return parts.size() > 1 && std::any_of(parts.begin(), parts.end(),
                                         [](const std::string& part) { return parse_number(part).has_value(); });
}

/// The value of each axis in the given row.
std::vector<Entry> row_of(const Study& study, std::size_t row) {
  std::vector<Entry> entries(study.axes.size());
  std::size_t rest = row;
  for (std::size_t i = study.axes.size(); i-- > 0;) {
    const Axis& axis = study.axes[i];
    const std::size_t index = study.mode == SweepMode::zip ? row : rest % axis.values.size();
    rest /= axis.values.size();
    entries[i] = {axis.name, axis.values[index], axis.line};
  }
  return entries;
}

}  // namespace

std::vector<std::string> expand_values(const std::string& text, const std::string& file, int line) {
  std::vector<std::string> values;
  for (const std::string& item : split(text, ',')) {
    if (values.size() > most_points)
      fail(Exit::usage, "{}:{}: the axis has more than {} values. Shorten it.", file, line, most_points);
    if (item.empty())
      fail(Exit::usage, "{}:{}: `{}` has an empty place between commas. Remove a comma.", file, line, text);
    const std::vector<std::string> parts = split(item, ':');
    if (!is_range(parts)) {
      values.push_back(item);
      continue;
    }
    if (parts.size() != 3) {
      fail(Exit::usage, "{}:{}: `{}` is not a range. Write from:to:step, such as 4:5:0.25.", file, line, item);
    }
    try {
      for (std::string& value : expand_range(parts[0], parts[1], parts[2])) values.push_back(std::move(value));
    } catch (const std::invalid_argument& error) {
      fail(Exit::usage, "{}:{}: the range `{}` cannot be: {}. Write from:to:step, such as 4:5:0.25.", file, line, item,
           error.what());
    }
  }
  return values;
}

double count_of(const Study& study) {
  double count = study.replicas > 0 ? study.replicas : 1;
  if (study.mode == SweepMode::zip)
    return study.axes.empty() ? count : count * static_cast<double>(study.axes[0].values.size());
  for (const Axis& axis : study.axes) count *= static_cast<double>(axis.values.size());
  return count;
}

Combination combination_of(const Study& study, std::size_t index) {
  Combination combination{study.fixed};
  const auto replicas = static_cast<std::size_t>(std::max(1, study.replicas));
  for (Entry& entry : row_of(study, index / replicas)) combination.entries.push_back(std::move(entry));
  if (study.replicas > 0) combination.entries.push_back({"cell.replica", std::to_string(index % replicas + 1), 0});
  return combination;
}

}  // namespace rouleau::campaign
