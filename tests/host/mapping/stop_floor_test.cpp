// SPDX-License-Identifier: MIT
#include "host/mapping/stop_floor.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

/// From the origin: posts at 1 m, every 30 degrees all around, and silence everywhere.
ScanSurfaces posts_around() {
  ScanSurfaces scan;
  for (int bearing_deg = -180; bearing_deg < 180; bearing_deg += 30) {
    scan.surfaces.push_back({radians(bearing_deg), 1.0, 0.0, 10});
  }
  for (int bearing_deg = -180; bearing_deg < 180; bearing_deg += 6) {
    scan.looks.push_back({radians(bearing_deg), std::nullopt});
  }
  return scan;
}

/// x = 2, from y = -1 to 1.
const std::vector<MatchedWall> kWall{{0.0, 2.0, {{-1.0, 1.0}}}};

StopFloor floor_of(const ScanSurfaces& scan, const std::vector<MatchedWall>& walls) {
  return {scan, walls, {}, {}};
}

TEST(StopFloor, EndsShortOfTheOutlineWhereNoWallIsKnown) {
  const StopFloor floor = floor_of(posts_around(), {});
  EXPECT_NEAR(floor.reach_m(radians(90.0)), 1.0 - StopFloorParams{}.margin_m, 5e-3);
  EXPECT_NEAR(floor.max_m(), 1.0 - StopFloorParams{}.margin_m, 5e-3);
}

TEST(StopFloor, ReachesToAWallBeforeWhichNothingWasHeard) {
  const StopFloor floor = floor_of(posts_around(), kWall);
  EXPECT_NEAR(floor.reach_m(0.0), 2.0, 1e-3);
  EXPECT_NEAR(floor.reach_m(radians(20.0)), 2.0 / std::cos(radians(20.0)), 0.01);
  EXPECT_LT(floor.reach_m(radians(40.0)), 1.0) << "beside the wall";
}

TEST(StopFloor, EndsBeforeTheWallWhereSomethingNearerWasHeard) {
  ScanSurfaces scan = posts_around();
  for (sensors::Beam& look : scan.looks) {
    look.range_m = 1.0;
  }
  EXPECT_LT(floor_of(scan, kWall).reach_m(0.0), 1.0);
  for (sensors::Beam& look : scan.looks) {
    look.range_m = 1.95;
  }
  EXPECT_NEAR(floor_of(scan, kWall).reach_m(0.0), 2.0, 1e-3);
}

TEST(StopFloor, SaysNothingOfAWallTowardsWhichNobodyListened) {
  ScanSurfaces scan = posts_around();
  scan.looks.clear();
  EXPECT_LT(floor_of(scan, kWall).reach_m(0.0), 1.0);
}

TEST(StopFloor, EndsAtAWallThatStandsInsideOfTheOutline) {
  std::vector<MatchedWall> near = kWall;
  near[0].offset_m = 0.5;
  EXPECT_LE(floor_of(posts_around(), near).reach_m(0.0), 0.5 + 1e-3);
}

TEST(StopFloor, IsNothingWithoutAnySurface) {
  EXPECT_EQ(floor_of({}, {}).reach_m(0.0), 0.0);
  EXPECT_EQ(floor_of({}, {}).max_m(), 0.0);
}

}  // namespace
}  // namespace echomap::mapping
