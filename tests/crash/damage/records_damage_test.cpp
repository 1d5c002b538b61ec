// SPDX-License-Identifier: BSD-3-Clause
// A damaged record or run file is known for what it is, and nothing is concluded from it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "crash/damage/figures.hpp"
#include "crash/damage/real_campaign.hpp"
#include "ingest/run_files.hpp"
#include "study/error.hpp"
#include "study/input_files.hpp"

namespace rouleau::campaign {
namespace {

using rouleau::testing::content_of;
using rouleau::testing::figures;
using rouleau::testing::RealCampaign;
using rouleau::testing::set_content;
using ::testing::Contains;
using ::testing::HasSubstr;

class DamagedRecord : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    program_ = std::make_unique<RealCampaign>();
    program_->finish();
  }
  static void TearDownTestSuite() { program_.reset(); }

  /// Reads the file with each of its bytes changed, and ended anywhere: it must be damaged, or say the same as before.
  template <class Read>
  static void expect_known_everywhere(const std::filesystem::path& file, const Read& read) {
    const std::string sound = content_of(file);
    std::vector<std::string> warnings;
    const auto expected = read(file, warnings);
    ASSERT_TRUE(expected.has_value()) << file;
    const auto expect_known = [&](const std::string& bytes, const std::string& what) {
      set_content(file, bytes);
      warnings.clear();
      const auto found = read(file, warnings);
      ++figures().damage_positions;
      const bool is_known = found ? *found == *expected : !warnings.empty();
      figures().undetected += is_known ? 0 : 1;
      EXPECT_TRUE(is_known) << file << " " << what;
      if (!found) {
        EXPECT_THAT(warnings, Contains(HasSubstr(file.filename().string() + ": is damaged (")));
      }
    };
    const std::size_t step = std::max<std::size_t>(1, sound.size() / 700);
    for (std::size_t i = 0; i < sound.size(); i += step) {
      std::string bytes = sound;
      bytes[i] = static_cast<char>(bytes[i] ^ (1U << (i / step) % 8U));
      expect_known(bytes, fmt::format("byte {}", i));
      if (i % 8 == 0) expect_known(sound.substr(0, i), fmt::format("ends at {}", i));
    }
    set_content(file, sound);
  }

  static std::filesystem::path attempt() { return program_->run_directory(2) / "attempts/1"; }
  static std::unique_ptr<RealCampaign> program_;
};
std::unique_ptr<RealCampaign> DamagedRecord::program_;

TEST_F(DamagedRecord, OfAnyKindIsKnown) {
  expect_known_everywhere(attempt() / "exit.json", read_exit_file);
  expect_known_everywhere(attempt() / "process.json", read_process_file);
  expect_known_everywhere(attempt() / "started.json", read_process_file);
  expect_known_everywhere(program_->run_directory(2) / "progress.json", read_progress_file);
  const auto point = [](const std::filesystem::path& file, std::vector<std::string>& warnings) -> std::optional<Point> {
    try {
      return read_point(file);
    } catch (const Error& error) {
      warnings.emplace_back(error.what());
      return std::nullopt;
    }
  };
  expect_known_everywhere(program_->run_directory(2) / "point.json", point);
}

TEST_F(DamagedRecord, OfTheEndIsNoEndAndTheRunIsLookedAtAgain) {
  const auto before = outcome_of(*program_);
  std::string bytes = content_of(attempt() / "exit.json");
  const std::size_t code = bytes.find("\"code\": 0");
  ASSERT_NE(code, std::string::npos);
  bytes[code + 8] = '1';
  set_content(attempt() / "exit.json", bytes);
  EXPECT_EQ(program_->rouleau({"verify", "c"}).status, 7);
  const auto rebuilt = program_->rouleau({"rebuild", "c"});
  EXPECT_EQ(rebuilt.status, 7);
  EXPECT_THAT(rebuilt.err, HasSubstr("exit.json: is damaged (its check does not match)"));
  EXPECT_EQ(program_->state(2), State::crashed) << "without a record of its end, that is all that is known";
  program_->finish();
  EXPECT_TRUE(outcome_of(*program_) == before);
}

class DamagedRunFile : public ::testing::Test {
 protected:
  RealCampaign program_;
};

TEST_F(DamagedRunFile, IsNotRunAndInitWritesItAnew) {
  const std::filesystem::path run = program_.run_directory(2), file = run / "run.ini";
  const std::string sound = content_of(file);
  const Point point = read_point(run / "point.json");
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string bytes = sound;
    bytes[i] = static_cast<char>(bytes[i] ^ (1U << i % 8U));
    set_content(file, bytes);
    ++figures().damage_positions;
    EXPECT_THROW(require_input_files(run, point), Error) << i;
  }
  // The worst case: another point's physics under this point's key.
  std::string other = sound;
  const std::size_t lambda = other.find("lambda = 5");
  ASSERT_NE(lambda, std::string::npos);
  other[other.find("lambda = 5", lambda + 1) == std::string::npos ? lambda + 9 : other.rfind("lambda = 5") + 9] = '4';
  set_content(file, other);
  const auto refused = program_.run();
  EXPECT_EQ(refused.status, 4) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("run.ini: is not the file that `rouleau init` wrote"));
  EXPECT_EQ(program_.state(1), State::done) << "the others are run";
  EXPECT_EQ(program_.state(3), State::done);
  EXPECT_FALSE(std::filesystem::exists(run / "samples.csv"));
  EXPECT_EQ(program_.rouleau({"verify", "c"}).status, 7);

  EXPECT_EQ(program_.init().status, 0);
  EXPECT_EQ(content_of(file), sound);
  EXPECT_EQ(program_.rouleau({"retry", "#2", "-C", "c"}).status, 0);
  program_.finish();
  EXPECT_EQ(program_.state(2), State::done);
}

TEST(DamagedCheckpointOfACampaign, IsNamedWithWhatIsWrongWithIt) {
  const RealCampaign program;
  program.finish();
  const std::filesystem::path folder = program.run_directory(2) / "checkpoints";
  const std::filesystem::path file = std::filesystem::directory_iterator(folder)->path();
  const std::string sound = content_of(file);
  EXPECT_EQ(program.rouleau({"verify", "c", "--checkpoints"}).status, 0);
  set_content(file, sound.substr(0, sound.size() / 2));
  ++figures().damage_positions;
  const auto verified = program.rouleau({"verify", "c", "--checkpoints"});
  EXPECT_EQ(verified.status, 7);
  EXPECT_THAT(verified.out, HasSubstr(file.filename().string() + ": damaged: its "));
  EXPECT_THAT(verified.out, HasSubstr("a continuation passes it over for the one before"));
}

}  // namespace
}  // namespace rouleau::campaign
