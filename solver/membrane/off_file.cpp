// SPDX-License-Identifier: BSD-3-Clause
// The OFF format: text, a list of vertices and a list of faces by vertex index.
#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <limits>

#include "base/error.hpp"
#include "membrane/surface_file.hpp"
#include "membrane/text_lines.hpp"

namespace rouleau {

Surface parse_off(std::string_view bytes, std::string_view name) {
  TextLines lines(bytes, name);
  lines.expect("the word OFF");
  if (lines.words()[0] != "OFF") {
    lines.refuse("an OFF file starts with the word OFF (variants such as COFF, NOFF and binary OFF are not read)");
  }
  std::size_t first = 1;  // the counts may stand behind the word OFF
  if (lines.words().size() == 1) {
    lines.expect("the counts of vertices, faces and edges");
    first = 0;
  }
  if (lines.words().size() != first + 3) lines.refuse("expected the three counts of vertices, faces and edges");
  // The shortest lines are "0 0 0\n" and "3 0 1 2\n"; the last may lack its end.
  constexpr std::int64_t shortest_vertex = 6, shortest_face = 8;
  constexpr std::int64_t no_limit = std::numeric_limits<std::int32_t>::max();
  const std::int64_t vertices = lines.index(first, no_limit), faces = lines.index(first + 1, no_limit);
  if (vertices * shortest_vertex + faces * shortest_face > static_cast<std::int64_t>(bytes.size()) + 1) {
    lines.refuse(fmt::format("{} vertices and {} faces do not fit into the file's {} bytes. Is it complete?", vertices,
                             faces, bytes.size()));
  }

  Surface surface;
  surface.X.resize(static_cast<std::size_t>(vertices));
  for (std::int64_t v = 0; v < vertices; ++v) {
    lines.expect(fmt::format("vertex {} of {}", v, vertices));
    if (lines.words().size() != 3) {
      lines.refuse(fmt::format("vertex {} has {} numbers instead of 3", v, lines.words().size()));
    }
    set(surface.X, static_cast<std::size_t>(v), {lines.number(0), lines.number(1), lines.number(2)});
  }
  for (std::int64_t f = 0; f < faces; ++f) {
    lines.expect(fmt::format("face {} of {}", f, faces));
    if (lines.words()[0] != "3") {
      lines.refuse(
          fmt::format("face {} has {} corners; only triangles are read. Triangulate the mesh", f, lines.words()[0]));
    }
    if (lines.words().size() < 4) lines.refuse(fmt::format("face {} names fewer than 3 vertices", f));
    surface.triangles.a.push_back(lines.index(1, vertices));
    surface.triangles.b.push_back(lines.index(2, vertices));
    surface.triangles.c.push_back(lines.index(3, vertices));
  }
  if (lines.next()) lines.refuse(fmt::format("text after the last of {} faces", faces));
  return surface;
}

void write_off(const Surface& surface, const std::filesystem::path& path) {
  std::string text = fmt::format("OFF\n{} {} 0\n", surface.X.size(), surface.triangles.size());
  for (std::size_t v = 0; v < surface.X.size(); ++v) {
    text += fmt::format("{} {} {}\n", surface.X.x[v], surface.X.y[v], surface.X.z[v]);
  }
  const Triangles& triangles = surface.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    text += fmt::format("3 {} {} {}\n", triangles.a[t], triangles.b[t], triangles.c[t]);
  }
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) fail(Exit::io, "{}: the mesh could not be written. Check the folder and the free space.", path.string());
}

}  // namespace rouleau
