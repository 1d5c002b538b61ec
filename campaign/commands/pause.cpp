// SPDX-License-Identifier: BSD-3-Clause
#include "commands/pause.hpp"

#include <fmt/format.h>

namespace rouleau::campaign {

namespace {

constexpr std::string_view setting = "like_failures";

}  // namespace

Breaker kept_breaker(const Store& store, const Study& study) {
  return Breaker(static_cast<int>(study.execution.pause_after_failures), store.setting(setting).value_or(""));
}

void keep(Store& store, const Breaker& breaker) { store.set_setting(setting, breaker.text()); }

std::string pause_text(const Breaker& breaker) {
  return fmt::format(
      "paused: {} points in a row failed early and alike ({}). Nothing more is started. Correct the cause, then "
      "`rouleau retry --all-failed` and `rouleau run`.",
      breaker.count(), breaker.reason());
}

}  // namespace rouleau::campaign
