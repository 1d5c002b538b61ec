// SPDX-License-Identifier: BSD-3-Clause
// Wrong run files, each with the line and the words that the refusal must contain: one table for library and program.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace rouleau::test {

struct Edit {
  int line;          // of the good file, 1, 2, ...
  std::string text;  // put in its place; may be several lines
};

struct BadRunFile {
  std::string name;  // for the test's name
  std::vector<Edit> edits;
  int line;  // that the message names
  std::vector<std::string> parts;
  bool needs_mesh = false;  // found only once the mesh is made
};

inline void PrintTo(const BadRunFile& bad, std::ostream* out) { *out << bad.name; }

/// A run file that works, and stays short enough to count its lines.
std::vector<std::string> good_run_file();

/// The good file with the edits made.
std::string text_of(const BadRunFile& bad);

std::vector<BadRunFile> bad_run_files();

}  // namespace rouleau::test
