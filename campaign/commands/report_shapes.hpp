// SPDX-License-Identifier: BSD-3-Clause
// The cells that a run directory holds pictures of, read by way of `rouleau-solver shape`.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/cell_shape.hpp"

namespace rouleau::campaign {

/// A checkpoint, or a snapshot of cells.
struct ShapeFile {
  std::filesystem::path path;
  std::int64_t step = 0;
  bool has_flags = false;  ///< a checkpoint
};

/// All of a run directory, by step; of a step that has both, the snapshot.
[[nodiscard]] std::vector<ShapeFile> shape_files(const std::filesystem::path& run_directory);

/// Asks the solver, and remembers what a file held as long as it has not changed.
class ShapeReader {
 public:
  /// Without a solver every read() returns nothing, and problem() says why.
  ShapeReader();

  /// Nothing if the file has gone meanwhile (checkpoints are replaced) or cannot be read. `with_slice` asks for the
  /// flags in the plane across y.
  [[nodiscard]] std::optional<Shape> read(const ShapeFile& file, bool with_slice);

  /// Why pictures are missing, with the next step; empty if none are. Begins anew with each call.
  [[nodiscard]] std::string take_problem();

  /// Forgets what was not read since the last call: checkpoints come and go for days.
  void forget_unread();

 private:
  struct Remembered {
    std::filesystem::file_time_type written;
    Shape shape;
    bool is_read = true;  ///< since the last forget_unread()
  };

  std::string solver_, no_solver_, problem_;
  int failures_ = 0;
  std::map<std::pair<std::filesystem::path, bool>, Remembered> remembered_;
};

}  // namespace rouleau::campaign
