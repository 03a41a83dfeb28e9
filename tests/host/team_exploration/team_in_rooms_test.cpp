// SPDX-License-Identifier: MIT
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/offline_exploration.hpp"
#include "tests/support/offline_team.hpp"

namespace echomap::tests {
namespace {

using geometry::Pose2;

OfflineTeamRun explore_corridor_rooms(const std::vector<Pose2>& starts,
                                      const OfflineTeamSettings& settings = {},
                                      std::uint32_t seed = 2) {
  return explore_as_team(
      bundled_room("corridor_rooms"), bundled_robot("uno_2wd"), starts, seed, settings);
}

/// In the first room, and in the last.
const std::vector<Pose2> kStarts{{1.0, 2.2, -1.5}, {4.6, 2.0, -1.5}};

// Now and then two are in each other's way for longer than they save.
TEST(TeamInRooms, TwoAreMostlySoonerDoneThanOneAndDoNotTouch) {
  double alone_s = 0.0;
  double both_s = 0.0;
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const auto alone = explore_corridor_rooms({kStarts.front()}, {}, seed);
    const auto both = explore_corridor_rooms(kStarts, {}, seed);
    ASSERT_TRUE(alone.covered_s);
    ASSERT_TRUE(both.covered_s);
    alone_s += *alone.covered_s;
    both_s += *both.covered_s;
    EXPECT_EQ(both.touches, 0U);
    EXPECT_GT(both.members.front().stops, 0U);
    EXPECT_GT(both.members.back().stops, 0U);
  }
  EXPECT_LT(both_s, 0.85 * alone_s);
}

TEST(TeamInRooms, AllFinishWithTheMapOfAll) {
  OfflineTeamSettings settings;
  settings.enough_share = 2.0;
  const auto run = explore_corridor_rooms(kStarts, settings);
  EXPECT_GT(run.share, 0.9);
  for (const OfflineMember& member : run.members) {
    EXPECT_EQ(member.reason, exploration::FinishReason::kComplete);
  }
}

TEST(TeamInRooms, IsAFunctionOfItsSeed) {
  const auto once = explore_corridor_rooms(kStarts);
  const auto again = explore_corridor_rooms(kStarts);
  EXPECT_EQ(once.covered_s, again.covered_s);
  EXPECT_EQ(once.share, again.share);
}

}  // namespace
}  // namespace echomap::tests
