// SPDX-License-Identifier: BSD-3-Clause
// OFF files: round trip, and errors that name the line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <random>
#include <string>

#include "base/error.hpp"
#include "membrane/shapes.hpp"
#include "membrane/surface_file.hpp"

namespace rouleau {
namespace {

using testing::HasSubstr;

const std::string tetrahedron =
    "OFF\n# a comment\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 +1.0e0\n3 0 2 1\n3 0 1 3 255 0 0\n3 0 3 2\n3 1 2 3\n";

std::string error_of(const std::string& text) {
  try {
    parse_off(text, "cell.off");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::bad_input);
    return error.what();
  }
  return "no error";
}

TEST(MembraneOff, ReadsVerticesTrianglesCommentsAndColours) {
  const Surface s = parse_off(tetrahedron, "cell.off");
  EXPECT_EQ(s.X.size(), 4u);
  EXPECT_EQ(s.triangles.size(), 4u);
  EXPECT_EQ(at(s.X, 3), Vec3(0, 0, 1));
  EXPECT_EQ(s.triangles.c[1], 3);
}

TEST(MembraneOff, ReadsDosLineEndsAndCountsBehindTheWord) {
  std::string text = "OFF 4 4 6\r\n" + tetrahedron.substr(tetrahedron.find("0 0 0"));
  EXPECT_EQ(parse_off(text, "cell.off").triangles.size(), 4u);
}

TEST(MembraneOff, WritesWhatReadsBackToTheSameBits) {
  const auto path = std::filesystem::path(testing::TempDir()) / "membrane_round_trip.off";
  const Surface s = red_blood_cell(3, 4);
  write_off(s, path);
  const Surface back = read_surface(path);
  EXPECT_EQ(back.X.x, s.X.x);
  EXPECT_EQ(back.X.y, s.X.y);
  EXPECT_EQ(back.X.z, s.X.z);
  EXPECT_EQ(back.triangles.a, s.triangles.a);
  EXPECT_EQ(back.triangles.b, s.triangles.b);
  EXPECT_EQ(back.triangles.c, s.triangles.c);
  std::filesystem::remove(path);
}

struct BadOff {
  const char *text, *message;
};

class BadOffFiles : public testing::TestWithParam<BadOff> {};
TEST_P(BadOffFiles, AreRefusedWithTheirLine) { EXPECT_THAT(error_of(GetParam().text), HasSubstr(GetParam().message)); }
INSTANTIATE_TEST_SUITE_P(
    MembraneOff, BadOffFiles,
    testing::Values(
        BadOff{"", "cell.off:0: the file ends where the word OFF should stand"},
        BadOff{"PLY\n", "cell.off:1: an OFF file starts with the word OFF"},
        BadOff{"NOFF\n1 1 1\n", "cell.off:1: an OFF file starts with the word OFF"},
        BadOff{"OFF\n", "ends where the counts"}, BadOff{"OFF\n4 4\n", "cell.off:2: expected the three counts"},
        BadOff{"OFF\n4 x 0\n", "cell.off:2: 'x' is not an integer"},
        BadOff{"OFF\n-4 4 0\n", "cell.off:2: -4 is outside"},
        BadOff{"OFF\n2000000000 2000000000 0\n", "do not fit into the file's 28 bytes"},
        BadOff{"OFF\n99999999999999999999 1 0\n", "out of its range"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "cell.off:4: vertex 1 has 2 numbers instead of 3"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "cell.off:4: 'nan' is not finite"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 1e999\n0 1 0\n3 0 1 2\n", "cell.off:4: '1e999' is not a number"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 0,5\n0 1 0\n3 0 1 2\n", "cell.off:4: '0,5' is not a number"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 3\n", "cell.off:6: face 0 has 4 corners; only triangles"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "cell.off:6: 3 is outside 0..2"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n", "cell.off:6: -1 is outside 0..2"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n#pad\n", "cell.off:6: face 0 names fewer than 3 vertices"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n# pad pad\n", "cell.off:6: the file ends where face 0 of 1"},
        BadOff{"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n", "cell.off:7: text after the last of 1 faces"}));

TEST(MembraneOff, AnyPrefixAndAnyFlippedByteIsReadOrRefusedButNeverCrashes) {
  for (std::size_t length = 0; length < tetrahedron.size() - 1; ++length) {
    try {
      parse_off(tetrahedron.substr(0, length), "cell.off");
      ADD_FAILURE() << "a file cut at byte " << length << " was accepted";
    } catch (const Error&) {
    }
  }
  std::mt19937 random(5);
  for (int round = 0; round < 5000; ++round) {
    std::string text = tetrahedron;
    text[random() % text.size()] = static_cast<char>(random());
    try {
      const Surface s = parse_off(text, "cell.off");
      for (const std::int32_t v : s.triangles.a) EXPECT_LT(static_cast<std::size_t>(v), s.X.size());
    } catch (const Error&) {
    }
  }
}

TEST(MembraneFiles, MissingFilesAndUnknownKindsAreRefused) {
  EXPECT_THROW(read_surface("/nonexistent/cell.off"), Error);
  EXPECT_THROW(read_surface("/tmp"), Error);
  EXPECT_THROW(read_surface("cell.ply"), Error);
  EXPECT_THROW(write_off(unit_sphere(0), "/nonexistent/cell.off"), Error);
}

TEST(MembraneFiles, FileThatIsThereButCannotBeOpenedIsAnIoFailure) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "rouleau_cannot_be_opened.off";
  write_off(unit_sphere(0), path);
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  const rlimit none{0, limit.rlim_max};
  setrlimit(RLIMIT_NOFILE, &none);
  Exit code = Exit::finished;
  try {
    read_surface(path);
  } catch (const Error& error) {
    code = error.code();
  }
  setrlimit(RLIMIT_NOFILE, &limit);
  std::filesystem::remove(path);
  EXPECT_EQ(code, Exit::io) << "it may pass";
}

}  // namespace
}  // namespace rouleau
