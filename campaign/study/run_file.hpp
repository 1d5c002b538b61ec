// SPDX-License-Identifier: BSD-3-Clause
// The solver's run file of one combination, and the way back from its lines to the study file's.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/sweep.hpp"

namespace rouleau::campaign {

/// A file that the study names (mesh, reference shape, checkpoint): the campaign keeps its own copy.
struct NamedFile {
  std::filesystem::path source;  ///< absolute
  std::string stored;            ///< "files/<stem>-<digest><extension>", relative to the campaign
};

/// How many digits of a named file's digest its stored name ends in.
inline constexpr std::size_t digits_in_name = 8;

/// The named files of a study by the text that the study file has for them.
using NamedFiles = std::map<std::string, NamedFile>;

/// Whether a run parameter names a file ("cell.mesh_file", "cell.2.reference_file").
[[nodiscard]] bool names_a_file(const std::string& parameter);

/// Finds every file that the study names, beside the study file.   throws Error (usage) with the line if one is missing
[[nodiscard]] NamedFiles find_named_files(const Study& study);

/// How a named file is written into a run file.
enum class FileNames {
  source,  ///< by its absolute path, for a check anywhere
  stored,  ///< "../../files/...": as seen from points/<key>/, so that the campaign can be moved
};

struct RunFile {
  std::string text;
  std::vector<int> study_lines;  ///< [line - 1] -> line of the study file; 0 = none
};

/// Writes the entries by section, in the order in which sections first appear. `title` becomes the first comment.
[[nodiscard]] RunFile run_file_of(const Combination& combination, const NamedFiles& files, FileNames names,
                                  const std::string& title);

/// Turns the "run.ini:12: ..." of a solver's message into "study.ini:7: ..."; what has no line keeps none.
[[nodiscard]] std::string to_study_lines(const std::string& message, const RunFile& run_file,
                                         const std::string& study_name);

/// The study's text with every named file's value replaced by its stored name: the copy that the campaign keeps.
[[nodiscard]] std::string with_stored_files(const Study& study, const NamedFiles& files);

}  // namespace rouleau::campaign
