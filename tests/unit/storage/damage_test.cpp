// SPDX-License-Identifier: BSD-3-Clause
// No damage to a checkpoint file passes for a state.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "storage/checkpoint.hpp"
#include "storage/inspect.hpp"
#include "storage/resume.hpp"
#include "storage/seal.hpp"
#include "support/small_state.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::testing {
namespace {

const Int3 size{5, 4, 3};

class Damage : public ::testing::Test {
 protected:
  Communicator comm;
  TemporaryDirectory directory;
  FileSystem& files = posix_file_system();
  std::filesystem::path checkpoints = directory.path() / "checkpoints";
  std::filesystem::path file = checkpoints / checkpoint_name(10);
  CheckpointMetadata metadata = small_metadata(10);
  SmallState<double> wanted{size, Block{{0, 0, 0}, size}};
  SmallState<double> loaded{size, Block{{0, 0, 0}, size}};
  std::string sound;

  void SetUp() override {
    wanted.fill(10);
    const CheckpointPlace place{files, checkpoints, [] {}, 3};
    save_checkpoint(place, comm, wanted.list(), metadata);
    sound = content_of(file);
  }
  /// Whether the file as it is now is taken for a checkpoint.
  bool is_loaded() {
    loaded.fill(999);
    PersistentState list = loaded.list();
    const Resumed resumed = load_newest(files, checkpoints, comm, {metadata.parameters, metadata.identity, {}}, list);
    if (resumed.metadata) {
      EXPECT_EQ(*resumed.metadata, metadata);
    }
    return resumed.metadata.has_value();
  }
};

TEST_F(Damage, OfAnyOneByteIsDetected) {
  ASSERT_TRUE(is_loaded());
  std::size_t missed = 0;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string changed = sound;
    changed[i] = static_cast<char>(changed[i] ^ (1U << (i % 8)));
    set_content(file, changed);
    if (is_loaded()) ++missed;
  }
  EXPECT_EQ(missed, 0U) << "of " << sound.size();
}

TEST_F(Damage, ByTruncationAnywhereIsDetected) {
  for (std::size_t length = 0; length < sound.size(); length += 97) {
    set_content(file, sound.substr(0, length));
    EXPECT_FALSE(is_loaded()) << length;
    EXPECT_FALSE(verify_checkpoint(files, file).sound) << length;
  }
}

TEST_F(Damage, ByZeroedOrSwappedPiecesIsDetected) {
  constexpr std::size_t piece = 64;
  for (std::size_t begin = 0; begin + 2 * piece <= sound.size(); begin += piece) {
    std::string changed = sound;
    changed.replace(begin, piece, piece, '\0');
    if (changed != sound) {
      set_content(file, changed);
      EXPECT_FALSE(is_loaded()) << begin;
    }
    changed = sound;
    std::swap_ranges(changed.begin() + static_cast<std::ptrdiff_t>(begin),
                     changed.begin() + static_cast<std::ptrdiff_t>(begin + piece),
                     changed.begin() + static_cast<std::ptrdiff_t>(begin + piece));
    if (changed != sound) {
      set_content(file, changed);
      EXPECT_FALSE(is_loaded()) << begin;
    }
  }
}

// A byte that went wrong between memory and the disk, before the file was sealed: the seal is right, and the second
// line of checksums, taken from memory, must notice, or the byte means nothing.
TEST_F(Damage, BehindAnIntactSealIsDetectedOrHarmless) {
  std::size_t harmless = 0;
  std::size_t tried = 0;
  const std::size_t stride = std::max<std::size_t>(1, sound.size() / 800);
  for (std::size_t i = seal_bytes; i < sound.size(); i += stride, ++tried) {
    std::string changed = sound;
    changed[i] = static_cast<char>(changed[i] ^ (1U << (i % 8)));
    set_content(file, changed);
    write_seal(files, file, comm);
    if (!is_loaded()) continue;
    ++harmless;
    EXPECT_TRUE(loaded.same_bits(wanted)) << "byte " << i;
    EXPECT_TRUE(verify_checkpoint(files, file).sound) << "byte " << i;
  }
  EXPECT_GE(tried, 300U);
  RecordProperty("tried", static_cast<int>(tried));
  RecordProperty("harmless", static_cast<int>(harmless));
}

TEST_F(Damage, VerifyNamesWhatIsWrong) {
  EXPECT_TRUE(verify_checkpoint(files, file).sound);
  const Verification good = verify_checkpoint(files, file);
  ASSERT_EQ(good.lines.size(), 11U);  // seal, texts, 9 items
  EXPECT_EQ(good.lines[0].what, "seal");

  // The last value of the last lattice item stands somewhere after the texts; look it up by its bytes.
  const std::string bits(reinterpret_cast<const char*>(&wanted.controller[0]), 16);
  const std::size_t at = sound.find(bits);
  ASSERT_NE(at, std::string::npos);
  std::string changed = sound;
  changed[at] = static_cast<char>(changed[at] ^ 1);
  set_content(file, changed);
  const Verification broken = verify_checkpoint(files, file);
  EXPECT_FALSE(broken.sound);
  ASSERT_EQ(broken.lines.size(), 1U);
  EXPECT_FALSE(broken.lines[0].sound);

  write_seal(files, file, comm);
  const Verification named = verify_checkpoint(files, file);
  EXPECT_FALSE(named.sound);
  int wrong = 0;
  for (const VerificationLine& line : named.lines) {
    if (line.sound) continue;
    ++wrong;
    EXPECT_EQ(line.what, "controller");
  }
  EXPECT_EQ(wrong, 1);
}

}  // namespace
}  // namespace rouleau::testing
