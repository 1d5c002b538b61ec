// SPDX-License-Identifier: BSD-3-Clause
// From a study to points.
#include "study/expand.hpp"

#include <gmock/gmock.h>

#include "small_checker.hpp"
#include "study/error.hpp"

namespace rouleau::campaign {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Study study_of(const std::string& rest) { return parse_study("[study]\nname = s\n" + rest, "study.ini"); }

std::string identity_of(const std::string& rest) {
  return expand(study_of(rest), small_check).candidates.at(0).point.identity;
}

TEST(CampaignExpand, SpellingOfANumberDoesNotMakeAPoint) {
  EXPECT_EQ(identity_of("[fluid]\nlambda = 4.75\n"), identity_of("[fluid]\nlambda = 4.750\n"));
  EXPECT_EQ(identity_of("[fluid]\nlambda = 4.75\n"), identity_of("[fluid]\nlambda = 19/4\n"));
  EXPECT_NE(identity_of("[fluid]\nlambda = 4.75\n"), identity_of("[fluid]\nlambda = 4.76\n"));
}

TEST(CampaignExpand, NamingADefaultDoesNotMakeAPoint) {
  EXPECT_EQ(identity_of("[fluid]\nlambda = 5\n[cell]\nradius_um = 4\n"), identity_of("[cell]\nradius_um = 4\n"));
}

TEST(CampaignExpand, EqualEntriesAreOnePointAndSaidSo) {
  const Expansion expansion = expand(study_of("[sweep]\nfluid.lambda = 4.75, 5, 4.750\n"), small_check);
  EXPECT_EQ(expansion.candidates.size(), 2U);
  EXPECT_THAT(expansion.notes,
              ElementsAre(AllOf(HasSubstr("fluid.lambda = 4.750"), HasSubstr("fluid.lambda = 4.75 are"))));
}

TEST(CampaignExpand, RefusalNamesTheStudysLineAndThePoint) {
  try {
    static_cast<void>(expand(study_of("[cell]\nradius_um = 4\n[sweep]\nfluid.lambda = 1, 101\n"), small_check));
    FAIL() << "was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::usage);
    EXPECT_STREQ(error.what(), "study.ini:6: fluid.lambda = 101 is out of range. (at fluid.lambda = 101)");
  }
}

TEST(CampaignExpand, WarningsAreSaidOnce) {
  const auto warn = [](const std::string& run_file) {
    CheckOutcome outcome = small_check(run_file);
    outcome.reply.warnings = {"run.ini:2: the time step is large."};
    return outcome;
  };
  const Expansion expansion = expand(study_of("[sweep]\nfluid.lambda = 1, 2, 3\n"), warn);
  EXPECT_EQ(expansion.notes.size(), 1U);
}

TEST(CampaignExpand, ReplicasAreDifferentPointsThatKnowTheirNumber) {
  const Expansion expansion = expand(study_of("[cell]\njitter_um = 0.1\n[sweep]\nreplicas = 3\n"), small_check);
  ASSERT_EQ(expansion.candidates.size(), 3U);
  EXPECT_EQ(expansion.candidates[2].point.replica, 3);
  EXPECT_THAT(expansion.candidates[2].point.swept, ElementsAre("cell.replica"));
}

TEST(CampaignExpand, AskedForTheSameStudyGivesTheSameBytes) {
  const Study study = study_of("[time]\nend_time_s = 1\n[sweep]\nfluid.lambda = 1:2:0.1\n");
  const Expansion first = expand(study, small_check);
  const Expansion second = expand(study, small_check);
  for (std::size_t i = 0; i < first.candidates.size(); ++i) {
    EXPECT_EQ(first.candidates[i].run_file, second.candidates[i].run_file);
  }
}

TEST(CampaignKey, IsTwelveDigitsUnlessTwoPointsShareThem) {
  const std::string identity = "0123456789abcdef0123456789abcdef";
  EXPECT_EQ(key_of(identity, {}), "0123456789ab");
  EXPECT_EQ(key_of(identity, {"0123456789ab"}), "0123456789abc");
  EXPECT_EQ(key_of(identity, {"0123456789ab", "0123456789abc"}), "0123456789abcd");
}

TEST(CampaignCheck, ReadsTheContractsObject) {
  const CheckReply reply = parse_check(
      R"({"contract": 1, "version": "0.1.0", "git": "abc123", "parameters": [{"name": "fluid.lambda", "value": "5",
          "default": "5", "kind": "identity", "given": true}, {"name": "time.end_time_s", "value": "0.2", "default": "",
          "kind": "free", "given": true}], "identity": "0123456789abcdef0123456789abcdef", "steps": 144000,
          "time_step_us": 1.39, "nodes": 20400, "triangles": 1280, "vertices": 642, "cells": 1, "end_time_s": 0.2,
          "samples": 1440, "checkpoint_bytes": 3500000, "snapshot_bytes": 0, "node_spacing_um": 0.5,
          "relative_cost_per_step": 40000.0, "warnings": ["doubtful"]})");
  EXPECT_EQ(reply.facts.steps, 144000);
  EXPECT_EQ(reply.facts.relative_cost_per_step, 40000.0);
  ASSERT_EQ(reply.parameters.size(), 2U);
  EXPECT_TRUE(reply.parameters[0].is_identity);
  EXPECT_FALSE(reply.parameters[1].is_identity);
  EXPECT_THAT(reply.warnings, ElementsAre("doubtful"));
}

TEST(CampaignCheck, RefusesAnotherContractAndNonsense) {
  EXPECT_THROW(static_cast<void>(parse_check("{\"contract\": 2}")), Error);
  EXPECT_THROW(static_cast<void>(parse_check("rouleau-solver: no")), Error);
  EXPECT_THROW(static_cast<void>(parse_check("{\"contract\": 1}")), Error);
  EXPECT_THROW(static_cast<void>(parse_check("{\"contract\": 1.5}")), Error);
}

}  // namespace
}  // namespace rouleau::campaign
