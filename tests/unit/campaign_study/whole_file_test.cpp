// SPDX-License-Identifier: BSD-3-Clause
// Directories are made with all that is above them, or it is said why not; a pipe in a file's place blocks nobody.
#include "study/whole_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::set_content;
using rouleau::testing::TemporaryDirectory;

TEST(MakeDirectories, MakesThoseAboveToo) {
  const TemporaryDirectory place;
  make_directories(place.path() / "a/b/c");
  make_directories(place.path() / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_directory(place.path() / "a/b/c"));
}

TEST(MakeDirectories, FileInTheWayIsNamed) {
  const TemporaryDirectory place;
  set_content(place.path() / "a", "");
  try {
    make_directories(place.path() / "a/b");
    FAIL() << "was made";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/a"), std::string::npos) << error.what();
  }
}

TEST(ReadWholeFile, PipeWithoutAWriterIsEmpty) {
  const TemporaryDirectory place;
  const auto pipe = place.path() / "exit.json";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
  EXPECT_EQ(read_whole_file(pipe), "");
}

TEST(Cksum, IsThatOfTheProgram) {
  EXPECT_EQ(cksum_of(""), "4294967295 0");
  EXPECT_EQ(cksum_of("123456789"), "930766865 9");
  EXPECT_EQ(cksum_of(std::string(70000, '\xff')), "2060310866 70000");
}

}  // namespace
}  // namespace rouleau::campaign
