// SPDX-License-Identifier: BSD-3-Clause
// `rouleau why POINT`: every change of state with its evidence.
#include "commands/print.hpp"
#include "commands/verbs.hpp"
#include "commands/wish.hpp"
#include "store/store.hpp"

namespace rouleau::campaign {

namespace {

int why(const CommandLine& line) {
  const std::vector<PointRow> points = named_points(line, "why");
  const Store store = Store::open_reader(line.directory / "campaign.db");
  Table table{"events", {"point", "time_utc", "attempt", "from", "to", "evidence"}, {}};
  for (const PointRow& point : points)
    for (const EventRow& event : store.events(point.key))
      table.rows.push_back({fmt::format("#{}", point.ordinal), iso_utc(event.unix_s),
                            event.attempt ? Value(std::int64_t{*event.attempt}) : Value(),
                            event.from ? Value(std::string(word_of(*event.from))) : Value(),
                            std::string(word_of(event.to)), event.evidence});
  print(line, table);
  return static_cast<int>(Exit::ok);
}

}  // namespace

const Verb why_verb = {
    "why",
    "why a point is in its state: every change and its evidence",
    "POINT... [-C DIR] [--format csv|json]",
    "  rouleau why '#3' -C my-campaign   oldest change first\n",
    "",
    Words::points,
    true,
    nullptr,
    why,
};

}  // namespace rouleau::campaign
