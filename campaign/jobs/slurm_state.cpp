// SPDX-License-Identifier: BSD-3-Clause
// The tables of Slurm's states and reasons.
#include "jobs/slurm_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace rouleau::campaign {

namespace {

/// A state in which a job neither waits nor is over.
struct LivingState {
  std::string_view word;
  std::string_view words;
};

constexpr LivingState living_states[] = {
    {"RUNNING", "running"},
    {"CONFIGURING", "starting (its nodes are being made ready)"},
    {"POWER_UP_NODE", "starting (its nodes are being switched on)"},
    {"COMPLETING", "ending"},
    {"STAGE_OUT", "ending (files are being copied)"},
    {"RESIZING", "running (Slurm changes its size)"},
    {"SIGNALING", "running (Slurm signals it)"},
    {"SUSPENDED", "suspended by Slurm: it computes nothing until it is resumed"},
    {"STOPPED", "stopped by Slurm: it computes nothing until it is resumed"},
    {"UPDATE_DB", "running (Slurm writes it down)"},
};

struct EndState {
  std::string_view word;
  Cause cause;
  std::string_view words;
};

constexpr EndState end_states[] = {
    {"COMPLETED", Cause::none, "its script has ended"},   {"CANCELLED", Cause::cancelled, "cancelled"},
    {"TIMEOUT", Cause::time_limit, "time limit reached"}, {"DEADLINE", Cause::time_limit, "its deadline has passed"},
    {"OUT_OF_MEMORY", Cause::memory, "out of memory"},    {"PREEMPTED", Cause::preempted, "preempted by another job"},
    {"NODE_FAIL", Cause::node, "node failure"},           {"BOOT_FAIL", Cause::node, "its node did not boot"},
};

/// What the reason says of a job that FAILED.
constexpr EndState failure_reasons[] = {
    {"joblaunchfailure", Cause::launch, "could not be launched, or its script was killed by a signal"},
    {"prolog", Cause::launch, "the prolog of a node failed"},
    {"badconstraints", Cause::launch, "its constraints cannot be met"},
    {"invalidaccount", Cause::launch, "its account is not valid"},
    {"invalidqos", Cause::launch, "its quality of service is not valid"},
    {"nodedown", Cause::node, "node failure"},
    {"systemfailure", Cause::node, "a failure of the system"},
    {"outofmemory", Cause::memory, "out of memory"},
    {"timelimit", Cause::time_limit, "time limit reached"},
    {"deadline", Cause::time_limit, "its deadline has passed"},
};

struct HeldReason {
  std::string_view reason;
  Cause cause;
  std::string_view words;
};

constexpr HeldReason held_reasons[] = {
    {"jobhelduser", Cause::none, "by its owner"},
    {"jobheldadmin", Cause::none, "by an administrator"},
    {"launch failed requeued held", Cause::launch, "Slurm failed to launch it"},
    {"jobholdmaxrequeue", Cause::launch, "Slurm gave up after too many failed launches"},
    {"job requeued in held state", Cause::unclear, "it was put back into the queue that way"},
    {"reservationdeleted", Cause::none, "its reservation was deleted"},
};

/// Reasons that no waiting removes. Limits of a single job are found by their names' ends, below.
constexpr HeldReason impossible_reasons[] = {
    {"partitionconfig", Cause::launch, "the partition has no such nodes or allows no such job"},
    {"partitionnodelimit", Cause::launch, "more nodes than the partition allows, or its nodes are down"},
    {"partitiontimelimit", Cause::launch, "the time limit is longer than the partition's"},
    {"badconstraints", Cause::launch, "its constraints cannot be met"},
    {"dependencyneversatisfied", Cause::launch, "it depends on a job that failed"},
    {"invalidaccount", Cause::launch, "its account is not valid"},
    {"invalidqos", Cause::launch, "its quality of service is not valid"},
    {"accountnotallowed", Cause::launch, "the partition does not take its account"},
    {"qosnotallowed", Cause::launch, "the partition or account does not take its quality of service"},
    {"maxmemperlimit", Cause::launch, "more memory than the partition allows"},
    {"qosmincpunotsatisfied", Cause::launch, "fewer cores than its quality of service asks for"},
    {"deadline", Cause::launch, "it cannot end before its deadline"},
    {"accountingpolicy", Cause::launch, "the accounting rules do not allow it"},
    {"associationtimelimit", Cause::launch, "the time limit is longer than the account allows"},
    {"qostimelimit", Cause::launch, "the time limit is longer than its quality of service allows"},
};

/// Reasons to wait that deserve words; all others are named as Slurm names them.
constexpr HeldReason waiting_reasons[] = {
    {"priority", Cause::none, "for its turn"},
    {"resources", Cause::none, "for free nodes"},
    {"begintime", Cause::none, "for its start time, as after being put back into the queue"},
    {"dependency", Cause::none, "for another job"},
    {"reqnodenotavail", Cause::none, "for nodes that are down, drained or reserved"},
    {"nodes required for job are down", Cause::none, "for nodes that are down, drained or reserved"},
    {"nodedown", Cause::none, "for a node that is down"},
    {"reservation", Cause::none, "for its reservation"},
    {"licenses", Cause::none, "for licences"},
    {"partitiondown", Cause::none, "for the partition, which is down"},
    {"partitioninactive", Cause::none, "for the partition, which is inactive"},
    {"cleaning", Cause::none, "for the clearing up after its last start"},
    {"nonzeroexitcode", Cause::none, "to be started again after an exit code that was not 0"},
};

bool equal_but_for_case(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// The reason's own word in lower case: "(ReqNodeNotAvail, UnavailableNodes:n[1-2])" -> "reqnodenotavail".
std::string word_of_reason(std::string_view reason) {
  if (reason.starts_with('(')) reason.remove_prefix(1);
  std::string word(reason.substr(0, reason.find_first_of(",:()|")));
  while (!word.empty() && word.back() == ' ') word.pop_back();
  for (char& c : word) c = c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

template <class Row, std::size_t n>
const Row* find(const Row (&table)[n], std::string_view Row::*name, std::string_view word) {
  const auto found = std::find_if(std::begin(table), std::end(table), [&](const Row& row) {
    return std::equal(word.begin(), word.end(), (row.*name).begin(), (row.*name).end(), equal_but_for_case);
  });
  return found == std::end(table) ? nullptr : found;
}

/// AssocMaxCpuPerJobLimit, QOSMaxWallDurationPerJobLimit, QOSMaxMemoryMinutesPerJob, QOSMaxNodePerNode, QOSMinGRES:
/// what one job may have. AssocGrp..., ...PerUser..., ...PerAccount, ...JobsLimit depend on other jobs, and pass.
bool is_limit_of_one_job(std::string_view word) {
  const bool is_limit = word.starts_with("qos") || word.starts_with("assoc");
  const bool is_of_a_job =
      word.find("perjob") != std::string_view::npos || word.ends_with("pernode") || word.starts_with("qosmin");
  return is_limit && is_of_a_job;
}

bool says_something(std::string_view reason) {
  const std::string word = word_of_reason(reason);
  return !word.empty() && word != "none" && word != "null";
}

std::string with_reason(std::string_view words, std::string_view reason) {
  return says_something(reason) ? fmt::format("{}: {}", words, reason) : std::string(words);
}

JobView held_view(const HeldReason& row, std::string_view reason) {
  return {Phase::held, row.cause, fmt::format("held ({})", with_reason(row.words, reason))};
}

JobView pending_view(std::string_view reason) {
  const std::string word = word_of_reason(reason);
  if (const HeldReason* row = find(held_reasons, &HeldReason::reason, word)) return held_view(*row, reason);
  if (const HeldReason* row = find(impossible_reasons, &HeldReason::reason, word)) {
    return {Phase::impossible, row->cause, fmt::format("can never start ({})", with_reason(row->words, reason))};
  }
  if (is_limit_of_one_job(word)) {
    return {Phase::impossible, Cause::launch,
            fmt::format("can never start (it asks for more or less than one job may have: {})", reason)};
  }
  if (const HeldReason* row = find(waiting_reasons, &HeldReason::reason, word)) {
    return {Phase::pending, Cause::none, fmt::format("queued (waits {})", with_reason(row->words, reason))};
  }
  return {Phase::pending, Cause::none,
          says_something(reason) ? fmt::format("queued (waits: {})", reason) : std::string("queued")};
}

std::string on_nodes(std::string_view nodes) { return nodes.empty() ? "" : fmt::format(" on {}", nodes); }

JobView end_view(const EndState& row, std::string_view nodes) {
  return {Phase::ended, row.cause, fmt::format("Slurm: {}{}", row.words, on_nodes(nodes))};
}

JobView failed_view(std::string_view reason, std::string_view nodes) {
  if (const EndState* row = find(failure_reasons, &EndState::word, word_of_reason(reason)))
    return end_view(*row, nodes);
  return {Phase::ended, Cause::unclear, fmt::format("Slurm: {}{}", with_reason("failed", reason), on_nodes(nodes))};
}

/// States of jobs that Slurm has put back into the queue.
std::optional<JobView> requeued_view(std::string_view state, std::string_view reason) {
  if (state == "REQUEUE_HOLD" || state == "SPECIAL_EXIT") {
    const HeldReason* row = find(held_reasons, &HeldReason::reason, word_of_reason(reason));
    return held_view(row != nullptr ? *row : HeldReason{"", Cause::unclear, "it was put back into the queue that way"},
                     reason);
  }
  if (state == "RESV_DEL_HOLD") return held_view({"", Cause::none, "its reservation was deleted"}, reason);
  if (state == "LAUNCH_FAILED" || state == "RECONFIG_FAIL") {
    return held_view({"", Cause::launch, "Slurm failed to launch it"}, reason);
  }
  if (state == "REQUEUED" || state == "REQUEUE_FED") {
    return JobView{Phase::pending, Cause::none, with_reason("queued again", reason)};
  }
  return std::nullopt;
}

}  // namespace

JobView view_of(std::string_view state, std::string_view reason, std::string_view nodes) {
  // Some tools write "CANCELLED by 1000" and "CANCELLED+".
  const std::string_view word = state.substr(0, state.find_first_of(" +"));
  if (word == "PENDING") return pending_view(reason);
  if (word == "FAILED") return failed_view(reason, nodes);
  if (const LivingState* row = find(living_states, &LivingState::word, word)) {
    return {Phase::running, Cause::none, fmt::format("{}{}", row->words, on_nodes(nodes))};
  }
  if (const EndState* row = find(end_states, &EndState::word, word)) return end_view(*row, nodes);
  if (const std::optional<JobView> view = requeued_view(word, reason)) return *view;
  return {
      Phase::running, Cause::unclear,
      fmt::format("in the state `{}`, which rouleau does not know; it is taken for running{}", state, on_nodes(nodes))};
}

}  // namespace rouleau::campaign
