// SPDX-License-Identifier: MIT
#include "host/mapping/stop_floor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/host/mapping/profile_at.hpp"

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

ScanSurfaces heard_everywhere(double range_m) {
  ScanSurfaces scan = posts_around();
  for (sensors::Beam& look : scan.looks) {
    look.range_m = range_m;
  }
  return scan;
}

/// x = 2, from y = -1 to 1, seen from the origin.
const SonarFeatures kWallFeatures{{{{2.0, -1.0}, {2.0, 1.0}}}, {}};

FloorReach reach_of(const ScanSurfaces& scan, const SonarFeatures& features) {
  return StopFloor(scan, {}, {}).reach(features);
}

TEST(StopFloor, EndsShortOfTheOutlineWhereNothingElseIsKnown) {
  const FloorReach reach = reach_of(posts_around(), {});
  EXPECT_NEAR(at(reach.heard_m, 90.0), 1.0 - StopFloorParams{}.margin_m, 5e-3);
  EXPECT_NEAR(reach.silent_m.max_m(), 1.0 - StopFloorParams{}.margin_m, 5e-3);
}

TEST(StopFloor, EndsBeforeTheNearestEchoThatNobodyElseExplains) {
  const FloorReach reach = reach_of(heard_everywhere(0.7), {});
  EXPECT_NEAR(at(reach.heard_m, 90.0), 0.7 - StopFloorParams{}.echo_margin_m, 1e-9);
}

TEST(StopFloor, ReachesByAnEchoToTheWallThatItCameFrom) {
  const FloorReach reach = reach_of(heard_everywhere(1.97), kWallFeatures);
  EXPECT_NEAR(at(reach.heard_m, 0.0), 2.0, 1e-3);
  EXPECT_NEAR(at(reach.silent_m, 0.0), 2.0, 1e-3);
}

TEST(StopFloor, ReachesBySilenceAloneToAWallBeforeWhichNothingWasHeard) {
  const FloorReach reach = reach_of(posts_around(), kWallFeatures);
  EXPECT_NEAR(at(reach.silent_m, 0.0), 2.0, 1e-3);
  EXPECT_NEAR(at(reach.silent_m, 20.0), 2.0 / std::cos(radians(20.0)), 0.02);
  EXPECT_LT(at(reach.heard_m, 0.0), 1.0);
  EXPECT_LT(at(reach.silent_m, 40.0), 1.0) << "beside the wall";
}

TEST(StopFloor, EndsBeforeTheWallWhereSomethingNearerWasHeard) {
  EXPECT_LT(at(reach_of(heard_everywhere(1.0), kWallFeatures).silent_m, 0.0), 1.0);
}

TEST(StopFloor, SaysNothingOfAWallTowardsWhichNobodyListened) {
  ScanSurfaces scan = posts_around();
  scan.looks.clear();
  EXPECT_EQ(at(reach_of(scan, kWallFeatures).silent_m, 0.0), 0.0);
}

TEST(StopFloor, EndsAtAWallThatStandsInsideOfTheOutline) {
  const SonarFeatures near{{{{0.5, -1.0}, {0.5, 1.0}}}, {}};
  EXPECT_LE(at(reach_of(posts_around(), near).silent_m, 0.0), 0.5 + 1e-3);
}

TEST(StopFloor, DoesNotReachToTheBackOfAWall) {
  const SonarFeatures turned{{{{2.0, 1.0}, {2.0, -1.0}}}, {}};
  EXPECT_LT(at(reach_of(posts_around(), turned).silent_m, 0.0), 1.0);
  SonarFeatures thin = turned;
  thin.walls.push_back({{2.05, -1.0}, {2.05, 1.0}});
  EXPECT_NEAR(at(reach_of(posts_around(), thin).silent_m, 0.0), 2.0, 1e-3)
      << "two faces of a thin wall may seem to be swapped";
}

TEST(StopFloor, ReachesToTheNearSideOfACircle) {
  const SonarFeatures round{{}, {{{0.0, 2.0}, 0.3, {}}}};
  const FloorReach reach = reach_of(posts_around(), round);
  EXPECT_NEAR(at(reach.silent_m, 90.0), 1.7, 1e-3);
  EXPECT_LT(at(reach.silent_m, 80.0), 1.0);
}

TEST(StopFloor, EndsWhereTheSonarHearsNothingAnyMore) {
  StopFloorParams short_sighted;
  short_sighted.max_range_m = 2.05;
  const StopFloor floor(posts_around(), {}, short_sighted);
  EXPECT_NEAR(at(floor.reach(kWallFeatures).silent_m, 20.0), 2.05, 1e-9);
  short_sighted.max_range_m = 1.5;
  const StopFloor shorter(posts_around(), {}, short_sighted);
  EXPECT_LT(at(shorter.reach(kWallFeatures).silent_m, 0.0), 1.0)
      << "it could not hear what is before a wall";
}

/// Silence from one bearing to another; elsewhere nobody has listened.
ScanSurfaces silence(int from_deg, int to_deg) {
  ScanSurfaces scan;
  for (int bearing_deg = from_deg; bearing_deg < to_deg; bearing_deg += 6) {
    scan.looks.push_back({radians(bearing_deg), std::nullopt});
  }
  return scan;
}

TEST(StopFloor, ReachesSomeWayIntoAHallWhereNothingIsHeardAllRound) {
  const FloorReach reach = reach_of(silence(-180, 180), {});
  const double open_m = StopFloorParams{}.open_share * StopFloorParams{}.max_range_m;
  for (const double bearing_deg : {-170.0, -90.0, 0.0, 45.0}) {
    EXPECT_NEAR(at(reach.heard_m, bearing_deg), open_m, 1e-9);
    EXPECT_NEAR(at(reach.silent_m, bearing_deg), open_m, 1e-9);
  }
}

TEST(StopFloor, ReachesIntoAHallARightAngleOffWhatItHears) {
  ScanSurfaces scan = silence(-180, 180);
  scan.surfaces.push_back({radians(180.0), 3.0, 0.0, 10});
  const FloorReach reach = reach_of(scan, {});
  EXPECT_GT(at(reach.heard_m, 0.0), 1.0);
  EXPECT_GT(at(reach.heard_m, 85.0), 1.0);
  EXPECT_EQ(at(reach.heard_m, 95.0), 0.0) << "a wall at a slant is silent, too";
}

TEST(StopFloor, ReachesIntoAHallOnlyWhereAllOfThatSideWasListenedTo) {
  const FloorReach reach = reach_of(silence(-95, 96), {});
  EXPECT_GT(at(reach.heard_m, 0.0), 1.0);
  EXPECT_EQ(at(reach.heard_m, 30.0), 0.0) << "nobody has listened at 120 degrees";
}

TEST(StopFloor, EndsInAHallBeforeALoneEcho) {
  ScanSurfaces scan = silence(-180, 180);
  scan.looks.push_back({0.0, 1.2});
  const FloorReach reach = reach_of(scan, {});
  EXPECT_NEAR(at(reach.heard_m, 0.0), 1.2 - StopFloorParams{}.echo_margin_m, 1e-9);
  EXPECT_GT(at(reach.heard_m, 20.0), 1.5);
}

TEST(StopFloor, IsNothingWithoutAnySurface) { EXPECT_EQ(reach_of({}, {}).silent_m.max_m(), 0.0); }

}  // namespace
}  // namespace echomap::mapping
