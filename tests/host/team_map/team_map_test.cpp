// SPDX-License-Identifier: MIT
#include "host/team_map/team_map.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;

class TeamMapTest : public ::testing::Test {
 protected:
  void meet() {
    team.take(b);
    team.update();
    for (std::size_t stops = 5; stops <= 8; ++stops) {
      team.take(tests::first_stops(a, stops));
      team.update();
    }
  }

  const RobotRecord a = tests::ideal_record("a", tests::room_of_posts(), tests::one_round_m(), 0.0);
  const RobotRecord b =
      tests::ideal_record("b", tests::room_of_posts(), tests::other_round_m(), 1.0);
  const Pose2 T_a_b = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
  TeamMap team;
};

TEST_F(TeamMapTest, HasEachRobotForItselfAtFirst) {
  team.take(tests::first_stops(a, 1));
  team.take(tests::first_stops(b, 1));
  EXPECT_TRUE(team.update());
  ASSERT_EQ(team.components().size(), 2U);
  EXPECT_EQ(team.components()[1].robots, std::vector<std::string>{"b"});
  EXPECT_FALSE(team.relative_pose("a", "b"));
  EXPECT_FALSE(team.relative_pose("a", "nobody"));
  EXPECT_EQ(team.component_of("nobody"), nullptr);
  EXPECT_THROW(team.merged("nobody"), std::out_of_range);
  EXPECT_THROW(team.stop_ends("nobody"), std::out_of_range);
  EXPECT_FALSE(team.update()) << "nothing was told since";
}

TEST_F(TeamMapTest, JoinsTwoThatHaveSeenTheSameRoom) {
  meet();
  ASSERT_EQ(team.components().size(), 1U);
  EXPECT_EQ(team.components()[0].robots, (std::vector<std::string>{"a", "b"}));
  const auto relative = team.relative_pose("a", "b");
  ASSERT_TRUE(relative);
  EXPECT_NEAR(relative->T_own_peer.x_m(), T_a_b.x_m(), 0.05);
  EXPECT_NEAR(relative->T_own_peer.y_m(), T_a_b.y_m(), 0.05);
  EXPECT_NEAR(relative->T_own_peer.heading_rad(), T_a_b.heading_rad(), 0.04);
  EXPECT_GT(relative->position_stddev_m, 0.0);
  const Pose2 back = team.relative_pose("b", "a")->T_own_peer * relative->T_own_peer;
  EXPECT_NEAR(back.position_m().norm(), 0.0, 1e-9);
  EXPECT_EQ(team.counts().joins, 1U);
  EXPECT_EQ(team.counts().undone, 0U);
  EXPECT_EQ(team.merged("b").robots.size(), 2U);
  EXPECT_EQ(team.merged("a").scans->size(), 16U);
  const auto ends = team.stop_ends("b");
  ASSERT_EQ(ends.size(), 8U) << "its own";
  EXPECT_NEAR((ends.back().T_map_robot.position_m() - b.T_map_submaps.back().position_m()).norm(),
              0.0,
              0.01)
      << "its map is where it stood last";
}

TEST_F(TeamMapTest, IsAFunctionOfItsInput) {
  meet();
  TeamMap other;
  other.take(b);
  other.update();
  for (std::size_t stops = 5; stops <= 8; ++stops) {
    other.take(tests::first_stops(a, stops));
    other.update();
  }
  const TeamComponent& one = team.components()[0];
  const TeamComponent& same = other.components()[0];
  ASSERT_EQ(one.robots, same.robots);
  for (std::size_t i = 0; i < one.T_team_submaps[1].size(); ++i) {
    EXPECT_EQ(one.T_team_submaps[1][i].x_m(), same.T_team_submaps[1][i].x_m());
    EXPECT_EQ(one.T_team_submaps[1][i].heading_rad(), same.T_team_submaps[1][i].heading_rad());
  }
}

TEST_F(TeamMapTest, AcceptsAKnownPose) {
  team.take(tests::first_stops(a, 2));
  team.take(tests::first_stops(b, 2));
  team.set_known_pose({"b", "a", {T_a_b.inverse(), 0.02, 0.02}});
  EXPECT_TRUE(team.update());
  ASSERT_EQ(team.components().size(), 1U);
  EXPECT_NEAR(team.relative_pose("a", "b")->T_own_peer.x_m(), T_a_b.x_m(), 0.05);
  EXPECT_NEAR(team.relative_pose("a", "b")->T_own_peer.y_m(), T_a_b.y_m(), 0.05);
}

TEST_F(TeamMapTest, JoinsAtOnceWhatRobotsOfTheTeamHaveJoined) {
  team.take(a);
  team.take(b);
  team.accept_join("b", "a", T_a_b.inverse());
  team.accept_join("a", "nobody", {});
  team.update();
  ASSERT_EQ(team.components().size(), 1U);
  EXPECT_NEAR(team.relative_pose("a", "b")->T_own_peer.x_m(), T_a_b.x_m(), 0.05);
}

/// c lies to b as b lies to a.
TEST_F(TeamMapTest, ReachesARobotByWayOfAnother) {
  RobotRecord c = b;
  c.robot = "c";
  team.take(tests::first_stops(a, 2));
  team.take(tests::first_stops(b, 2));
  team.take(tests::first_stops(c, 2));
  team.set_known_pose({"a", "b", {T_a_b, 0.02, 0.02}});
  team.set_known_pose({"b", "c", {Pose2(), 0.02, 0.02}});
  team.update();
  ASSERT_EQ(team.components().size(), 1U);
  EXPECT_NEAR(team.relative_pose("a", "c")->T_own_peer.x_m(), T_a_b.x_m(), 0.05);
}

TEST_F(TeamMapTest, ChecksTheReadingsOfMapsThatAreJoinedThroughAnother) {
  RobotRecord c = b;
  c.robot = "c";
  team.set_known_pose({"a", "b", {T_a_b, 0.02, 0.02}});
  team.set_known_pose({"b", "c", {Pose2(), 0.02, 0.02}});
  team.take(a);
  team.take(b);
  team.take(tests::first_stops(c, 1));
  team.update();
  EXPECT_EQ(team.counts().joins, 0U);
  team.take(c);
  team.update();
  EXPECT_EQ(team.counts().joins, 1U) << "a and c are where they should be";
}

TEST_F(TeamMapTest, UndoesAJoinThatACycleContradicts) {
  RobotRecord c = b;
  c.robot = "c";
  team.take(c);
  meet();
  ASSERT_EQ(team.components().size(), 1U);
  ASSERT_EQ(team.counts().undone, 0U);
  ASSERT_EQ(team.counts().joins, 2U) << "a with b and with c";
  team.set_known_pose({"b", "c", {Pose2(0.0, 0.0, 3.0), 0.02, 0.02}});
  team.update();
  EXPECT_EQ(team.counts().undone, 1U) << "what somebody tells outweighs readings";
  EXPECT_EQ(team.components().size(), 1U);
}

TEST(TeamMapParams, AreCheckedOnce) {
  TeamMapParams params;
  params.joining.max_scored_placements = 0;
  EXPECT_THROW(TeamMap{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_map
