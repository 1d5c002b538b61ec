// SPDX-License-Identifier: BSD-3-Clause
// From axes to combinations: lists, ranges, product, zip, replicas.
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace rouleau::campaign {

inline constexpr int most_points = 100000;

/// The run parameters of one candidate point: fixed ones first, then one value of each axis, then cell.replica.
struct Combination {
  std::vector<Entry> entries;
};

/// The values of "1, 2, 4:5:0.25, 2-point": commas separate, from:to:step expands.
/// throws Error (usage) "file:line: ..."
[[nodiscard]] std::vector<std::string> expand_values(const std::string& text, const std::string& file, int line);

/// How many combinations there are, without making them.
[[nodiscard]] double count_of(const Study& study);

/// One of them, 0 ... count_of - 1: the product (last axis fastest) or the zip of the axes, each with every replica.
[[nodiscard]] Combination combination_of(const Study& study, std::size_t index);

}  // namespace rouleau::campaign
