// SPDX-License-Identifier: MIT
#include "host/apps/fleet_course.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::apps {
namespace {

using fleet_member::LoggedJoin;
using geometry::Pose2;

/// Ten cells of floor; from each stop on the map has those below that number, or from it on.
std::vector<bool> below(int cells) {
  std::vector<bool> seen(10, false);
  std::fill_n(seen.begin(), cells, true);
  return seen;
}
std::vector<bool> from(int cell) {
  std::vector<bool> seen(10, true);
  std::fill_n(seen.begin(), cell, false);
  return seen;
}

/// b began 2 m ahead of a.
std::vector<ScoredMap> two_maps() {
  return {{"a.0",
           Pose2(),
           0.02,
           {1.0, 0.0},
           {2.0, 0.0},
           {10.0, 20.0, 30.0},
           {below(2), below(4), below(6)}},
          {"b.0",
           Pose2(2.0, 0.0, 0.0),
           0.03,
           {1.0, 0.0},
           {2.0, 0.0},
           {12.0, 25.0},
           {from(8), from(5)}}};
}

MemberReport member(const std::string& robot, const std::vector<LoggedJoin>& joins = {}) {
  MemberReport member;
  member.robot = robot;
  member.joins = joins;
  return member;
}

LoggedJoin join_of_b(double from_s, std::optional<double> until_s = std::nullopt) {
  return {"a.0", "b.0", from_s, until_s, Pose2(2.05, 0.0, 0.02)};
}

TEST(FleetCourse, FloorCountsOnceTheMapsThatHaveItAreOne) {
  EXPECT_FALSE(score_course(two_maps(), {member("a"), member("b")}).floor_90_s);
  EXPECT_EQ(score_course(two_maps(), {member("a"), member("b")}).floor_seen, 0.6);
  const auto early = score_course(two_maps(), {member("a", {join_of_b(15.0)}), member("b")});
  EXPECT_EQ(early.joined_s, 15.0);
  EXPECT_EQ(early.floor_90_s, 25.0) << "four tenths and the five of b";
  EXPECT_EQ(early.floor_seen, 1.0);
  const auto late = score_course(two_maps(), {member("a", {join_of_b(40.0)}), member("b")});
  EXPECT_EQ(late.floor_90_s, 40.0) << "the join is what shows it";
}

TEST(FleetCourse, AJoinThatWasUndoneCountsWhileItHeld) {
  const auto course = score_course(two_maps(), {member("a", {join_of_b(11.0, 13.0)}), member("b")});
  EXPECT_FALSE(course.joined_s);
  EXPECT_FALSE(course.floor_90_s);
  EXPECT_EQ(course.floor_seen, 0.6);
}

TEST(FleetCourse, TheLastMemberThatIsJoinedIsWhenAllAre) {
  auto maps = two_maps();
  maps.push_back({"c.0", Pose2(), 0.0, {0.0, 0.0}, {0.0, 0.0}, {5.0}, {below(1)}});
  const LoggedJoin c{"a.0", "c.0", 50.0, std::nullopt, Pose2()};
  const auto of = [&](const std::vector<LoggedJoin>& joins) {
    return score_course(maps, {member("a", joins), member("b"), member("c")}).joined_s;
  };
  EXPECT_FALSE(of({join_of_b(15.0)}));
  EXPECT_EQ(of({join_of_b(15.0), c}), 50.0);
}

TEST(FleetCourse, AMapThatCameLaterIsJoinedByItself) {
  auto maps = two_maps();
  maps.push_back({"b.1", Pose2(), 0.0, {0.0, 0.0}, {0.0, 0.0}, {35.0}, {below(1)}});
  EXPECT_FALSE(score_course(maps, {member("a", {join_of_b(15.0)}), member("b")}).joined_s);
}

TEST(FleetCourse, JoinsThatPlaceAMapElsewhereAreWrong) {
  LoggedJoin off = join_of_b(15.0, 20.0);
  off.T_own_peer = Pose2(2.6, 0.0, 0.0);
  LoggedJoin turned = join_of_b(22.0);
  turned.T_own_peer = Pose2(2.0, 0.0, 0.4);
  const auto course =
      score_course(two_maps(), {member("a", {off, turned}), member("b", {join_of_b(30.0)})});
  EXPECT_EQ(course.wrong_joins, 2U);
  EXPECT_EQ(course.wrong_joins_left, 1U);
}

TEST(FleetCourse, ARelativePoseIsOffByWhereItPutsThePeersLastStop) {
  const auto maps = two_maps();
  const auto error = relative_pose_error(Pose2(2.0, 0.0, -0.1), maps[0], maps[1]);
  EXPECT_NEAR(error.position_m, 4.0 * std::sin(0.05), 1e-9);
  EXPECT_NEAR(error.heading_rad, 0.1, 1e-9);
  EXPECT_NEAR(error.own_errors_m, 0.05, 1e-12);
  EXPECT_EQ(find_map(maps, "c.0"), nullptr);
}

/// A robot of which the truth knows where each stop ended.
struct KnownRobot {
  team_map::RobotRecord record =
      tests::ideal_record("a.0", tests::room_of_posts(), tests::one_round_m(), 0.3);
  Pose2 T_world_map{1.0, 2.0, 0.5};
  std::vector<evaluation::TruePose> truth;

  KnownRobot() {
    for (std::size_t i = 0; i < record.submaps.size(); ++i) {
      truth.push_back(
          {time::robot_time(record.submaps[i].end_s), T_world_map * record.T_map_submaps[i]});
    }
  }
};

TEST(FleetCourse, AMapLiesWhereAllItsStopsAreNearestToTheTruth) {
  const KnownRobot robot;
  const std::vector<Eigen::Vector2d> floor_m{
      robot.T_world_map * (robot.record.T_map_submaps.back() * Eigen::Vector2d(0.02, 0.0)),
      {50.0, 50.0}};
  const auto scored = score_map(robot.record, robot.truth, floor_m);
  ASSERT_TRUE(scored);
  EXPECT_NEAR(
      (scored->T_world_map.position_m() - robot.T_world_map.position_m()).norm(), 0.0, 1e-6);
  EXPECT_NEAR(scored->T_world_map.heading_rad(), 0.5, 1e-6);
  EXPECT_NEAR(scored->own_error_m, 0.0, 1e-6);
  ASSERT_EQ(scored->seen.size(), robot.record.submaps.size());
  EXPECT_EQ(scored->seen.back(), std::vector<bool>({true, false}));
  EXPECT_EQ(scored->last_m, robot.record.T_map_submaps.back().position_m());
  EXPECT_EQ(scored->stop_s.back(), robot.record.submaps.back().end_s);
  EXPECT_FALSE(score_map(robot.record, {}, floor_m)) << "no truth";
  EXPECT_FALSE(score_map({}, robot.truth, floor_m)) << "no stop";
}

/// A first stop that is turned by 10 degrees on the map turns the frame, but not the map.
TEST(FleetCourse, TheFirstStopAloneDoesNotPlaceAMap) {
  KnownRobot robot;
  Pose2& first = robot.record.T_map_submaps.front();
  first = Pose2(first.x_m(), first.y_m(), first.heading_rad() + 0.17);
  const auto scored = score_map(robot.record, robot.truth, {});
  ASSERT_TRUE(scored);
  EXPECT_NEAR(scored->T_world_map.heading_rad(), 0.5, 1e-6);
}

}  // namespace
}  // namespace echomap::apps
