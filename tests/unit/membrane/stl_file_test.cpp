// SPDX-License-Identifier: BSD-3-Clause
// STL files, ASCII and binary: merged corners, and errors that name the line or the byte.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "base/error.hpp"
#include "membrane/check_surface.hpp"
#include "membrane/shapes.hpp"
#include "membrane/surface_file.hpp"
#include "membrane/volume.hpp"

namespace rouleau {
namespace {

using testing::HasSubstr;

std::string ascii(const Surface& s) {
  std::string text = "solid cell\n";
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::int32_t v : {s.triangles.a[t], s.triangles.b[t], s.triangles.c[t]}) {
      text += fmt::format("      vertex {} {} {}\n", s.X.x[v], s.X.y[v], s.X.z[v]);
    }
    text += "    endloop\n  endfacet\n";
  }
  text += "endsolid cell\n";
  return text;
}

std::string binary(const Surface& s, const char* header = "solid but binary") {
  std::string bytes(80, ' ');
  std::memcpy(bytes.data(), header, std::strlen(header));
  const auto put = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  put(static_cast<std::uint32_t>(s.triangles.size()));
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) put(0.0F);
    for (const std::int32_t v : {s.triangles.a[t], s.triangles.b[t], s.triangles.c[t]}) {
      for (const double x : {s.X.x[v], s.X.y[v], s.X.z[v]}) put(static_cast<float>(x));
    }
    put(std::uint16_t{0});
  }
  return bytes;
}

std::string error_of(const std::string& bytes) {
  try {
    parse_stl(bytes, "cell.stl");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::bad_input);
    return error.what();
  }
  return "no error";
}

TEST(MembraneStl, AsciiCornersMergeIntoTheClosedSurface) {
  const Surface s = red_blood_cell(3, 4);
  const Surface back = parse_stl(ascii(s), "cell.stl");
  EXPECT_EQ(back.X.size(), s.X.size());
  EXPECT_NO_THROW(check_surface(back, "cell.stl"));
  EXPECT_NEAR(volume(back), volume(s), 1e-12 * volume(s));  // another order of summation
}

TEST(MembraneStl, BinaryIsRecognisedBySizeEvenBehindTheWordSolid) {
  const Surface s = red_blood_cell(3, 4);
  const Surface back = parse_stl(binary(s), "cell.stl");
  EXPECT_EQ(back.X.size(), s.X.size());
  EXPECT_NO_THROW(check_surface(back, "cell.stl"));
  EXPECT_NEAR(volume(back) / volume(s), 1, 1e-6);  // single precision
}

TEST(MembraneStl, ZeroAndMinusZeroAreOneCoordinate) {
  std::string text = ascii(unit_sphere(0));
  const std::size_t zero = text.find(" 0\n      vertex");
  ASSERT_NE(zero, std::string::npos);
  text.insert(zero + 1, 1, '-');
  EXPECT_EQ(parse_stl(text, "cell.stl").X.size(), 12u);
}

TEST(MembraneStl, BadFilesAreRefusedWithTheirPlace) {
  const Surface s = unit_sphere(0);
  const std::string good_text = ascii(s), good_bytes = binary(s, "header");
  EXPECT_THAT(error_of(""), HasSubstr("0 bytes are too few"));
  EXPECT_THAT(error_of("solid\nfacet\n"), HasSubstr("cell.stl:2: expected 'facet normal'"));
  EXPECT_THAT(error_of("solid\nfacet normal 0 0 1\nvertex\n"), HasSubstr("cell.stl:3: expected 'outer loop'"));
  EXPECT_THAT(error_of("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2\n"),
              HasSubstr("cell.stl:4: a vertex has three"));
  EXPECT_THAT(error_of("solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2 inf\n"), HasSubstr("cell.stl:4: 'inf'"));
  EXPECT_THAT(error_of(good_text + "solid second\n"), HasSubstr("text after 'endsolid'"));
  EXPECT_THAT(error_of(good_text.substr(0, good_text.size() / 2)), HasSubstr("cell.stl:"));
  EXPECT_THAT(error_of(good_bytes.substr(0, good_bytes.size() - 1)),
              HasSubstr("byte 80: the count of 20 facets asks for 1084 bytes, the file has 1083"));
  std::string huge = good_bytes;
  std::memset(huge.data() + 80, 0xff, 4);
  EXPECT_THAT(error_of(huge), HasSubstr("byte 80: the count of 4294967295 facets"));
  std::string not_finite = good_bytes;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(not_finite.data() + 84 + 50 + 12, &nan, 4);
  EXPECT_THAT(error_of(not_finite), HasSubstr("byte 146: corner 0 of facet 1 is not finite"));
}

TEST(MembraneStl, AnyFlippedByteIsReadOrRefusedButNeverCrashes) {
  std::mt19937 random(9);
  for (const std::string& good : {ascii(unit_sphere(0)), binary(unit_sphere(0))}) {
    for (int round = 0; round < 2000; ++round) {
      std::string bytes = good;
      bytes[random() % bytes.size()] = static_cast<char>(random());
      if (round % 3 == 0) bytes.resize(random() % bytes.size());
      try {
        check_surface(parse_stl(bytes, "cell.stl"), "cell.stl");
      } catch (const Error&) {
      }
    }
  }
}

}  // namespace
}  // namespace rouleau
