// SPDX-License-Identifier: BSD-3-Clause
// A database of a few points with results, for tests of queries.
#pragma once

#include <string>
#include <vector>

#include "store/store.hpp"
#include "support/temporary_directory.hpp"

namespace rouleau::campaign::testing {

/// Points #1 ... #4 with fluid.lambda = 1, 4.75, 5, 10: croissant, undecided, slipper (without an error), and one
/// without a result.
class SmallCampaign {
 public:
  SmallCampaign() : store(Store::create(directory.path() / "campaign.db", {"small", "", "", 1.7e9, "0.1.0", "abc"})) {
    add("a1b200000001", 1, "1", State::done, "croissant", 0.05);
    add("a1b200000002", 2, "4.75", State::done, "undecided", 0.4);
    add("c3d400000003", 3, "5", State::running, "slipper", 0.8);
    add("c3d400000004", 4, "10", State::waiting, "", 0);
  }

  ::rouleau::testing::TemporaryDirectory directory;
  Store store;

 private:
  void add(const std::string& key, int ordinal, const std::string& lambda, State state, const std::string& phase,
           double d) {
    PointRow point;
    point.key = key;
    point.ordinal = ordinal;
    point.state = state;
    store.add_point(point,
                    {{"fluid.lambda", lambda, std::stod(lambda), true},
                     {"cell.radius_um", "4", 4.0, false},
                     {"cell.2.radius_um", "3", 3.0, false},
                     {"cell.shape", "red_blood_cell", std::nullopt, false}},
                    "added");
    if (phase.empty()) return;
    ResultRow result;
    result.point = key;
    result.window_s = 0.2;
    result.d_mean_um = d;
    if (ordinal != 3) result.d_error_um = 0.0123;
    result.phase = phase;
    result.phase_reason = "test";
    store.put_result(result);
  }
};

}  // namespace rouleau::campaign::testing
