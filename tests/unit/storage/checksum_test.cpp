// SPDX-License-Identifier: BSD-3-Clause
// The order-free checksum: any cut gives the same sum, and damage changes it.
#include "storage/checksum.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "base/error.hpp"
#include "storage/metadata.hpp"
#include "support/small_state.hpp"

namespace rouleau::testing {
namespace {

TEST(Checksum, IsTheSumOverAnyCut) {
  std::vector<float> values(1000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = sample_value<float>(scramble(1, i));
  const std::uint64_t whole = row_checksum(ElementType::f32, values.data(), values.size(), 0);
  for (const std::size_t cut : {1U, 17U, 500U, 999U}) {
    EXPECT_EQ(row_checksum(ElementType::f32, values.data(), cut, 0) +
                  row_checksum(ElementType::f32, values.data() + cut, values.size() - cut, cut),
              whole);
  }
}

TEST(Checksum, ChangesWithEveryBitOfEveryElement) {
  std::vector<double> values(20, 0.0);
  const std::uint64_t before = row_checksum(ElementType::f64, values.data(), values.size(), 0);
  std::set<std::uint64_t> seen{before};
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int bit = 0; bit < 64; ++bit) {
      const double kept = values[i];
      values[i] = std::bit_cast<double>(std::bit_cast<std::uint64_t>(kept) ^ (std::uint64_t{1} << bit));
      seen.insert(row_checksum(ElementType::f64, values.data(), values.size(), 0));
      values[i] = kept;
    }
  }
  EXPECT_EQ(seen.size(), 20U * 64U + 1U);
}

TEST(Checksum, ChangesWhenElementsChangePlaces) {
  std::vector<std::uint8_t> values(200);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i);
  const std::uint64_t before = row_checksum(ElementType::u8, values.data(), values.size(), 0);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    std::swap(values[i], values[i + 1]);
    EXPECT_NE(row_checksum(ElementType::u8, values.data(), values.size(), 0), before);
    std::swap(values[i], values[i + 1]);
  }
  std::vector<std::uint8_t> shifted(values.begin() + 1, values.end());
  shifted.push_back(values[0]);
  EXPECT_NE(row_checksum(ElementType::u8, shifted.data(), shifted.size(), 0), before);
}

TEST(Checksum, SumsOfRanksWrapExactly) {
  const Communicator comm;
  std::vector<std::uint64_t> parts{~std::uint64_t{0}, std::uint64_t{1} << 63U, 5};
  const std::vector<std::uint64_t> own = parts;
  sum_over_ranks(comm, parts);
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_EQ(parts[i], own[i] * static_cast<std::uint64_t>(comm.size()));
}

TEST(Checksum, HexIsReadBackAndNothingElseIs) {
  std::uint64_t value = 0;
  EXPECT_EQ(hex(0xAB), "00000000000000ab");
  EXPECT_TRUE(parse_hex("00000000000000ab", value));
  EXPECT_EQ(value, 0xABU);
  for (const char* text : {"", "ab", "00000000000000AB", "00000000000000a ", "0x000000000000ab", "g000000000000000"}) {
    EXPECT_FALSE(parse_hex(text, value)) << text;
  }
}

TEST(Metadata, IsReadBackAsWritten) {
  CheckpointMetadata metadata = small_metadata(123456789012);
  metadata.time_s = 1.0 / 3.0;
  metadata.version = "quote \" and \\ and \xC3\xA9";
  EXPECT_EQ(metadata_from_json(to_json(metadata), "file"), metadata);
}

TEST(Metadata, TextThatIsWrongNamesTheEntry) {
  const std::string text = to_json(small_metadata(5));
  const auto broken = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    try {
      static_cast<void>(metadata_from_json(changed, "a.h5"));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Exit::bad_input);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(broken("\"step\": 5", "\"step\": \"5\"").find("a.h5: metadata entry `step`"), std::string::npos);
  EXPECT_NE(broken("\"identity\"", "\"identitx\"").find("`identity`"), std::string::npos);
  EXPECT_NE(broken("{", "[").find("not a JSON object"), std::string::npos);
}

}  // namespace
}  // namespace rouleau::testing
