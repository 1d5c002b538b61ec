// SPDX-License-Identifier: BSD-3-Clause
// A Checker that knows enough of a run file to tell points apart.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "study/check.hpp"
#include "study/ini.hpp"
#include "study/numbers.hpp"
#include "study/whole_file.hpp"

namespace rouleau::campaign {

/// Identity: digest of all entries but those of [time] and [output]; numbers in shortest form; lambda = 5 is the
/// default. Steps: 1000 for each second of time.end_time_s.
inline CheckOutcome small_check(const std::string& run_file) {
  CheckOutcome outcome;
  CheckReply& reply = outcome.reply;
  std::vector<std::string> identity;
  for (const IniEntry& entry : parse_ini(run_file, "run.ini")) {
    const auto number = parse_number(entry.value);
    Parameter parameter{entry.section + "." + entry.name, number ? shortest(*number) : entry.value, true, true};
    parameter.is_identity = entry.section != "time" && entry.section != "output";
    if (parameter.name == "time.end_time_s") reply.facts.steps = static_cast<std::int64_t>(1000 * *number);
    if (parameter.name == "fluid.lambda" && *number > 100) {
      outcome.error =
          "run.ini:" + std::to_string(entry.line) + ": fluid.lambda = " + entry.value + " is out of range.\n";
      return outcome;
    }
    const bool is_default = parameter.name == "fluid.lambda" && parameter.value == "5";
    if (parameter.is_identity && !is_default) identity.push_back(parameter.name + "=" + parameter.value);
    reply.parameters.push_back(parameter);
  }
  std::sort(identity.begin(), identity.end());
  std::string text;
  for (const std::string& entry : identity) text += entry + "\n";
  reply.identity = digest_of(text) + digest_of(text + "again");
  return outcome;
}

}  // namespace rouleau::campaign
