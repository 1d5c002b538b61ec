// SPDX-License-Identifier: BSD-3-Clause
// Reading the solver's check.
#include "study/check.hpp"

#include <nlohmann/json.hpp>

#include "study/error.hpp"

namespace rouleau::campaign {

namespace {

constexpr int contract = 1;

}  // namespace

CheckReply parse_check(const std::string& json) {
  try {
    const nlohmann::json object = nlohmann::json::parse(json);
    if (const int theirs = object.at("contract").get<int>(); theirs != contract) {
      fail(Exit::failed,
           "rouleau-solver check speaks contract {}, this rouleau contract {}. Use programs of one release, or set "
           "ROULEAU_SOLVER.",
           theirs, contract);
    }
    CheckReply reply;
    object.at("identity").get_to(reply.identity);
    object.at("version").get_to(reply.version);
    object.at("git").get_to(reply.git);
    RunFacts& facts = reply.facts;
    object.at("steps").get_to(facts.steps);
    object.at("time_step_us").get_to(facts.time_step_us);
    object.at("end_time_s").get_to(facts.end_time_s);
    object.at("nodes").get_to(facts.nodes);
    object.at("samples").get_to(facts.samples);
    object.at("checkpoint_bytes").get_to(facts.checkpoint_bytes);
    object.at("snapshot_bytes").get_to(facts.snapshot_bytes);
    object.at("relative_cost_per_step").get_to(facts.relative_cost_per_step);
    object.at("warnings").get_to(reply.warnings);
    for (const auto& entry : object.at("parameters")) {
      reply.parameters.push_back(
          {entry.at("name"), entry.at("value"), entry.at("kind") == "identity", entry.at("given")});
    }
    if (reply.identity.size() != 32) {
      fail(Exit::failed, "rouleau-solver check: identity `{}` is not 32 hex digits. Use programs of one release.",
           reply.identity);
    }
    return reply;
  } catch (const nlohmann::json::exception& error) {
    fail(Exit::failed, "rouleau-solver check: its answer cannot be read ({}). Use programs of one release.",
         error.what());
  }
}

}  // namespace rouleau::campaign
