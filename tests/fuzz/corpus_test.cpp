// SPDX-License-Identifier: BSD-3-Clause
// Every file of the corpus, and a few hundred damaged forms of each, is taken or refused with a message.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "base/error.hpp"
#include "fuzz/formats.hpp"
#include "study/error.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::fuzz {
namespace {

/// Fails the test for any exception that is not one of the two Errors.
void expect_taken_or_refused(const Format& format, const std::string& bytes, const std::string& what) {
  try {
    format.read(bytes);
  } catch (const Error& error) {
    EXPECT_STRNE(error.what(), "") << what;
  } catch (const campaign::Error& error) {
    EXPECT_STRNE(error.what(), "") << what;
  } catch (const std::exception& error) {
    ADD_FAILURE() << what << ": " << error.what();
  }
}

class Corpus : public ::testing::TestWithParam<Format> {};

TEST_P(Corpus, IsTakenOrRefusedWhole) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(FUZZ_CORPUS) + "/" + GetParam().name.data())) {
    expect_taken_or_refused(GetParam(), testing::content_of(entry.path()), entry.path().string());
    ++files;
  }
  EXPECT_GE(files, 2) << "no seeds";
}

TEST_P(Corpus, IsTakenOrRefusedDamaged) {
  std::mt19937 random(5);
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(FUZZ_CORPUS) + "/" + GetParam().name.data())) {
    const std::string sound = testing::content_of(entry.path());
    for (int i = 0; i < 20 && !sound.empty(); ++i) {
      std::string bytes = sound;
      const std::size_t at = random() % sound.size();
      bytes[at] = static_cast<char>(bytes[at] ^ (1U << random() % 8));
      if (i % 4 == 3) bytes.resize(at);
      expect_taken_or_refused(GetParam(), bytes, entry.path().string() + " damaged at " + std::to_string(at));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, Corpus, ::testing::ValuesIn(formats),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace rouleau::fuzz
