// SPDX-License-Identifier: BSD-3-Clause
// The cases of a validation run and what they found.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expected.hpp"

namespace rouleau::validation {

/// Where a run finds what it needs and leaves what it made.
struct Places {
  std::filesystem::path studies;   ///< the cases' input files: <case>.ini
  std::filesystem::path scratch;   ///< campaigns are made below it and kept for the next call
  std::filesystem::path programs;  ///< holds `rouleau` and `rouleau-solver`
};

/// One line of the result.
struct Finding {
  std::string case_name, quantity;
  double ours = 0;
  std::optional<Expected> expected;  ///< none: a figure that is told, not judged
  std::string source;                ///< of the reference
  std::string note;
  double time_s = 0;  ///< since the finding before it

  [[nodiscard]] bool has_passed() const { return !expected || expected->holds(ours); }
};

/// What a case gets to work with.
class Suite {
 public:
  explicit Suite(Places places) : places_(std::move(places)) {}

  [[nodiscard]] const Places& places() const { return places_; }

  /// Holds a value against its reference.
  void check(const std::string& quantity, double ours, const Expected& expected, const std::string& source,
             const std::string& note = "");
  /// Tells a value that has no reference, or one that is known from memory only.
  void figure(const std::string& quantity, double value, const std::string& note = "");

  /// Runs one case. One that throws or checks nothing has failed; its findings up to there stay.
  void run(const std::string& case_name, const std::function<void(Suite&)>& work);

  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  [[nodiscard]] bool has_passed() const;

 private:
  void add(Finding finding);

  Places places_;
  std::vector<Finding> findings_;
  std::string case_name_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A case: its name, which is also that of its input file, what it shows, and the work.
struct Case {
  const char* name;
  const char* title;
  void (*work)(Suite&);
};

/// Runs the cases in order and writes the table to `out` and to `<results>.txt`, the checks to `<results>.json`.
/// returns 0 if all checks hold, else 1
int run_cases(std::span<const Case> cases, const Places& places, const std::filesystem::path& results,
              std::ostream& out);

}  // namespace rouleau::validation
