// SPDX-License-Identifier: BSD-3-Clause
// Reading samples.csv (share/contract.md section 4): only lines whose check is right, from where the last reading
// ended.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "store/rows.hpp"

namespace rouleau::campaign {

/// What was read of a log.
struct LogPart {
  bool from_start = false;  ///< the rows replace all earlier ones: first reading, or the log was cut back or changed
  std::vector<SampleRow> rows;  ///< new, or all of them if from_start
  SampleMark mark;              ///< where the next reading goes on
  std::int64_t unfinished_bytes =
      0;  ///< behind the last newline: a line that is being written, or was when all stopped
  std::vector<std::string> warnings;  ///< damage: what is behind it is left aside
};

/// Reads what is valid behind `mark`. A log that is shorter than the mark, or whose last bytes before it differ, was
/// cut back by a resumed run: it is read anew. The first damaged line (check, number of fields, a number that is none,
/// step and cell not increasing, a line longer than 64 KiB) ends the valid part and is named with its line and byte in
/// a warning. A missing file is an empty one; a missing one, or one without a header, that was read before is a
/// warning. No more than a block of the file is in memory, besides the rows.
LogPart read_sample_log(const std::filesystem::path& file, const SampleMark& mark);

/// Whether a log that was read from its start may take the place of `stored` rows read before: it is sound and, of a
/// run that is done and will write no more, no shorter. Of any other run a shorter one is what a resume has left of it.
[[nodiscard]] bool may_replace(const LogPart& log, std::size_t stored, bool is_done);

}  // namespace rouleau::campaign
