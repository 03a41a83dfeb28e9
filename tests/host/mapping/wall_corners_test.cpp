// SPDX-License-Identifier: MIT
#include "host/mapping/wall_corners.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

/// The wall x = 2, seen from y = -1 to `to_m`, and the wall y = 1, seen from x = 0 to 1.8; for the
/// second, points along it count against x.
std::vector<MatchedWall> corner_with_a_gap(double to_m) {
  return {{0.0, 2.0, {{-1.0, to_m}}}, {kQuarter, 1.0, {{-1.8, 0.0}}}};
}

TEST(WallCorners, ProlongsBothWallsToWhereTheyMeet) {
  const auto walls = joined_at_corners(corner_with_a_gap(0.7), {}, {});
  EXPECT_NEAR(walls[0].pieces[0].to_m, 1.0, 1e-9);
  EXPECT_NEAR(walls[0].pieces[0].from_m, -1.0, 1e-9) << "nothing meets that end";
  EXPECT_NEAR(walls[1].pieces[0].from_m, -2.0, 1e-9);
  EXPECT_NEAR(walls[1].pieces[0].to_m, 0.0, 1e-9);
}

TEST(WallCorners, LeavesAGapThatIsTooWide) {
  const auto walls = joined_at_corners(corner_with_a_gap(0.3), {}, {});
  EXPECT_NEAR(walls[0].pieces[0].to_m, 0.3, 1e-9);
}

TEST(WallCorners, LeavesAGapThroughWhichSomethingWasHeard) {
  ScanSurfaces scan;
  scan.center_m = {1.0, 0.85};
  scan.surfaces.push_back({0.0, 2.0, 0.0, 10});
  const auto walls = joined_at_corners(corner_with_a_gap(0.7), {scan}, {});
  EXPECT_NEAR(walls[0].pieces[0].to_m, 0.7, 1e-9);
  EXPECT_NEAR(walls[1].pieces[0].from_m, -2.0, 1e-9) << "the other's gap was not looked through";
}

TEST(WallCorners, TakesTheWallItselfForNothingBehindIt) {
  ScanSurfaces scan;
  scan.center_m = {1.0, 0.85};
  scan.surfaces.push_back({0.0, 1.05, 0.0, 10});
  const auto walls = joined_at_corners(corner_with_a_gap(0.7), {scan}, {});
  EXPECT_NEAR(walls[0].pieces[0].to_m, 1.0, 1e-9);
}

TEST(WallCorners, JoinsNoWallsThatHardlyTurn) {
  std::vector<MatchedWall> walls = corner_with_a_gap(0.7);
  walls[1].normal_rad = 0.3;
  EXPECT_NEAR(joined_at_corners(walls, {}, {})[0].pieces[0].to_m, 0.7, 1e-9);
}

}  // namespace
}  // namespace echomap::mapping
