// SPDX-License-Identifier: BSD-3-Clause
// The three formats.
#include "report/table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace rouleau::campaign {
namespace {

const Table& sample_table() {
  static const Table table{"phase",
                           {"lambda", "class", "note"},
                           {{0.1 + 0.2, std::string("slipper"), std::string("a, \"b\"\nc")},
                            {std::int64_t{12}, Value(), std::string("µm")}}};
  return table;
}

template <class Write>
std::string written(Write&& write) {
  std::ostringstream out;
  write(out);
  return out.str();
}

TEST(Table, CsvQuotesWhatRfc4180AsksForAndKeepsEveryBit) {
  EXPECT_EQ(written([](auto& out) { write_csv(out, sample_table(), true); }),
            "lambda,class,note\r\n0.30000000000000004,slipper,\"a, \"\"b\"\"\nc\"\r\n12,,µm\r\n");
}

TEST(Table, HeaderCanBeLeftOut) {
  EXPECT_EQ(written([](auto& out) { write_csv(out, {"k", {"a"}, {{std::int64_t{1}}}}, false); }), "1\r\n");
  EXPECT_EQ(written([](auto& out) { write_text(out, {"k", {"a"}, {{std::int64_t{1}}}}, false); }), "1\n");
}

TEST(Table, JsonHasItsVersionAndReadsBackBitByBit) {
  const auto json = nlohmann::json::parse(written([](auto& out) { write_json(out, sample_table()); }));
  EXPECT_EQ(json["schema_version"], 1);
  EXPECT_EQ(json["kind"], "phase");
  EXPECT_EQ(json["rows"][0]["lambda"].get<double>(), 0.1 + 0.2);
  EXPECT_TRUE(json["rows"][1]["class"].is_null());
  EXPECT_EQ(json["rows"][0]["note"], "a, \"b\"\nc");
}

TEST(Table, JsonInPartsIsTheSameDocument) {
  const std::string whole = written([](auto& out) { write_json(out, sample_table()); });
  const std::string parts = written([](auto& out) {
    JsonRows rows(out, "phase");
    for (const auto& row : sample_table().rows) rows.add({"", sample_table().columns, {row}});
    rows.end();
  });
  EXPECT_EQ(parts, whole);
  EXPECT_TRUE(nlohmann::json::parse(written([](auto& out) { JsonRows(out, "k").end(); }))["rows"].empty());
}

TEST(Table, BytesThatAreNoUtf8DoNotEndTheListing) {
  const Table table{"k", {"name"}, {{std::string("\xff")}}};
  EXPECT_NO_THROW(nlohmann::json::parse(written([&](auto& out) { write_json(out, table); })));
}

TEST(Table, TextIsAlignedWithNumbersToTheRight) {
  EXPECT_EQ(written([](auto& out) {
              write_text(out, {"k", {"n", "word"}, {{0.5, std::string("µm")}, {10.0, Value()}}}, true);
            }),
            "  n  word\n0.5  µm\n 10  -\n");
}

TEST(Table, NumbersWrittenAsTextGoToTheRightToo) {
  Table table{
      "k", {"d_mean_um", "λ"}, {{std::string("0.208(40)"), 5.0}, {std::string("12.3(1.5)"), 10.0}, {Value(), 1.0}}};
  table.right_aligned = {0};
  EXPECT_EQ(written([&](auto& out) { write_text(out, table, true); }),
            "d_mean_um   λ\n0.208(40)   5\n12.3(1.5)  10\n        -   1\n");
}

TEST(Table, ALongLastColumnOfWordsIsFoldedToTheWidth) {
  const Table table{
      "k", {"n", "evidence"}, {{std::int64_t{7}, std::string("the µ-process is gone and left no record")}}};
  EXPECT_EQ(written([&](auto& out) { write_text(out, table, true, 24); }),
            "n  evidence\n7  the µ-process is gone\n   and left no record\n");
  const std::string unfolded = "n  evidence\n7  the µ-process is gone and left no record\n";
  EXPECT_EQ(written([&](auto& out) { write_text(out, table, true); }), unfolded);
  EXPECT_EQ(written([&](auto& out) { write_text(out, table, true, 22); }), unfolded);  // too narrow to be of use
  EXPECT_EQ(text_width(table), 43U);
}

TEST(Table, WordsLongerThanTheWidthStayWhole) {
  const Table table{"k", {"file"}, {{std::string("a checkpoints/000000003598.h5.foreign b")}}};
  EXPECT_EQ(written([&](auto& out) { write_text(out, table, false, 20); }),
            "a\ncheckpoints/000000003598.h5.foreign\nb\n");
}

TEST(Table, CutLeavesTheFirstColumns) {
  Table table = sample_table();
  cut(table, 1);
  EXPECT_EQ(written([&](auto& out) { write_csv(out, table, true); }), "lambda\r\n0.30000000000000004\r\n12\r\n");
}

}  // namespace
}  // namespace rouleau::campaign
