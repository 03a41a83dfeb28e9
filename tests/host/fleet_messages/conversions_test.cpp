// SPDX-License-Identifier: MIT
#include "host/fleet_messages/conversions.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "host/fleet_messages/payload.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::fleet_messages {
namespace {

using geometry::Pose2;

constexpr double kPi = std::numbers::pi;
constexpr double kHalfAngleUnitRad = kPi / 65536.0;

double uniform(std::mt19937& random, double from, double to) {
  return from + (to - from) * (static_cast<double>(random()) / 4294967295.0);
}

Pose2 any_pose(std::mt19937& random) {
  return {uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, -kPi, kPi)};
}

/// A stop as the robot of the demo makes it: 158 readings of a panned sonar, the body turns once.
team_map::Submap a_stop(std::mt19937& random) {
  team_map::Submap submap;
  submap.index = 12;
  submap.begin_s = 211.377;
  submap.end_s = 229.641;
  const Pose2 T_odom_stop = any_pose(random);
  for (int i = 0; i < 158; ++i) {
    slam::StopReading reading;
    const double turned_rad = i < 79 ? 0.0 : kPi;
    reading.mark.T_odom_robot = T_odom_stop * Pose2(0.0, 0.0, turned_rad);
    reading.mark.path_m = 31.2;
    reading.mark.turn_rad = 7.1 + turned_rad;
    reading.mark.turned_rad = 21.9 + turned_rad;
    const double pan_rad = (i % 79 - 39) * 0.04;
    reading.T_robot_sonar = Pose2(0.09, 0.0, 0.0) * Pose2(0.0, 0.0, pan_rad);
    if (i % 10 != 0) {
      reading.range_m = 0.9 + 0.4 * std::sin(0.11 * i) + uniform(random, -0.01, 0.01);
    }
    submap.readings.push_back(reading);
  }
  for (int i = 0; i < 14; ++i) {
    submap.T_odom_way.push_back(T_odom_stop * Pose2(0.1 * (i - 14), 0.01 * i, 0.02 * i));
  }
  submap.contacts.push_back({T_odom_stop * Pose2(-1.4, 0, 0), true, false});
  return submap;
}

void expect_near(const Pose2& one, const Pose2& other) {
  EXPECT_NEAR(one.x_m(), other.x_m(), 0.000501);
  EXPECT_NEAR(one.y_m(), other.y_m(), 0.000501);
  EXPECT_LE(std::abs(geometry::angle_between(one.heading_rad(), other.heading_rad())),
            1.001 * kHalfAngleUnitRad);
}

void expect_near(const slam::StopReading& one, const slam::StopReading& other) {
  expect_near(one.mark.T_odom_robot, other.mark.T_odom_robot);
  expect_near(one.T_robot_sonar, other.T_robot_sonar);
  EXPECT_NEAR(one.mark.path_m, other.mark.path_m, 0.000501);
  EXPECT_NEAR(one.mark.turn_rad, other.mark.turn_rad, 1.001 * kHalfAngleUnitRad);
  EXPECT_NEAR(one.mark.turned_rad, other.mark.turned_rad, 1.001 * kHalfAngleUnitRad);
  ASSERT_EQ(one.range_m.has_value(), other.range_m.has_value());
  EXPECT_NEAR(one.range_m.value_or(0), other.range_m.value_or(0), 0.000501);
}

TEST(FleetConversions, KeepASubmapToHalfItsUnits) {
  std::mt19937 random(1);
  const team_map::Submap submap = a_stop(random);
  const auto stored = quantised(submap);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->index, submap.index);
  EXPECT_NEAR(stored->begin_s, submap.begin_s, 0.000501);
  EXPECT_NEAR(stored->end_s, submap.end_s, 0.000501);
  ASSERT_EQ(stored->readings.size(), submap.readings.size());
  for (std::size_t i = 0; i < submap.readings.size(); ++i) {
    expect_near(stored->readings[i], submap.readings[i]);
  }
  ASSERT_EQ(stored->T_odom_way.size(), submap.T_odom_way.size());
  for (std::size_t i = 0; i < submap.T_odom_way.size(); ++i) {
    expect_near(stored->T_odom_way[i], submap.T_odom_way[i]);
  }
  ASSERT_EQ(stored->contacts.size(), 1U);
  EXPECT_TRUE(stored->contacts[0].left);
  EXPECT_FALSE(stored->contacts[0].right);
}

TEST(FleetConversions, OfAStopTakeHalfAKilobyte) {
  std::mt19937 random(2);
  const auto payload = encode({{"r1", 0, 0}, to_message(a_stop(random), 0).value()});
  ASSERT_TRUE(payload);
  EXPECT_LT(payload->size(), 500U);
}

TEST(FleetConversions, ASecondTimeChangeNothing) {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const SubmapMessage once = to_message(a_stop(random), 0).value();
    EXPECT_EQ(to_message(to_submap(once), 0), once);
  }
  // Every direction that there is.
  std::vector<PoseRow> rows;
  for (int heading = 0; heading < 65536; ++heading) {
    rows.push_back({7 * heading, -3 * heading, static_cast<std::uint16_t>(heading)});
  }
  EXPECT_EQ(to_graph_message(to_poses(rows), Eigen::Matrix3d::Zero(), 0)->T_map_submaps, rows);
}

TEST(FleetConversions, RefuseWhatIsNoNumberOrTooLarge) {
  std::mt19937 random(4);
  const auto refuses = [&](const auto& change) {
    team_map::Submap submap = a_stop(random);
    change(submap);
    return !to_message(submap, 0);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(refuses([](team_map::Submap& /*submap*/) {}));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.readings[3].range_m = nan; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.readings[3].range_m = -0.1; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.readings[3].range_m = 65.535; }));
  EXPECT_FALSE(refuses([&](auto& submap) { submap.readings[3].range_m = 65.534; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.readings[3].T_robot_sonar = {33.0, 0, 0}; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.T_odom_way[0] = {nan, 0, 0}; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.T_odom_way[0] = {0, infinity, 0}; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.T_odom_way[0] = {0, 3e6, 0}; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.begin_s = -1; }));
  EXPECT_TRUE(refuses([&](auto& submap) { submap.end_s = 1e300; }));
}

TEST(FleetConversions, KeepAPoseAndItsCovariance) {
  PoseEstimate pose{{1.25, -2.5, 3.1}, Eigen::Matrix3d::Zero()};
  pose.covariance << 0.0100, 0.0030, -0.0004,  //
      0.0030, 0.0225, 0.0006,                  //
      -0.0004, 0.0006, 0.0016;
  const auto message = to_message(pose, 12.3456, 2);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->stamp_ms, 12346U);
  EXPECT_EQ(message->map_number, 2);
  const PoseEstimate back = to_pose_estimate(*message);
  expect_near(back.T_map_robot, pose.T_map_robot);
  const Eigen::Vector3d stddev = pose.covariance.diagonal().cwiseSqrt();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      EXPECT_NEAR(back.covariance(row, column),
                  pose.covariance(row, column),
                  0.02 * stddev(row) * stddev(column))
          << row << ", " << column;
    }
  }
}

TEST(FleetConversions, OfALargeCovarianceSaturate) {
  const Eigen::Matrix3d unknown = 1e12 * Eigen::Matrix3d::Identity();
  const auto message = to_message(PoseEstimate{{}, unknown}, 0.0, 0);
  ASSERT_TRUE(message);
  EXPECT_NEAR(std::sqrt(to_covariance(message->covariance)(0, 0)), 65.535, 1e-9);
  EXPECT_FALSE(to_message(
      PoseEstimate{{}, Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN())},
      0.0,
      0));
  EXPECT_FALSE(to_message(PoseEstimate{{}, -unknown}, 0.0, 0)) << "a negative variance";
}

TEST(FleetConversions, KeepClaims) {
  const std::vector<team_exploration::Claim> claims{{"r1", {1.2, -0.3}, 0.045, 2.1, "r2"},
                                                    {"r1", {5.0, 4.0}, 1e9, 0.0, "r2"}};
  const auto message = to_message(claims, 1);
  ASSERT_TRUE(message);
  const auto back = to_claims(*message, "r1");
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[0].robot, "r1");
  EXPECT_DOUBLE_EQ(back[0].at_m.x(), 1.2);
  EXPECT_DOUBLE_EQ(back[0].at_m.y(), -0.3);
  EXPECT_DOUBLE_EQ(back[0].utility, 0.045);
  EXPECT_DOUBLE_EQ(back[0].reach_m, 2.1);
  EXPECT_EQ(back[0].waits_for, "r2");
  EXPECT_NEAR(back[1].utility, 4294.967295, 1e-9) << "saturated";
  EXPECT_FALSE(to_message(std::vector<team_exploration::Claim>{{"r1", {0, 0}, -1.0, 0.0, ""}}, 1));
}

TEST(FleetConversions, KeepWhatASearchHasComeTo) {
  const SearchReport report{
      source_search::SourceVerdict::kFound, 0.962, {1.2, -0.3}, 19.5, {{{2.0, 0.5}, 3.25}}};
  const auto message = to_message(report, 3);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->map_number, 3);
  const SearchReport back = to_search_report(*message);
  EXPECT_EQ(back.verdict, source_search::SourceVerdict::kFound);
  EXPECT_DOUBLE_EQ(back.probability, 0.962);
  EXPECT_DOUBLE_EQ(back.at_m.x(), 1.2);
  EXPECT_DOUBLE_EQ(back.at_m.y(), -0.3);
  EXPECT_DOUBLE_EQ(back.strength, 19.5);
  ASSERT_EQ(back.plan.size(), 1U);
  EXPECT_DOUBLE_EQ(back.plan[0].at_m.x(), 2.0);
  EXPECT_DOUBLE_EQ(back.plan[0].dwell_s, 3.25);
  EXPECT_FALSE(to_message(SearchReport{{}, -1.0, Eigen::Vector2d::Zero(), 0.0, {}}, 0));
}

TEST(FleetConversions, KeepSourceReadings) {
  const SourceBatch batch{
      4, {{100.0004, {1.0, 2.0, 0.5}, 17.0, 3.0}, {103.25, {1.1, 2.0, 0.5}, 0.125, 0.0}}};
  const auto message = to_message(batch, 0);
  ASSERT_TRUE(message);
  const SourceBatch back = to_source_batch(*message);
  EXPECT_EQ(back.submap_index, 4U);
  ASSERT_EQ(back.readings.size(), 2U);
  EXPECT_DOUBLE_EQ(back.readings[0].stamp_s, 100.0);
  EXPECT_DOUBLE_EQ(back.readings[1].stamp_s, 103.25);
  EXPECT_DOUBLE_EQ(back.readings[0].value, 17.0);
  EXPECT_DOUBLE_EQ(back.readings[1].value, 0.125);
  EXPECT_DOUBLE_EQ(back.readings[0].dwell_s, 3.0);
  expect_near(back.readings[1].T_odom_robot, batch.readings[1].T_odom_robot);
  EXPECT_EQ(to_message(back, 0), message);
  EXPECT_FALSE(to_message(SourceBatch{}, 0)) << "nothing to send";
}

TEST(FleetConversions, KeepAnAlignment) {
  const std::vector<AlignedMap> maps{{"r1", 0, {}, {}},
                                     {"r2", 3, {4.0, -1.0, 2.0}, {{1, 2, 3}, {2, 3, -3}}}};
  const auto message = to_message(maps);
  ASSERT_TRUE(message);
  const auto back = to_aligned_maps(*message);
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[1].robot, "r2");
  EXPECT_EQ(back[1].map_number, 3);
  expect_near(back[1].T_component_map, maps[1].T_component_map);
  ASSERT_EQ(back[1].T_component_submaps.size(), 2U);
  expect_near(back[1].T_component_submaps[1], maps[1].T_component_submaps[1]);
}

TEST(FleetConversions, KeepWhatARobotIsLike) {
  const auto message = with_traits({}, {0.12, 0.2269});
  ASSERT_TRUE(message);
  EXPECT_DOUBLE_EQ(to_traits(*message).body_radius_m, 0.12);
  EXPECT_NEAR(to_traits(*message).beam_half_angle_rad, 0.2269, kHalfAngleUnitRad);
  EXPECT_FALSE(with_traits({}, {-0.1, 0.2}));
}

}  // namespace
}  // namespace echomap::fleet_messages
