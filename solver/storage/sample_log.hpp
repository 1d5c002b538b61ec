// SPDX-License-Identifier: BSD-3-Clause
// The append-only sample log of a run, samples.csv (share/contract.md section 4).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "storage/files.hpp"
#include "storage/metadata.hpp"

namespace rouleau {

using SampleValue = std::variant<std::int64_t, double>;
using SampleRow = std::vector<SampleValue>;

/// Length of the valid part of a log, and what ended it.
struct SampleScan {
  std::vector<std::string> columns;  ///< without "check"; empty if not even the header is valid
  std::uint64_t valid_bytes = 0;
  std::int64_t rows = 0;
  std::string why_ended;  ///< empty if the whole file is valid
};

/// Serial: rank 0 owns the log, inside Communicator::on_root.
class SampleLog {
 public:
  /// `columns` without "check"; the first is "step", one is "cell". `fence` throws Error(superseded) if there is an
  /// attempt newer than this one.
  SampleLog(FileSystem& files, std::filesystem::path file, std::vector<std::string> columns, int attempt,
            std::function<void()> fence);
  ~SampleLog();
  SampleLog(SampleLog&&) noexcept;
  SampleLog& operator=(SampleLog&&) noexcept;

  /// A log that holds only its header, replacing any that is there: the start of a run at step 0.
  void start();

  /// Whether the file holds more than its header.
  [[nodiscard]] bool has_samples() const;

  /// Why a run cannot go on from `position`: the file is missing, shorter, differs before it, or has columns that are
  /// not among ours. A checkpoint with an obstacle must be rejected for an older one: its samples could not be
  /// continued exactly.
  [[nodiscard]] std::optional<std::string> obstacle(const SampleLogPosition& position) const;

  /// Replaces the log by a copy of what the checkpoint had counted, and opens it there. A log that an older version
  /// began goes on with the columns it has. Throws Error(bad_input) if there is an obstacle.
  void cut_back(const SampleLogPosition& position);

  /// Adds rows in one write(), after the fence: a value for each of the columns given at construction. (step, cell)
  /// must increase. throws  Error(superseded) by the fence; Error(physics) for a value that is not finite; Error(io) if
  /// the file is not as long
  ///         as this log left it (another writer)
  void append(std::span<const SampleRow> rows);

  /// Brings all rows to the disk and returns the position for the checkpoint that counts them.
  SampleLogPosition sync();

 private:
  struct Counted;
  struct Open;
  /// Writes the log anew and opens it. `content` hands it on block by block.
  void replace(const std::function<void(const std::function<void(std::string_view)>&)>& content);
  FileSystem* files_;
  std::filesystem::path path_;
  std::vector<std::string> columns_;
  std::vector<std::size_t> written_;  ///< which of the columns the file has, in its order
  std::size_t cell_column_ = 0;       ///< among all columns
  int attempt_;
  std::function<void()> fence_;
  std::unique_ptr<Open> open_;
};

/// One line as it stands in the file, with its check and newline. Numbers in shortest round-trip form.
[[nodiscard]] std::string format_sample(const SampleRow& row);

/// Finds the valid part of a log: reads up to the first line without newline, with a wrong check or a wrong number of
/// fields.
[[nodiscard]] SampleScan scan_samples(FileSystem& files, const std::filesystem::path& file);

}  // namespace rouleau
