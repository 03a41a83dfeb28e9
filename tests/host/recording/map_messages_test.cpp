// SPDX-License-Identifier: MIT
#include "host/recording/map_messages.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_times.hpp"

namespace echomap::recording {
namespace {

using ::testing::ElementsAre;

TEST(MapMessages, TheGridRunsFromItsLowerLeftCell) {
  mapping::RasterMap map(2, 2, 0.1, {-1.0, 3.0});
  map.set({1, 0}, mapping::CellState::kFree);
  map.set({0, 1}, mapping::CellState::kOccupied);
  const auto message = map_message(0, map);
  EXPECT_THAT(message.data, ElementsAre(-1, 0, 100, -1));
  EXPECT_EQ(message.info.width, 2U);
  EXPECT_EQ(message.info.origin.position.y, 3.0);
  EXPECT_EQ(message.info.origin.orientation.w, 1.0);
}

TEST(MapMessages, ThePathLeavesOutPosesOnTheSpot) {
  std::vector<pipeline::StampedPose> trajectory;
  for (int i = 0; i < 100; ++i) {
    trajectory.push_back({tests::at_us(i), {0.0101 * i, 0.0, 0.0}});
  }
  EXPECT_EQ(path_message(0, trajectory).poses.size(), 20U);
}

TEST(MapMessages, AScanHasTheNearestEchoOfEachDegree) {
  mapping::Scan scan;
  for (const double range_m : {2.0, 1.0, 1.5}) {
    scan.push_back({{}, {0.1, 0.0, 0.0}, range_m, true});
  }
  scan.push_back({{}, {0.0, 0.0, -3.0}, std::nullopt, true});
  const auto message = scan_message(0, scan, {}, 2.3);
  ASSERT_TRUE(message);
  ASSERT_EQ(message->ranges.size(), 360U);
  EXPECT_FLOAT_EQ(message->ranges[180], 1.1F) << "straight ahead";
  EXPECT_TRUE(std::isinf(message->ranges[0]));
  EXPECT_FALSE(scan_message(0, {scan.back()}, {}, 2.3)) << "nothing was heard";
}

TEST(MapMessages, FeaturesReplaceThoseBefore) {
  mapping::SonarFeatures features;
  features.walls = {{{0.0, 0.0}, {1.0, 0.0}}};
  features.circles = {{{0.5, 0.5}, 0.1, {}}};
  const mapping::PolygonMap outline({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}});
  const auto message = features_message(0, features, outline);
  ASSERT_EQ(message.markers.size(), 4U);
  EXPECT_EQ(message.markers[0].action, ros_messages::Marker::kDeleteAll);
  EXPECT_EQ(message.markers[1].points.size(), 2U);
  EXPECT_EQ(message.markers[2].points.size(), 37U) << "a closed rim";
  EXPECT_EQ(message.markers[3].points.size(), 4U) << "a closed outline";
}

TEST(MapMessages, ThePoseKnowsHowSureItIs) {
  pipeline::Snapshot snapshot;
  snapshot.latest.T_map_robot = {1.0, 2.0, 0.0};
  snapshot.position_stddev_m = 0.1;
  const auto message = pose_message(0, snapshot);
  EXPECT_EQ(message.pose.pose.position.x, 1.0);
  EXPECT_NEAR(message.pose.covariance[0], 0.01, 1e-12);
  EXPECT_EQ(particles_message(0, {{}, {}}).poses.size(), 2U);
}

}  // namespace
}  // namespace echomap::recording
