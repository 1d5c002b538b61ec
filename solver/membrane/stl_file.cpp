// SPDX-License-Identifier: BSD-3-Clause
// The STL format, ASCII and binary: triangles by their corners' coordinates, which are merged into vertices.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "membrane/surface_file.hpp"
#include "membrane/text_lines.hpp"

namespace rouleau {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian and is copied as it stands");

constexpr std::size_t header_bytes = 80, count_bytes = 4, facet_bytes = 50, vertex_bytes = 12;

/// Collects triangles; corners with equal coordinates are one vertex.
class CornerMerger {
 public:
  std::int32_t vertex(const Vec3& point) {
    // Adding 0 makes -0 and 0 one number.
    const std::array<double, 3> key{point[0] + 0.0, point[1] + 0.0, point[2] + 0.0};
    const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::int32_t>(numbers_.size()));
    if (is_new) {
      surface_.X.x.push_back(key[0]);
      surface_.X.y.push_back(key[1]);
      surface_.X.z.push_back(key[2]);
    }
    return found->second;
  }
  void add(const std::array<Vec3, 3>& corners) {
    surface_.triangles.a.push_back(vertex(corners[0]));
    surface_.triangles.b.push_back(vertex(corners[1]));
    surface_.triangles.c.push_back(vertex(corners[2]));
  }
  Surface take() { return std::move(surface_); }

 private:
  std::map<std::array<double, 3>, std::int32_t> numbers_;
  Surface surface_;
};

std::uint32_t facet_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes, count_bytes);
  return count;
}

/// By size, because some binary files begin with the word "solid".
bool is_binary(std::string_view bytes) {
  return bytes.size() >= header_bytes + count_bytes &&
         bytes.size() == header_bytes + count_bytes + facet_bytes * std::size_t{facet_count(bytes)};
}

Surface parse_binary(std::string_view bytes, std::string_view name) {
  CornerMerger merger;
  const std::uint32_t facets = facet_count(bytes);
  for (std::size_t f = 0; f < facets; ++f) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t offset = header_bytes + count_bytes + f * facet_bytes + (k + 1) * vertex_bytes;
      std::array<float, 3> point{};
      std::memcpy(point.data(), bytes.data() + offset, vertex_bytes);
      corners[k] = {point[0], point[1], point[2]};
      if (!corners[k].allFinite()) {
        fail(Exit::bad_input, "{}: byte {}: corner {} of facet {} is not finite.", name, offset, k, f);
      }
    }
    merger.add(corners);
  }
  return merger.take();
}

void expect_words(TextLines& lines, std::string_view first, std::string_view second) {
  const auto& words = lines.words();
  if (words[0] != first || (!second.empty() && (words.size() < 2 || words[1] != second))) {
    lines.refuse(fmt::format("expected '{}{}{}'", first, second.empty() ? "" : " ", second));
  }
}

Surface parse_ascii(std::string_view bytes, std::string_view name) {
  CornerMerger merger;
  TextLines lines(bytes, name);
  lines.expect("'solid'");
  expect_words(lines, "solid", "");
  for (;;) {
    lines.expect("'facet' or 'endsolid'");
    if (lines.words()[0] == "endsolid") break;
    expect_words(lines, "facet", "normal");
    lines.expect("'outer loop'");
    expect_words(lines, "outer", "loop");
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      lines.expect("'vertex x y z'");
      expect_words(lines, "vertex", "");
      if (lines.words().size() != 4) lines.refuse("a vertex has three coordinates");
      corner = {lines.number(1), lines.number(2), lines.number(3)};
    }
    lines.expect("'endloop'");
    expect_words(lines, "endloop", "");
    lines.expect("'endfacet'");
    expect_words(lines, "endfacet", "");
    merger.add(corners);
  }
  if (lines.next()) lines.refuse("text after 'endsolid'; a file with one solid is read");
  return merger.take();
}

}  // namespace

Surface parse_stl(std::string_view bytes, std::string_view name) {
  if (is_binary(bytes)) return parse_binary(bytes, name);
  if (bytes.starts_with("solid")) return parse_ascii(bytes, name);
  if (bytes.size() < header_bytes + count_bytes) {
    fail(Exit::bad_input, "{}: {} bytes are too few for an STL file.", name, bytes.size());
  }
  fail(Exit::bad_input, "{}: byte {}: the count of {} facets asks for {} bytes, the file has {}. Is it complete?", name,
       header_bytes, facet_count(bytes), header_bytes + count_bytes + facet_bytes * std::size_t{facet_count(bytes)},
       bytes.size());
}

}  // namespace rouleau
