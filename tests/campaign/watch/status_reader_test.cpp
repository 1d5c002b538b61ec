// SPDX-License-Identifier: BSD-3-Clause
// What a reader of many points looks at again, and what not.
#include <gtest/gtest.h>

#include <sstream>

#include "../../unit/campaign_ingest/written_campaign.hpp"
#include "commands/point_status.hpp"
#include "commands/verbs.hpp"
#include "executor/process.hpp"

namespace rouleau::campaign {
namespace {

using ::rouleau::testing::set_content;

TEST(StatusReader, LooksOnceAtPointsThatAreThroughAndAlwaysAtOthers) {
  testing::WrittenCampaign campaign;
  campaign.host = host_name();
  for (const int lambda : {1, 5}) {
    const std::string key = campaign.add_point(lambda).key;
    campaign.add_attempt(key, 1);
    set_content(campaign.log(key), testing::log_header + testing::log_lines(0, 100000));
  }
  campaign.end_attempt("000000abc001", 1, 0, 0, 100000);
  std::ostringstream messages;
  Streams io{messages, messages};
  ASSERT_EQ(run_command_line(all_verbs, {"rebuild", campaign.path()}, io), 0) << messages.str();

  const auto progress_of_both = [&](double d_um) {
    for (const char* key : {"000000abc001", "000000abc005"})
      set_content(
          campaign.run(key) / "progress.json",
          fmt::format(R"({{"contract": 1, "attempt": 1, "step": 25000, "end_step": 100000, "d_um": {}}})", d_um));
  };
  const auto d_um = [&](StatusReader& reader) {
    const Store store = Store::open_reader(campaign.path() / "campaign.db");
    std::vector<double> all;
    for (const PointStatus& s : reader.read(store, {"fluid.lambda"})) all.push_back(s.progress->d_um.value());
    return all;
  };
  StatusReader reader(campaign.path());
  progress_of_both(0.5);
  EXPECT_EQ(d_um(reader), (std::vector<double>{0.5, 0.5}));
  progress_of_both(0.75);
  EXPECT_EQ(d_um(reader), (std::vector<double>{0.5, 0.75})) << "the first is done";
  {
    Store store = Store::open(campaign.path() / "campaign.db");
    ASSERT_TRUE(store.change_state("000000abc001", State::done, State::stopped, "the study asks for more"));
  }
  EXPECT_EQ(d_um(reader), (std::vector<double>{0.75, 0.75})) << "and is no longer";
}

TEST(StatusReader, PutsValuesUnderTheNamesOfTheirAxes) {
  testing::WrittenCampaign campaign;
  campaign.add_point(5);
  std::ostringstream messages;
  Streams io{messages, messages};
  ASSERT_EQ(run_command_line(all_verbs, {"rebuild", campaign.path()}, io), 0) << messages.str();
  const Store store = Store::open_reader(campaign.path() / "campaign.db");
  StatusReader reader(campaign.path());
  // A point of an earlier study lacks the axis in front.
  const std::vector<PointStatus> points = reader.read(store, {"cell.replica", "fluid.lambda"});
  EXPECT_EQ(points.at(0).swept, (std::vector<Value>{Value(), Value(5.0)}));
}

}  // namespace
}  // namespace rouleau::campaign
