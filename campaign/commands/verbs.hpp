// SPDX-License-Identifier: BSD-3-Clause
// All verbs of `rouleau`, each defined in the file of its name.
#pragma once

#include <array>

#include "commands/cli.hpp"

namespace rouleau::campaign {

extern const Verb init_verb, plan_verb, run_verb, sync_verb, retry_verb, cancel_verb;
extern const Verb status_verb, show_verb, why_verb, query_verb, export_verb, verify_verb, rebuild_verb;
extern const Verb report_verb, render_verb, engine_verb;

/// In the order in which `rouleau --help` lists them.
inline constexpr std::array<const Verb*, 16> all_verbs = {
    &init_verb,   &plan_verb,   &run_verb,    &sync_verb,  &status_verb, &show_verb,   &why_verb,     &query_verb,
    &export_verb, &report_verb, &render_verb, &retry_verb, &cancel_verb, &verify_verb, &rebuild_verb, &engine_verb};

}  // namespace rouleau::campaign
