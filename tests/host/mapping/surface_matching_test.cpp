// SPDX-License-Identifier: MIT
#include "host/mapping/surface_matching.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

const SurfaceMatchingParams kParams;

/// A stop that has seen a wall at y = 2 with its bearing off by so much.
ScanSurfaces stop_below_wall(double x_m, double y_m, double bearing_error_deg) {
  ScanSurfaces scan{{x_m, y_m}, {}, {}};
  scan.surfaces.push_back({radians(90.0 + bearing_error_deg), 2.0 - y_m, 0.2, 18});
  return scan;
}

ScanSurfaces stop_near_post(double x_m, double y_m, double bearing_error_deg) {
  ScanSurfaces scan{{x_m, y_m}, {}, {}};
  const double bearing_rad = std::atan2(1.5 - y_m, 1.0 - x_m) + radians(bearing_error_deg);
  scan.surfaces.push_back({bearing_rad, std::hypot(1.0 - x_m, 1.5 - y_m), 0.0, 9});
  return scan;
}

TEST(MatchSurfaces, CorrectsTheBearingsOfAWallSeenFromSeveralStops) {
  const auto matched = match_surfaces({stop_below_wall(0.0, 0.0, 12.0),
                                       stop_below_wall(1.0, 0.5, -9.0),
                                       stop_below_wall(0.3, 1.0, 7.0)},
                                      kParams);
  ASSERT_EQ(matched.walls.size(), 1U);
  EXPECT_NEAR(matched.walls[0].normal_rad, radians(90.0), radians(1.0));
  EXPECT_NEAR(matched.walls[0].offset_m, 2.0, 0.02);
  for (const auto& scan : matched.scans) {
    EXPECT_NEAR(scan.surfaces[0].bearing_rad, radians(90.0), radians(1.0));
    EXPECT_NEAR(scan.center_m.y() + scan.surfaces[0].range_m, 2.0, 0.03);
  }
}

TEST(MatchSurfaces, CrossesTheRangesToAPost) {
  const auto matched = match_surfaces({stop_near_post(0.0, 0.0, 8.0),
                                       stop_near_post(2.0, 0.2, -10.0),
                                       stop_near_post(1.2, 0.1, 5.0)},
                                      kParams);
  EXPECT_TRUE(matched.walls.empty());
  ASSERT_EQ(matched.posts_m.size(), 1U);
  EXPECT_NEAR((matched.posts_m[0] - Eigen::Vector2d(1.0, 1.5)).norm(), 0.0, 0.03);
}

TEST(MatchSurfaces, BridgesAGapThatIsNoDoor) {
  // Feet at x = 0, 0.7 and 2.5, each seen 0.2 m to both sides; y differs for a baseline of ranges.
  const auto matched = match_surfaces({stop_below_wall(0.0, 0.0, 0.0),
                                       stop_below_wall(0.7, 0.4, 0.0),
                                       stop_below_wall(2.5, 0.8, 0.0)},
                                      kParams);
  ASSERT_EQ(matched.walls.size(), 1U);
  const auto& pieces = matched.walls[0].pieces;
  ASSERT_EQ(pieces.size(), 2U);
  // Along the wall, to the left of its normal, x runs backwards.
  EXPECT_NEAR(pieces[0].from_m, -2.7, 0.05);
  EXPECT_NEAR(pieces[0].to_m, -2.3, 0.05);
  EXPECT_NEAR(pieces[1].from_m, -0.9, 0.05);
  EXPECT_NEAR(pieces[1].to_m, 0.2, 0.05);
}

TEST(MatchSurfaces, LeavesAloneWhatOneStopHasSeen) {
  const auto scans = std::vector{stop_below_wall(0.0, 0.0, 4.0), ScanSurfaces{{1.0, 1.0}, {}, {}}};
  const auto matched = match_surfaces(scans, kParams);
  EXPECT_TRUE(matched.walls.empty());
  EXPECT_TRUE(matched.posts_m.empty());
  EXPECT_EQ(matched.scans[0].surfaces[0].bearing_rad, scans[0].surfaces[0].bearing_rad);
}

TEST(MatchSurfaces, DoesNotJoinWallsThatOnlyLookAlike) {
  ScanSurfaces other = stop_below_wall(1.0, 0.5, 0.0);
  other.surfaces[0].range_m += 0.3;
  // The ranges of the two stops fit a slanted wall, but no bearing does.
  other.surfaces[0].bearing_rad = radians(20.0);
  const auto matched = match_surfaces({stop_below_wall(0.0, 0.0, 0.0), other}, kParams);
  EXPECT_TRUE(matched.walls.empty());
}

TEST(MatchSurfaces, OfNothingIsNothing) {
  const auto matched = match_surfaces({}, kParams);
  EXPECT_TRUE(matched.scans.empty());
  EXPECT_TRUE(matched.walls.empty());
}

}  // namespace
}  // namespace echomap::mapping
