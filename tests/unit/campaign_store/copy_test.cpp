// SPDX-License-Identifier: BSD-3-Clause
// Copies of points while somebody writes.
#include "store/copy.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "sample_rows.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign {
namespace {

TEST(Copy, HasEachPointAsItWasAtOneMomentWhileAWriterGoesOn) {
  const ::rouleau::testing::TemporaryDirectory place;
  const std::filesystem::path file = place.path() / "campaign.db";
  const std::vector<std::int64_t> ordinals = {1, 2, 3};
  {
    Store made = Store::create(file, testing::a_campaign());
    for (const int ordinal : {1, 2, 3}) made.add_point(testing::a_point(ordinal), {}, "added");
  }
  std::atomic<int> written = 0;
  const std::jthread writer([&](const std::stop_token& is_over) {
    Store store = Store::open(file);
    for (int step = 1; !is_over.stop_requested(); ++step) {
      const auto begin = std::chrono::steady_clock::now();
      Transaction transaction = store.begin();
      for (const int ordinal : {1, 2, 3}) {
        SampleRow sample;
        sample.step = step;
        ResultRow result;
        result.point = testing::a_point(ordinal).key;
        result.step = step;
        result.phase = "slipper";
        store.put_samples(result.point, std::vector<SampleRow>{sample});
        store.put_result(result);
      }
      transaction.commit();
      written = step;
      // On a slow disk readers would find no gap within the second that they wait.
      std::this_thread::sleep_for(std::chrono::steady_clock::now() - begin);
    }
  });
  for (int copies = 0; copies < 20 || written < 20; ++copies) {
    const std::filesystem::path target = place.path() / ("copy" + std::to_string(copies));
    const Store copy = copy_points(Store::open_reader(file), target, ordinals);
    EXPECT_EQ(copy.database().select_integer("SELECT count(*) FROM point"), 3);
    EXPECT_EQ(copy.database().select_integer("SELECT count(*) FROM result r WHERE r.step != "
                                             "(SELECT max(step) FROM sample s WHERE s.point = r.point)"),
              0);
  }
}

}  // namespace
}  // namespace rouleau::campaign
