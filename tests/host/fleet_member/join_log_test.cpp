// SPDX-License-Identifier: MIT
#include "host/fleet_member/join_log.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::fleet_member {
namespace {

using geometry::Pose2;

/// Two maps of one room, whose relative pose is known.
team_map::TeamMap joined_team() {
  team_map::TeamMap team;
  team.take(tests::ideal_record("a.0", tests::room_of_posts(), tests::one_round_m(), 0.0));
  team.take(tests::ideal_record("b.0", tests::room_of_posts(), tests::other_round_m(), 1.0));
  team.set_known_pose({"a.0", "b.0", {Pose2(2.0, 1.0, 1.0), 0.1, 0.02}});
  team.update();
  return team;
}

TEST(JoinLog, SaysSinceWhenAMapIsJoinedAndWhereItLay) {
  JoinLog log;
  log.look(1.0, "a.0", team_map::TeamMap());
  EXPECT_TRUE(log.joins().empty());
  const team_map::TeamMap team = joined_team();
  log.look(2.0, "a.0", team);
  log.look(3.0, "a.0", team);
  ASSERT_EQ(log.joins().size(), 1U);
  const LoggedJoin& join = log.joins().front();
  EXPECT_EQ(join.peer_map, "b.0");
  EXPECT_EQ(join.from_s, 2.0);
  EXPECT_FALSE(join.until_s);
  const auto relative = team.relative_pose("a.0", "b.0");
  ASSERT_TRUE(relative);
  EXPECT_EQ(join.T_own_peer.position_m(), relative->T_own_peer.position_m());
}

TEST(JoinLog, AJoinThatIsUndoneEndsAndAnotherOneBegins) {
  const team_map::TeamMap team = joined_team();
  JoinLog log;
  log.look(2.0, "a.0", team);
  log.look(5.0, "a.0", team_map::TeamMap());
  log.look(7.0, "a.0", team);
  ASSERT_EQ(log.joins().size(), 2U);
  EXPECT_EQ(log.joins()[0].until_s, 5.0);
  EXPECT_EQ(log.joins()[1].from_s, 7.0);
}

TEST(JoinLog, JoinsOfAMapEndWithIt) {
  const team_map::TeamMap team = joined_team();
  JoinLog log;
  log.look(2.0, "a.0", team);
  log.look(4.0, "a.1", team);
  ASSERT_EQ(log.joins().size(), 1U);
  EXPECT_EQ(log.joins().front().until_s, 4.0);
}

}  // namespace
}  // namespace echomap::fleet_member
