// SPDX-License-Identifier: BSD-3-Clause
// Sections off, units split from names.
#include "report/parameter_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rouleau::campaign {
namespace {

/// The endings by which the run file's names carry their units; longer ones first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> units = {{{"_mm_per_s", "mm/s"},
                                                                                 {"_uN_per_m", "µN/m"},
                                                                                 {"_Pa_per_m", "Pa/m"},
                                                                                 {"_mPa_s", "mPa s"},
                                                                                 {"_deg", "°"},
                                                                                 {"_um", "µm"},
                                                                                 {"_us", "µs"},
                                                                                 {"_J", "J"},
                                                                                 {"_s", "s"}}};

struct Words {
  std::string name;
  std::string_view unit;
};

Words words_of(std::string_view full) {
  if (full == "fluid.lambda") return {"λ", ""};
  Words words{std::string(full.substr(full.rfind('.') + 1)), ""};
  for (const auto& [ending, unit] : units) {
    if (!words.name.ends_with(ending) || words.name.size() == ending.size()) continue;
    words.name.resize(words.name.size() - ending.size());
    words.unit = unit;
    break;
  }
  std::replace(words.name.begin(), words.name.end(), '_', ' ');
  return words;
}

}  // namespace

std::string axis_title(std::string_view name) {
  const Words words = words_of(name);
  return words.unit.empty() ? words.name : fmt::format("{}, {}", words.name, words.unit);
}

std::string parameter_words(std::string_view name, std::string_view value) {
  const Words words = words_of(name);
  return fmt::format("{} = {}{}{}", words.name, value, words.unit.empty() ? "" : " ", words.unit);
}

}  // namespace rouleau::campaign
