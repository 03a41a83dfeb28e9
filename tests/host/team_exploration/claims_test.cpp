// SPDX-License-Identifier: MIT
#include "host/team_exploration/claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/team_exploration/team_rooms.hpp"

namespace echomap::team_exploration {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Claim claim_by(const std::string& robot, double utility, const std::string& waits_for = "") {
  return {robot, {1.0, 0.0}, utility, 2.0, waits_for};
}

TEST(Claims, OfTwoTheOneOfMoreUseHoldsAndOfTwoAlikeThatOfTheFirstName) {
  EXPECT_TRUE(beats(claim_by("b", 0.2), claim_by("a", 0.1)));
  EXPECT_FALSE(beats(claim_by("a", 0.1), claim_by("b", 0.2)));
  EXPECT_TRUE(beats(claim_by("a", 0.1), claim_by("b", 0.1)));
  EXPECT_FALSE(beats(claim_by("b", 0.1), claim_by("a", 0.1)));
}

TEST(Claims, OfRobotsThatAreSilentOrGoneLapse) {
  TeamView view;
  view.peers = {tests::peer_at("a", {}), tests::peer_at("b", {})};
  view.peers.back().age_s = 20.0;
  view.claims = {claim_by("a", 0.1), claim_by("b", 0.2), claim_by("gone", 0.3)};
  const TeamView alive = without_silent(view, 15.0);
  ASSERT_EQ(alive.peers.size(), 1U);
  ASSERT_EQ(alive.claims.size(), 1U);
  EXPECT_EQ(alive.claims.front().robot, "a");
  EXPECT_EQ(claim_of(alive, "b"), nullptr);
  EXPECT_EQ(claim_of(alive, "a"), &alive.claims.front());
}

TEST(Claims, DistinguishADeadlockFromAQueue) {
  TeamView view;
  view.claims = {claim_by("b", 0.1, "c"), claim_by("c", 0.1, ""), claim_by("d", 0.1, "d")};
  EXPECT_THAT(deadlock(view, "a", "b"), IsEmpty()) << "c goes on some day";
  view.claims[1].waits_for = "a";
  EXPECT_THAT(deadlock(view, "a", "b"), ElementsAre("a", "b", "c"));
  view.claims[1].waits_for = "b";
  EXPECT_THAT(deadlock(view, "a", "b"), IsEmpty()) << "of others, who have to find a way out";
  EXPECT_THAT(deadlock(view, "a", "unknown"), IsEmpty());
}

}  // namespace
}  // namespace echomap::team_exploration
