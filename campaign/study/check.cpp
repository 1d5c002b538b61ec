// SPDX-License-Identifier: BSD-3-Clause
// Reading the solver's check.
#include "study/check.hpp"

#include "study/error.hpp"
#include "study/record.hpp"

namespace rouleau::campaign {

namespace {

constexpr int contract = 1;

[[noreturn]] void refuse(const char* why) {
  fail(Exit::failed, "rouleau-solver check: its answer cannot be read ({}). Use programs of one release.", why);
}

}  // namespace

CheckReply parse_check(const std::string& json) {
  try {
    const nlohmann::json object = parse_record(json);
    if (const int theirs = strictly<int>(object.at("contract")); theirs != contract) {
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
    facts.steps = strictly<decltype(facts.steps)>(object.at("steps"));
    facts.time_step_us = strictly<decltype(facts.time_step_us)>(object.at("time_step_us"));
    facts.end_time_s = strictly<decltype(facts.end_time_s)>(object.at("end_time_s"));
    facts.nodes = strictly<decltype(facts.nodes)>(object.at("nodes"));
    facts.samples = strictly<decltype(facts.samples)>(object.at("samples"));
    facts.checkpoint_bytes = strictly<decltype(facts.checkpoint_bytes)>(object.at("checkpoint_bytes"));
    facts.snapshot_bytes = strictly<decltype(facts.snapshot_bytes)>(object.at("snapshot_bytes"));
    facts.relative_cost_per_step =
        strictly<decltype(facts.relative_cost_per_step)>(object.at("relative_cost_per_step"));
    object.at("warnings").get_to(reply.warnings);
    for (const auto& entry : object.at("parameters")) {
      reply.parameters.push_back(
          {entry.at("name"), entry.at("value"), entry.at("kind") == "identity", entry.at("given")});
    }
    // Directories are named by it.
    if (reply.identity.size() != 32 || !is_hex(reply.identity)) {
      fail(Exit::failed, "rouleau-solver check: identity `{}` is not 32 hex digits. Use programs of one release.",
           reply.identity);
    }
    return reply;
  } catch (const nlohmann::json::exception& error) {
    refuse(error.what());
  } catch (const Damage& damage) {
    refuse(damage.what());
  }
}

}  // namespace rouleau::campaign
