// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing triangle surfaces: OFF and STL files. Coordinates are in the file's unit.
#pragma once

#include <filesystem>
#include <string_view>

#include "membrane/cells.hpp"

namespace rouleau {

/// Reads an OFF or STL (ASCII or binary) file, by its extension. The surface is not checked: see check_surface.
/// throws  Error (bad_input) with file and line, or byte offset in a binary file; (io) if reading fails
Surface read_surface(const std::filesystem::path& path);

/// Parses the bytes of an OFF file: "OFF", counts, one vertex a line, one triangle a line ("3 a b c", colours after the
/// indices are not used). `name` stands in messages.
/// throws  Error (bad_input) with name and line
Surface parse_off(std::string_view bytes, std::string_view name);

/// Parses the bytes of an STL file, ASCII or binary. Corners with equal coordinates become one vertex; the file's facet
/// normals are not used: a triangle's side follows from the order of its corners.
/// throws  Error (bad_input) with name and line, or byte offset
Surface parse_stl(std::string_view bytes, std::string_view name);

/// Writes an OFF file with as many digits as read back to the same doubles.
/// throws  Error (io)
void write_off(const Surface& surface, const std::filesystem::path& path);

}  // namespace rouleau
