// SPDX-License-Identifier: BSD-3-Clause
// One rank's error becomes everybody's, with its message and code.
#include "parallel/communicator.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace rouleau {
namespace {

TEST(Communicator, ErrorOfTheLastRankIsThrownOnAllRanks) {
  const Communicator comm;
  try {
    comm.all_agree([&] {
      if (comm.rank() == comm.size() - 1) fail(Exit::io, "disk of rank {} is full", comm.rank());
    });
    FAIL() << "nothing was thrown";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), Exit::io);
    EXPECT_EQ(e.what(), fmt::format("disk of rank {} is full", comm.size() - 1));
  }
}

TEST(Communicator, LowestFailingRankIsHeard) {
  const Communicator comm;
  try {
    comm.all_agree([&] { fail(Exit::physics, "rank {}", comm.rank()); });
    FAIL() << "nothing was thrown";
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "rank 0");
  }
}

TEST(Communicator, BrokenPromiseIsAnInternalErrorEverywhere) {
  const Communicator comm;
  try {
    comm.all_agree([&] { require(comm.rank() != 0, "two is three"); });
    FAIL() << "nothing was thrown";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), Exit::internal);
    EXPECT_NE(std::string(e.what()).find("two is three"), std::string::npos);
  }
}

TEST(Communicator, SumsIntegersExactly) {
  const Communicator comm;
  const std::int64_t large = std::int64_t{1} << 55;
  EXPECT_EQ(comm.sum(large + comm.rank()), comm.size() * large + comm.size() * (comm.size() - 1) / 2);
}

TEST(Communicator, BroadcastsTextOfRankZero) {
  const Communicator comm;
  std::string text = comm.is_root() ? std::string("run.ini\0x", 9) : "something else, longer than that";
  comm.broadcast(text);
  EXPECT_EQ(text, std::string("run.ini\0x", 9));
}

}  // namespace
}  // namespace rouleau
