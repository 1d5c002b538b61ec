// SPDX-License-Identifier: BSD-3-Clause
// Files are replaced whole, and errors of the file system name path, call, reason and remedy.
#include "storage/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/file_system_double.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;

class Files : public ::testing::Test {
 protected:
  TemporaryDirectory directory;
  FileSystemDouble files;
  std::filesystem::path path = directory.path() / "record.json";

  std::string failure(const char* call, int error) {
    files.failing_call = call;
    files.failing_errno = error;
    try {
      write_aside(files, path, "new");
    } catch (const Error& thrown) {
      EXPECT_EQ(thrown.code(), Exit::io);
      return thrown.what();
    }
    return "";
  }
};

TEST_F(Files, WrittenAsideIsReadBack) {
  const std::string content(100000, 'x');
  write_aside(files, path, content);
  EXPECT_EQ(read_file(files, path), content);
  EXPECT_EQ(list_directory(files, directory.path()), std::vector<std::string>{"record.json"});
}

TEST_F(Files, BytesThatComeBackAreRead) {
  set_content(path, "old");
  files.failing_call = "pread";
  files.failing_errno = EIO;
  files.failing_preads = 2;
  EXPECT_EQ(read_file(files, path), "old");
}

TEST_F(Files, MediumThatCannotReadIsNoBadInput) {
  set_content(path, "old");
  files.failing_call = "pread";
  files.failing_errno = EIO;
  try {
    static_cast<void>(read_file(files, path));
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::io);
    EXPECT_THAT(error.what(), HasSubstr("the medium cannot read 4096 bytes at 0 (errno 5)"));
  }
}

TEST_F(Files, BlocksAddUpToTheBytesAskedFor) {
  std::string content;
  while (content.size() < (5U << 19U)) content += std::to_string(content.size());
  set_content(path, content);
  for (const std::size_t asked : {std::size_t{0}, std::size_t{7}, std::size_t{1} << 20U, content.size()}) {
    std::string read;
    read_blocks(File::read(files, path), asked, [&](std::string_view block) { read += block; });
    EXPECT_TRUE(read == content.substr(0, asked)) << asked;
  }
}

TEST_F(Files, AtAnyMomentOfDeathTheOldOrTheNewContentIsThere) {
  set_content(path, "old");
  bool finished = false;
  for (int moment = 1; !finished; ++moment) {
    FileSystemDouble dying;
    dying.die_at = moment;
    try {
      write_aside(dying, path, "new");
      finished = true;
    } catch (const Error&) {
    }
    const std::string content = content_of(path);
    EXPECT_TRUE(content == "old" || content == "new") << moment << ": " << content;
    if (finished) {
      EXPECT_EQ(content, "new");
    }
  }
}

TEST_F(Files, FailureOfAnyCallIsAnErrorAndKeepsTheOldContent) {
  set_content(path, "old");
  for (const char* call : {"open", "write", "fsync", "close", "rename"}) {
    EXPECT_THAT(failure(call, EACCES), HasSubstr("Permission denied")) << call;
    EXPECT_EQ(content_of(path), "old") << call;
  }
}

TEST_F(Files, ErrorsNameTheRemedy) {
  EXPECT_THAT(failure("write", ENOSPC), HasSubstr("3 bytes are needed"));
  EXPECT_THAT(failure("write", EDQUOT), HasSubstr("raise the quota"));
  EXPECT_THAT(failure("write", EFBIG), HasSubstr("ulimit -f"));
  EXPECT_THAT(failure("open", EMFILE), HasSubstr("ulimit -n"));
  EXPECT_THAT(failure("open", EROFS), HasSubstr("permissions"));
  EXPECT_THAT(failure("rename", EIO), HasSubstr("record.json.tmp: rename failed"));
}

TEST_F(Files, MissingFileIsNamed) {
  try {
    static_cast<void>(read_file(files, path));
    FAIL() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::io);
    EXPECT_THAT(error.what(), HasSubstr("record.json: open failed: No such file"));
  }
  std::string content;
  EXPECT_FALSE(read_file_if_there(files, path, content));
}

TEST_F(Files, FilesOfProcAreReadToTheirEnd) { EXPECT_EQ(read_file(files, "/proc/sys/kernel/ostype"), "Linux\n"); }

TEST_F(Files, RoomThatIsNotThereIsNamed) {
  files.claimed_space = 1000;
  EXPECT_NO_THROW(require_free_space(files, directory.path(), "a checkpoint", 1000));
  try {
    require_free_space(files, directory.path(), "a checkpoint", 1001);
    FAIL() << "was accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("needs 1001 bytes, 1000 are free"));
  }
}

TEST_F(Files, DirectoryMadeTwiceIsSaidSo) {
  EXPECT_TRUE(make_directory(files, directory.path() / "a"));
  EXPECT_FALSE(make_directory(files, directory.path() / "a"));
  EXPECT_THROW(make_directory(files, directory.path() / "b/c"), Error);
}

}  // namespace
}  // namespace rouleau::testing
