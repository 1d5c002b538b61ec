// SPDX-License-Identifier: BSD-3-Clause
// Names of run parameters as people write them under an axis.
#pragma once

#include <string>
#include <string_view>

namespace rouleau::campaign {

/// "fluid.lambda" -> "λ"; "flow.mean_velocity_mm_per_s" -> "mean velocity, mm/s".
[[nodiscard]] std::string axis_title(std::string_view name);

/// "λ = 5", "mean velocity = 1.5 mm/s": what a parameter of that name is, `value` as written.
[[nodiscard]] std::string parameter_words(std::string_view name, std::string_view value);

}  // namespace rouleau::campaign
