// SPDX-License-Identifier: BSD-3-Clause
// A study file: fixed run parameters, sweep axes, and how to run and judge the points.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/settings.hpp"

namespace rouleau::campaign {

/// `name = value` of a run parameter, with the line it came from.
struct Entry {
  std::string name;  ///< "fluid.lambda"
  std::string value;
  int line = 0;
};

/// One axis of the sweep: the values as written (ranges expanded), still unchecked.
struct Axis {
  std::string name;
  std::vector<std::string> values;
  int line = 0;
};

enum class SweepMode { product, zip };

struct Study {
  std::string name;
  std::vector<Entry> fixed;  ///< in the file's order
  std::vector<Axis> axes;    ///< in the file's order
  SweepMode mode = SweepMode::product;
  int replicas = 0;  ///< 0: none asked for
  Execution execution;
  Analysis analysis;
  std::string text;              ///< the file as read
  std::filesystem::path source;  ///< where it was read from; relative mesh files are sought beside it

  /// The name that leads every error.
  [[nodiscard]] std::string file_name() const { return source.filename().string(); }
};

/// Reads a study from its text. Errors begin "study.ini:LINE:", with the name of `source`.
/// throws Error (usage) at the first thing that is wrong
[[nodiscard]] Study parse_study(const std::string& text, const std::filesystem::path& source);

/// The same from a file.   throws Error (not_found) if there is none
[[nodiscard]] Study read_study(const std::filesystem::path& file);

}  // namespace rouleau::campaign
