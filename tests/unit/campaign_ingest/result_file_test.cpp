// SPDX-License-Identifier: BSD-3-Clause
// result.json says what the database says.
#include "ingest/result_file.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "study/record.hpp"
#include "written_campaign.hpp"

namespace rouleau::campaign {
namespace {

TEST(ResultFile, HoldsWindowMeansErrorsClassCostAndProvenance) {
  testing::WrittenCampaign campaign;
  Store store = Store::create(campaign.path() / "campaign.db", {"small", "", "", 1.7e9, "0", "0"});
  const Point point = campaign.add_point(5);
  store.add_point(row_of(point), parameter_rows_of(point), "added");
  for (const int number : {1, 2}) {
    campaign.add_attempt(point.key, number);
    AttemptRow attempt;
    attempt.point = point.key;
    attempt.number = number;
    store.put_attempt(attempt);
  }
  campaign.end_attempt(point.key, 2, 0, 0, 100000);  // attempt 1 was killed: no exit.json
  ::rouleau::testing::set_content(campaign.log(point.key), testing::log_header + testing::log_lines(0, 100000));
  ingest_point(store, campaign.path(), point.key);
  write_result_file(store, campaign.path(), point.key);

  const std::filesystem::path file = campaign.run(point.key) / "result.json";
  const auto json = nlohmann::json::parse(::rouleau::testing::content_of(file));
  const ResultRow result = store.results(point.key).at(0);
  EXPECT_EQ(json["swept"]["fluid.lambda"], "5");
  EXPECT_EQ(json["cells"][0]["d_mean_um"].get<double>(), *result.d_mean_um);
  EXPECT_EQ(json["cells"][0]["d_error_um"].get<double>(), *result.d_error_um);
  EXPECT_EQ(json["cells"][0]["class"], "slipper");
  EXPECT_EQ(json["cells"][0]["window_s"], 0.2);
  EXPECT_EQ(json["cost"]["attempts"], 2);
  EXPECT_EQ(json["cost"]["attempts_without_figures"], 1);
  EXPECT_DOUBLE_EQ(json["cost"]["core_h"].get<double>(), 21.0 / 3600);
  EXPECT_EQ(json["provenance"][1]["git"], "abc");
  EXPECT_TRUE(json["provenance"][0]["exit_code"].is_null());
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".tmp"));

  std::string text = ::rouleau::testing::content_of(file);
  EXPECT_TRUE(parse_record(text).contains("check"));
  text[text.find("slipper")] = 'S';
  EXPECT_THROW(static_cast<void>(parse_record(text)), Damage);
}

}  // namespace
}  // namespace rouleau::campaign
