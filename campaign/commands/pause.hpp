// SPDX-License-Identifier: BSD-3-Clause
// The circuit breaker as the database keeps it, so that passes of different processes count as one.
#pragma once

#include <string>

#include "jobs/breaker.hpp"
#include "store/store.hpp"
#include "study/study.hpp"

namespace rouleau::campaign {

/// As it was kept last.
[[nodiscard]] Breaker kept_breaker(const Store& store, const Study& study);
void keep(Store& store, const Breaker& breaker);

/// What a tripped one means and what to do.
[[nodiscard]] std::string pause_text(const Breaker& breaker);

}  // namespace rouleau::campaign
