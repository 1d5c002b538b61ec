// SPDX-License-Identifier: BSD-3-Clause
// What must not matter does not matter to the last bit: tracking at equal viscosities, how often one looks.
#include <gtest/gtest.h>

#include "restart/small_run.hpp"

namespace rouleau::testing {
namespace {

/// Checksums of one item of a checkpoint.
nlohmann::json item(const nlohmann::json& checkpoint, const std::string& name) {
  for (const auto& each : checkpoint.at("items"))
    if (each.at("name") == name) return each;
  ADD_FAILURE() << "no item " << name;
  return {};
}

TEST(EqualViscosities, TrackingChangesNoBit) {
  SmallRun on(Changes{{"fluid.lambda", "1"}});
  on.finish();
  SmallRun off(Changes{{"fluid.lambda", "1"}, {"numerics.tracking", "off"}, {"numerics.correction_interval", ""}});
  off.finish();
  const auto a = on.newest_checkpoint(), b = off.newest_checkpoint();
  for (const char* name : {"fluid/f", "cells/X", "cells/U", "flow/controller"})
    EXPECT_EQ(item(a, name), item(b, name)) << name;
  EXPECT_NE(item(a, "interior/flags"), item(b, "interior/flags"));
}

TEST(UnequalViscosities, TrackingChangesTheFlow) {
  SmallRun one(Changes{{"fluid.lambda", "1"}});
  one.finish();
  SmallRun five(Changes{{"fluid.lambda", "5"}});
  five.finish();
  EXPECT_NE(item(one.newest_checkpoint(), "cells/X"), item(five.newest_checkpoint(), "cells/X"));
}

TEST(Sampling, IntervalChangesNoBitOfTheState) {
  SmallRun often(Changes{{"output.sample_interval_steps", "1"}});
  often.finish();
  SmallRun rarely(Changes{{"output.sample_interval_steps", "40"}});
  rarely.finish();
  const auto a = often.newest_checkpoint(), b = rarely.newest_checkpoint();
  for (const char* name : {"fluid/f", "cells/X", "interior/flags"}) EXPECT_EQ(item(a, name), item(b, name)) << name;
}

}  // namespace
}  // namespace rouleau::testing
