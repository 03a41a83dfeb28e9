// SPDX-License-Identifier: MIT
#include "host/fleet_member/team_picture.hpp"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::fleet_member {
namespace {

using fleet::Attendance;
using geometry::Pose2;

fleet::FleetRobot robot_with(const std::string& name, team_map::RobotRecord record) {
  fleet::FleetRobot robot;
  robot.name = name;
  robot.traits.body_radius_m = 0.1;
  fleet::FleetMap map;
  map.record = std::make_shared<const team_map::RobotRecord>(std::move(record));
  robot.maps.push_back(std::move(map));
  fleet::FleetPose pose;
  pose.estimate.T_map_robot = Pose2(0.5, 0.25, 0.0);
  pose.age_s = 2.0;
  pose.speed_m_per_s = 0.2;
  robot.pose = pose;
  robot.claims = {{name, {1.0, 0.0}, 0.1, 2.0, ""}};
  return robot;
}

class TeamPictureTest : public testing::Test {
 protected:
  TeamPictureTest() {
    state.robots = {
        robot_with("a",
                   tests::ideal_record("a", tests::room_of_posts(), tests::one_round_m(), 0.0)),
        robot_with("b",
                   tests::ideal_record("b", tests::room_of_posts(), tests::other_round_m(), 1.0))};
    state.revision = 1;
  }
  void set_where_b_started() { picture.set_known_pose("a.0", "b.0", {T_a_b, 0.1, 0.02}); }

  const Pose2 T_a_b = Pose2(2.0, 1.0, 1.0);
  fleet::FleetState state;
  TeamPicture picture;
};

TEST_F(TeamPictureTest, KnowsNobodyBeforeAnythingWasReceived) {
  const auto view = picture.view({}, "a", 0);
  EXPECT_EQ(view.grid, nullptr);
  EXPECT_TRUE(view.peers.empty());
}

TEST_F(TeamPictureTest, DoesNotPlaceAPeerThatIsKnownNoBetterThanToMetres) {
  picture.take(state);
  set_where_b_started();
  state.revision = 2;
  picture.take(state);
  ASSERT_EQ(picture.peers(state, "a", 0).size(), 1U);
  state.robots[1].pose->estimate.covariance = 4.0 * Eigen::Matrix3d::Identity();
  EXPECT_TRUE(picture.peers(state, "a", 0).empty());
}

TEST_F(TeamPictureTest, TakesAStateOnce) {
  EXPECT_TRUE(picture.take(state));
  EXPECT_FALSE(picture.take(state));
}

TEST_F(TeamPictureTest, HasAPeerAndItsClaimWhereItsMapLiesInOnesOwn) {
  set_where_b_started();
  picture.take(state);
  const auto view = picture.view(state, "a", 0);
  ASSERT_NE(view.grid, nullptr);
  ASSERT_EQ(view.peers.size(), 1U);
  const auto relative = picture.relative_pose(map_name("a", 0), state.robots[1]);
  ASSERT_TRUE(relative);
  const Eigen::Vector2d peer_m = relative->T_own_peer * Eigen::Vector2d(0.5, 0.25);
  EXPECT_EQ(view.peers[0].robot, "b");
  EXPECT_NEAR((view.peers[0].T_map_robot.position_m() - peer_m).norm(), 0.0, 1e-9);
  EXPECT_EQ(view.peers[0].radius_m, 0.1);
  EXPECT_EQ(view.peers[0].age_s, 2.0);
  EXPECT_EQ(view.peers[0].speed_m_per_s, 0.2);
  ASSERT_EQ(view.claims.size(), 1U);
  EXPECT_EQ(view.claims[0].robot, "b");
  const Eigen::Vector2d claim_m = relative->T_own_peer * Eigen::Vector2d(1.0, 0.0);
  EXPECT_NEAR((view.claims[0].at_m - claim_m).norm(), 0.0, 1e-9);
}

TEST_F(TeamPictureTest, OneThatHasLeftStandsWhereItSaidGoodByeAndOneThatIsGoneNowhere) {
  set_where_b_started();
  state.robots[1].attendance = Attendance::kLeft;
  picture.take(state);
  ASSERT_EQ(picture.view(state, "a", 0).peers.size(), 1U);
  EXPECT_EQ(picture.view(state, "a", 0).peers[0].age_s, 0.0);
  EXPECT_EQ(picture.view(state, "a", 0).peers[0].speed_m_per_s, 0.0);
  state.robots[1].attendance = Attendance::kGone;
  const auto view = picture.view(state, "a", 0);
  EXPECT_TRUE(view.peers.empty());
  EXPECT_NE(view.grid, nullptr) << "what it saw stays";
}

TEST_F(TeamPictureTest, KnowsWhereAPeerIsNowWithoutAnotherLookAtTheMaps) {
  set_where_b_started();
  picture.take(state);
  const auto before = picture.peers(state, "a", 0);
  state.robots[1].pose->estimate.T_map_robot = Pose2(0.8, 0.25, 0.0);
  const auto after = picture.peers(state, "a", 0);
  ASSERT_EQ(before.size(), 1U);
  ASSERT_EQ(after.size(), 1U);
  const geometry::Pose2 moved = before[0].T_map_robot.inverse() * after[0].T_map_robot;
  EXPECT_NEAR(moved.x_m(), 0.3, 1e-9);
  EXPECT_NEAR(moved.y_m(), 0.0, 1e-9);
}

TEST_F(TeamPictureTest, APoseOfAnEarlierMapIsNone) {
  set_where_b_started();
  picture.take(state);
  state.robots[1].pose->map_number = 1;
  EXPECT_TRUE(picture.view(state, "a", 0).peers.empty());
}

TEST_F(TeamPictureTest, WhoLooksOnHasMapsJoinedThatRobotsHaveJoined) {
  const Pose2 T_true = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
  state.robots[0].alignment = {{"a", 0, Pose2(), {}}, {"b", 0, T_true, {}}};
  TeamPicture member;
  member.take(state);
  EXPECT_EQ(member.team().components().size(), 2U) << "a robot decides for itself";
  picture.take_with_joins(state);
  EXPECT_EQ(picture.team().components().size(), 1U);
}

TEST_F(TeamPictureTest, TheFirstOfThoseJoinedPublishesTheAlignment) {
  set_where_b_started();
  picture.take(state);
  const auto alignment = picture.alignment("a", 0);
  ASSERT_EQ(alignment.size(), 2U);
  EXPECT_EQ(alignment[1].robot, "b");
  EXPECT_EQ(alignment[1].map_number, 0);
  EXPECT_EQ(alignment[1].T_component_submaps.size(),
            state.robots[1].maps[0].record->submaps.size());
  EXPECT_TRUE(picture.alignment("b", 0).empty());
}

}  // namespace
}  // namespace echomap::fleet_member
