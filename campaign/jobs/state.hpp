// SPDX-License-Identifier: BSD-3-Clause
// The words for the state of a point, defined once for the database, the planner and the tables.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace rouleau::campaign {

/// Where a point stands. The database stores the words of `word_of`.
enum class State {
  waiting,    ///< never started
  running,    ///< an attempt was started and its end is not known
  stopped,    ///< ended early behind a good checkpoint: continue me
  done,       ///< reached its end time
  failed,     ///< the physics failed: not retried by itself
  refused,    ///< bad input: not retried by itself
  crashed,    ///< died without an exit record, or on a file error: will be retried
  exhausted,  ///< crashed and has used up its retries
  cancelled,  ///< taken out by the user
};

inline constexpr std::array<std::string_view, 9> state_words = {"waiting", "running", "stopped",   "done",     "failed",
                                                                "refused", "crashed", "exhausted", "cancelled"};

[[nodiscard]] constexpr std::string_view word_of(State state) { return state_words[static_cast<std::size_t>(state)]; }

/// The state of that name, or nothing.
[[nodiscard]] constexpr std::optional<State> state_of(std::string_view word) {
  for (std::size_t i = 0; i < state_words.size(); ++i) {
    if (state_words[i] == word) return static_cast<State>(i);
  }
  return std::nullopt;
}

/// A state that nothing but the user's `retry` (or a later end time) leaves.
[[nodiscard]] constexpr bool is_final(State state) {
  return state == State::done || state == State::failed || state == State::refused || state == State::exhausted ||
         state == State::cancelled;
}

}  // namespace rouleau::campaign
