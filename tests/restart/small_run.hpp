// SPDX-License-Identifier: BSD-3-Clause
// A small coupled run in a directory of its own, driven as a user would: by its run file and the solver's command line.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "support/process.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {

/// Values that differ from those of the small run, by "section.name"; an empty one is left out of the run file.
using Changes = std::map<std::string, std::string>;

class SmallRun {
 public:
  /// A red blood cell of 1280 triangles that straddles the periodic seam of a 24 x 18 x 15 channel.
  explicit SmallRun(Changes changes = {});

  /// Sets one value of the run file.
  void set(const std::string& name, const std::string& value);
  /// Sets the end time so that the run ends after this many steps.
  void set_steps(int steps);

  /// Runs the solver on so many ranks.
  Finished run(int ranks = 1, const std::vector<std::string>& options = {},
               std::optional<Interruption> interruption = {}) const;
  /// Runs it and expects exit code 0.
  void finish(int ranks = 1) const;

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return directory_.path() / name; }
  [[nodiscard]] std::string samples() const { return content_of(path("samples.csv")); }
  /// `rouleau-solver inspect --format json` of the newest checkpoint.
  [[nodiscard]] nlohmann::json newest_checkpoint() const;
  /// All that must not depend on how often a run was stopped: digest of the last state, and the sample log.
  [[nodiscard]] std::string fingerprint() const;
  /// exit.json of the newest attempt.
  [[nodiscard]] nlohmann::json exit_record() const;

 private:
  void write_run_file() const;

  TemporaryDirectory directory_;
  Changes values_;
};

}  // namespace rouleau::testing
