// SPDX-License-Identifier: BSD-3-Clause
#include "live_flags.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace rouleau::validation {

testing::TrackingDifference own_difference(LiveRun& run) {
  const PersistentState state = run.simulation().persistent();
  const auto flags = std::find_if(state.lattice_items.begin(), state.lattice_items.end(),
                                  [](const LatticeItem& item) { return item.name == "interior/flags"; });
  require(flags != state.lattice_items.end(), "the state has no flags");
  const auto* tracked = static_cast<const std::uint8_t*>(flags->data[0]);
  return testing::tracking_difference([&](int i, int j, int k) { return tracked[flags->layout.index(i, j, k)]; },
                                      run.cells(), run.lattice());
}

}  // namespace rouleau::validation
