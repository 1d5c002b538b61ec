// SPDX-License-Identifier: BSD-3-Clause
// The table of points and results: which columns, which rows, in which order, averaged over which window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "store/store.hpp"
#include "study/settings.hpp"

namespace rouleau::campaign {

/// What to list; what is empty is chosen for the user.
struct PhaseQuery {
  std::string columns;  ///< comma-separated names; empty: what was swept, state, class, d, asphericity, cost
  std::string where;    ///< a condition (report/filter.hpp)
  std::string sort;     ///< comma-separated names, `-name` descending; empty: by what was swept
  std::optional<Analysis>
      analysis;  ///< other windows or thresholds than the stored ones: all series are analysed again
};

/// throws  Error (usage) for unknown names and conditions that are none
Table phase_table(Store& reader, const PhaseQuery& query);

/// The same to be looked at: a measure has as many digits as its error allows, and the error in brackets behind it,
/// 0.208(40), unless the query names the error's column too.
Table phase_table_for_eyes(Store& reader, const PhaseQuery& query);

}  // namespace rouleau::campaign
