// SPDX-License-Identifier: BSD-3-Clause
// The result for a reader.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "result.hpp"

namespace rouleau::speed {

/// `json`: the whole result file.
std::string result_table(const Series& series, const PointFacts& point, const nlohmann::ordered_json& json);

}  // namespace rouleau::speed
