// SPDX-License-Identifier: BSD-3-Clause
// The two loops: read, show, wait for time or signals.
#include "commands/watch.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ostream>

#include "commands/screen.hpp"
#include "commands/watch_layout.hpp"
#include "executor/signals.hpp"

namespace rouleau::campaign {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double screen_interval_s = 2, lines_interval_s = 60;

Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// The next signal, or 0 when the time has come.
int wait_until(SignalWatch& signals, Clock::time_point when) {
  while (true) {
    const double left_ms = std::chrono::duration<double, std::milli>(when - Clock::now()).count();
    if (left_ms <= 0) return 0;
    if (const int signal = signals.wait(static_cast<int>(std::min(left_ms + 1, 1e6))); signal != 0) return signal;
  }
}

/// Whether nothing but another look follows from the signal.
bool goes_on_after(int signal) { return signal == 0 || signal == SIGWINCH || signal == SIGTSTP || signal == SIGCHLD; }

/// The facts of now. If they cannot be read at this moment, those of before with the reason: a database that is being
/// written, or a disk that does not answer, is no reason to stop looking.
void read_again(WatchReader& reader, WatchFacts& facts, const ChangesWanted& wanted) {
  try {
    facts = reader.read(wanted);
  } catch (const Error& error) {
    facts.warning = fmt::format("as of {}: {}", clock_text(facts.now_unix_s), error.what());
    facts.changes.clear();
  }
}

Look look_of(const CommandLine& line, const std::string& hint) {
  const ScreenSize size = Screen::size();
  // One column stays free: at the end of a full line, clearing its rest would take the last character.
  return {std::max(1, size.columns - 1), size.rows, line.io.colour, locale_is_utf8(), line.header, hint};
}

WatchFacts watch_on_screen(const CommandLine& line, double interval_s) {
  WatchReader reader(line.directory);
  WatchFacts facts = reader.read({});
  SignalWatch signals({SIGWINCH, SIGTSTP});
  int signal = 0;
  {
    Screen screen(line.io.out);
    while (!facts.is_over() && goes_on_after(signal)) {
      const Clock::time_point next = after(interval_s);
      do {
        screen.show(watch_lines(facts, look_of(line, "Ctrl-C leaves")));
        signal = wait_until(signals, next);
        if (signal != SIGTSTP) continue;
        screen.leave();
        ::kill(::getpid(), SIGSTOP);  // Ctrl-Z, with the terminal as it was; goes on here
      } while (signal != 0 && goes_on_after(signal));
      if (signal == 0) read_again(reader, facts, {});
    }
  }
  for (const std::string& text : watch_lines(facts, look_of(line, ""))) line.io.out << text << '\n';
  return facts;
}

WatchFacts watch_in_lines(const CommandLine& line, double interval_s) {
  WatchReader reader(line.directory);
  WatchFacts facts = reader.read({0, 1});
  SignalWatch signals;
  std::int64_t newest = facts.changes.empty() ? 0 : facts.changes.front().id;
  facts.changes.clear();  // what happened before is `rouleau why`'s to tell
  std::string told;       // warnings are told once
  while (true) {
    for (auto change = facts.changes.rbegin(); change != facts.changes.rend(); ++change)
      line.io.out << change_text(*change, facts.now_unix_s) << '\n';
    if (!facts.changes.empty()) newest = facts.changes.front().id;
    if (facts.warning != told && !facts.warning.empty()) line.io.out << facts.warning << '\n';
    told = facts.warning;
    if (!line.quiet)
      line.io.out << fmt::format("{} {}: {}; {}\n", clock_text(facts.now_unix_s), facts.name, states_text(facts.points),
                                 totals_text(facts));
    line.io.out << std::flush;
    if (facts.is_over() || !goes_on_after(wait_until(signals, after(interval_s)))) return facts;
    read_again(reader, facts, {newest, -1});
  }
}

}  // namespace

std::vector<PointStatus> watch(const CommandLine& line, std::optional<double> interval_s) {
  return (line.io.redraws ? watch_on_screen(line, interval_s.value_or(screen_interval_s))
                          : watch_in_lines(line, interval_s.value_or(lines_interval_s)))
      .points;
}

}  // namespace rouleau::campaign
