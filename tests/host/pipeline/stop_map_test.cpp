// SPDX-License-Identifier: MIT
#include "host/pipeline/stop_map.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::pipeline {
namespace {

using mapping::ScanFault;

/// All round, in a round room.
mapping::Scan round_room(const geometry::Pose2& T_odom_robot) {
  mapping::Scan scan;
  for (int bearing_deg = -180; bearing_deg < 180; bearing_deg += 6) {
    scan.push_back({T_odom_robot,
                    T_odom_robot * geometry::Pose2(0.0, 0.0, geometry::radians(bearing_deg)),
                    1.0 + (bearing_deg % 4 == 0 ? 0.006 : 0.0)});
  }
  return scan;
}

Snapshot described(const StopMap& map) {
  Snapshot snapshot;
  map.describe(snapshot);
  return snapshot;
}

class StopMapTest : public ::testing::Test {
 protected:
  static mapping::ContactMapperParams body() {
    mapping::ContactMapperParams params;
    params.body_radius_m = 0.1;
    return params;
  }

  StopMap map{mapping::SonarMapperParams{}, body()};
};

TEST_F(StopMapTest, IsEmptyAtFirst) {
  const Snapshot snapshot = described(map);
  EXPECT_TRUE(snapshot.points->points().empty());
  EXPECT_TRUE(snapshot.grid->bounds().empty());
  EXPECT_TRUE(snapshot.scans->empty());
  EXPECT_TRUE(snapshot.last_scan->empty());
}

TEST_F(StopMapTest, AStopShowsFloorThatWasNotKnown) {
  const mapping::Scan scan = round_room({});
  ASSERT_EQ(map.fault_of(scan), ScanFault::kNone);
  map.add_stop(scan, {});
  map.end_stop(scan, ScanFault::kNone);
  const Snapshot snapshot = described(map);
  EXPECT_EQ(snapshot.stops, 1U);
  EXPECT_GT(snapshot.newly_free_m2, 1.0);
  EXPECT_EQ(snapshot.scans->size(), 1U);
  EXPECT_EQ(snapshot.last_scan->size(), scan.size());
}

TEST_F(StopMapTest, AWorthlessScanIsAStopThatShowsNothing) {
  map.add_stop(round_room({}), {});
  map.end_stop(round_room({}), ScanFault::kNone);
  map.end_stop({}, ScanFault::kStuck);
  const Snapshot snapshot = described(map);
  EXPECT_EQ(snapshot.stops, 2U);
  EXPECT_EQ(snapshot.last_scan_fault, ScanFault::kStuck);
  EXPECT_EQ(snapshot.newly_free_m2, 0.0);
  EXPECT_EQ(snapshot.scans->size(), 1U);
}

TEST_F(StopMapTest, StopsAndEchoesAreWhereSlamHasThemNow) {
  map.add_echo(round_room({}).front());
  map.add_stop(round_room({}), {});
  map.replace_stops({round_room({2.0, 0.0, 0.0}), round_room({2.0, 0.0, 0.0})}, {});
  map.replace_points({});
  const Snapshot snapshot = described(map);
  EXPECT_EQ(snapshot.scans->size(), 2U);
  EXPECT_EQ(snapshot.scans->front().front().T_map_robot.x_m(), 2.0);
  EXPECT_TRUE(snapshot.points->points().empty());
}

TEST_F(StopMapTest, WhatTheRobotTouchesIsInTheGridOfTheNextSnapshot) {
  const Snapshot before = described(map);
  map.contacts().bump({}, true, true);
  EXPECT_TRUE(before.grid->bounds().empty());
  EXPECT_FALSE(described(map).grid->bounds().empty());
}

}  // namespace
}  // namespace echomap::pipeline
