// SPDX-License-Identifier: BSD-3-Clause
// The files of a run directory as the fake solver writes them: attempts, checkpoints, samples, records.
#pragma once

#include <filesystem>
#include <string>

#include "run_file.hpp"

namespace fake {

/// Writes aside, syncs, renames.
void write_whole(const std::filesystem::path& file, const std::string& text);
std::string read_whole(const std::filesystem::path& file);  ///< "" if there is none
double unix_s();

/// Which attempt this process is, and whether it still may write.
class Attempt {
 public:
  /// Takes the given attempt, or claims the next one if `number` is 0.
  Attempt(int number, std::string token);
  /// throws Failure 76 if a newer attempt exists or the owner changed (contract section 8)
  void check_fence() const;
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] const std::string& token() const { return token_; }
  [[nodiscard]] std::filesystem::path directory() const;

 private:
  int number_;
  std::string token_;
};

/// Where a run stands between two steps: step and length of the sample log. All that a checkpoint holds.
struct Position {
  long long step = 0;
  long long log_bytes = 0;
};

/// The newest whole checkpoint, or step -1.
Position newest_checkpoint();
void write_checkpoint(const Attempt& attempt, const Position& position, int kept);

/// Cuts samples.csv back to the position and makes its header if there is none.
void cut_samples(Position& position);
/// One line for this step, with its check.
std::string sample_line(const RunFile& run, long long step);

}  // namespace fake
