// SPDX-License-Identifier: MIT
#include "host/mapping/surface_matching.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "tests/host/mapping/default_params.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

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

TEST(MatchSurfaces, FitsAWallToTheRangesOfSeveralStops) {
  const auto matched = match_surfaces({stop_below_wall(0.0, 0.0, 12.0),
                                       stop_below_wall(1.0, 0.5, -9.0),
                                       stop_below_wall(0.3, 1.0, 7.0)},
                                      kMatchingParams);
  ASSERT_EQ(matched.walls.size(), 1U);
  EXPECT_NEAR(matched.walls[0].normal_rad, radians(90.0), radians(1.0));
  EXPECT_NEAR(matched.walls[0].offset_m, 2.0, 0.02);
  EXPECT_EQ(matched.features.at(0).supporters.size(), 3U);
}

/// The same with its outermost readings, which reach so far to both sides.
ScanSurfaces heard_below_wall(double x_m, double y_m, double longer_m, double half_width_deg) {
  ScanSurfaces scan = stop_below_wall(x_m, y_m, 0.0);
  SonarSurface& surface = scan.surfaces.front();
  surface.range_m += longer_m;
  surface.rightmost_rad = -radians(half_width_deg);
  surface.leftmost_rad = radians(half_width_deg);
  surface.right_m = 0.1;
  surface.left_m = 0.2;
  return scan;
}

TEST(MatchSurfaces, HearsAWallOnlyWhereItAnswersAtRightAngles) {
  auto from_aside = heard_below_wall(3.0, 0.9, 0.0, 5.0);
  from_aside.surfaces.front().bearing_rad += radians(12.0);
  const auto matched = match_surfaces({heard_below_wall(0.0, 0.0, 0.0, 17.0),
                                       heard_below_wall(1.0, 0.5, 0.0, 17.0),
                                       heard_below_wall(2.0, 0.2, 0.045, 17.0),
                                       from_aside},
                                      kMatchingParams);
  ASSERT_EQ(matched.walls.size(), 1U);
  ASSERT_EQ(matched.features.at(0).supporters.size(), 4U);
  const auto& heard = matched.walls[0].heard;
  ASSERT_EQ(heard.size(), 2U) << "one longer by 4 cm is of an end, as is one from aside";
  // To the left of the stops is where x is smaller.
  EXPECT_NEAR(heard[0].to_m - heard[0].from_m, 0.3, 1e-6);
}

TEST(MatchSurfaces, CrossesTheRangesToAPost) {
  const auto matched = match_surfaces({stop_near_post(0.0, 0.0, 8.0),
                                       stop_near_post(2.0, 0.2, -10.0),
                                       stop_near_post(1.2, 0.1, 5.0)},
                                      kMatchingParams);
  EXPECT_TRUE(matched.walls.empty());
  ASSERT_EQ(matched.features.size(), 1U);
  EXPECT_EQ(matched.features[0].feature.radius_m, 0.0);
  EXPECT_NEAR((matched.features[0].feature.value - Eigen::Vector2d(1.0, 1.5)).norm(), 0.0, 0.03);
}

TEST(MatchSurfaces, BridgesAGapThatIsNoDoor) {
  // Feet at x = 0, 0.7 and 2.5, each seen 0.2 m to both sides; y differs for a baseline of ranges.
  const auto matched = match_surfaces({stop_below_wall(0.0, 0.0, 0.0),
                                       stop_below_wall(0.7, 0.4, 0.0),
                                       stop_below_wall(2.5, 0.8, 0.0)},
                                      kMatchingParams);
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
  const auto matched = match_surfaces(scans, kMatchingParams);
  EXPECT_TRUE(matched.walls.empty());
  EXPECT_TRUE(matched.features.empty());
}

TEST(MatchSurfaces, DoesNotJoinWallsThatOnlyLookAlike) {
  ScanSurfaces other = stop_below_wall(1.0, 0.5, 0.0);
  other.surfaces[0].range_m += 0.3;
  // The ranges of the two stops fit a slanted wall, but no bearing does.
  other.surfaces[0].bearing_rad = radians(20.0);
  const auto matched = match_surfaces({stop_below_wall(0.0, 0.0, 0.0), other}, kMatchingParams);
  EXPECT_TRUE(matched.walls.empty());
}

TEST(MatchSurfaces, OfNothingIsNothing) {
  const auto matched = match_surfaces({}, kMatchingParams);
  EXPECT_TRUE(matched.features.empty());
  EXPECT_TRUE(matched.walls.empty());
}

/// Stops all around a round thing, so many degrees apart.
std::vector<ScanSurfaces> stops_around(const EchoFeature& round, double apart_deg) {
  std::vector<ScanSurfaces> scans;
  for (double bearing_deg = 0.0; bearing_deg < 360.0; bearing_deg += apart_deg) {
    const double distance_m = 1.0 + 0.002 * bearing_deg;
    ScanSurfaces scan{
        round.value + distance_m * geometry::unit_vector(radians(bearing_deg)), {}, {}};
    scan.surfaces.push_back({radians(bearing_deg - 180.0), distance_m - round.radius_m, 0.0, 10});
    scans.push_back(scan);
  }
  return scans;
}

TEST(MatchSurfaces, FindsSomethingRoundByRangesFromAllSides) {
  const EchoFeature table{LandmarkKind::kPoint, {0.4, -0.3}, 0.25};
  const auto matched = match_surfaces(stops_around(table, 40.0), kMatchingParams);
  ASSERT_EQ(matched.features.size(), 1U);
  EXPECT_EQ(matched.features[0].supporters.size(), 9U);
  EXPECT_NEAR((matched.features[0].feature.value - table.value).norm(), 0.0, 0.01);
  EXPECT_NEAR(matched.features[0].feature.radius_m, table.radius_m, 0.01);
}

TEST(MatchSurfaces, TakesAShortWallThatWasSeenFromOneSideForAWall) {
  const auto matched = match_surfaces({stop_below_wall(0.0, 0.9, 0.0),
                                       stop_below_wall(0.3, 1.1, 0.0),
                                       stop_below_wall(-0.2, 1.2, 0.0)},
                                      kMatchingParams);
  ASSERT_EQ(matched.features.size(), 1U);
  EXPECT_EQ(matched.features[0].feature.kind, LandmarkKind::kWall);
}

/// As stops come, each placed at once where it belongs.
MatchedSurfaces matched_one_by_one(const std::vector<ScanSurfaces>& scans,
                                   const SurfaceMatchingParams& params) {
  SurfaceMatcher matcher(params);
  std::vector<ScanSurfaces> so_far;
  for (const ScanSurfaces& scan : scans) {
    so_far.push_back(scan);
    matcher.update(so_far, {so_far.size() - 1});
  }
  return matcher.matched();
}

TEST(SurfaceMatcher, FindsTheSameStopByStopAsAtOnce) {
  const EchoFeature table{LandmarkKind::kPoint, {0.4, -0.3}, 0.25};
  const auto scans = stops_around(table, 6.0);
  ASSERT_GT(scans.size(), 2 * kMatchingParams.rematched_stops);
  const auto matched = matched_one_by_one(scans, kMatchingParams);
  ASSERT_EQ(matched.features.size(), 1U);
  EXPECT_EQ(matched.features[0].supporters.size(), scans.size());
  EXPECT_NEAR((matched.features[0].feature.value - table.value).norm(), 0.0, 0.01);
}

/// The first seven of 40 stops in a row have seen the post.
std::vector<ScanSurfaces> stops_past_a_post() {
  std::vector<ScanSurfaces> scans;
  for (int i = 0; i < 40; ++i) {
    scans.push_back(i < 7 ? stop_near_post(0.3 * i, 0.05 * (i % 3), 0.0)
                          : ScanSurfaces{{0.3 * i, 0.0}, {}, {}});
  }
  return scans;
}

TEST(SurfaceMatcher, KeepsAFeatureThatWasPassedLongAgo) {
  const std::vector<ScanSurfaces> scans = stops_past_a_post();
  SurfaceMatchingParams params;
  params.rematched_stops = 8;
  const auto matched = matched_one_by_one(scans, params);
  ASSERT_EQ(matched.features.size(), 1U);
  EXPECT_EQ(matched.features[0].supporters.size(), 7U);
}

TEST(SurfaceMatcher, FindsWhatIsFarFromTheLastOfSeveralNewStops) {
  const std::vector<ScanSurfaces> scans = stops_past_a_post();
  SurfaceMatchingParams params;
  params.rematched_stops = 8;
  std::vector<std::size_t> all(scans.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  SurfaceMatcher matcher(params);
  matcher.update(scans, all);
  ASSERT_EQ(matcher.matched().features.size(), 1U);
  EXPECT_EQ(matcher.matched().features[0].supporters.size(), 7U);
}

TEST(SurfaceMatcher, LetsGoOfStopsThatAreNoMore) {
  SurfaceMatcher matcher;
  matcher.update({stop_below_wall(0.0, 0.0, 0.0), stop_below_wall(1.0, 0.5, 0.0)}, {0, 1});
  matcher.update({stop_below_wall(0.0, 0.0, 0.0)}, {});
  EXPECT_TRUE(matcher.matched().features.empty());
}

TEST(SurfaceMatcher, MovesAFeatureWithItsStops) {
  std::vector<ScanSurfaces> scans{stop_below_wall(0.0, 0.0, 0.0),
                                  stop_below_wall(1.0, 0.5, 0.0),
                                  stop_below_wall(0.3, 1.0, 0.0)};
  SurfaceMatcher matcher;
  matcher.update(scans, {0, 1, 2});
  for (ScanSurfaces& scan : scans) {
    scan.center_m.y() += 0.2;
  }
  matcher.update(scans, {0, 1, 2});
  ASSERT_EQ(matcher.matched().walls.size(), 1U);
  EXPECT_NEAR(matcher.matched().walls[0].offset_m, 2.2, 0.01);
}

TEST(SurfaceMatcher, ForgetsWhatAStopThatWasFoundAnewNoLongerHolds) {
  std::vector<ScanSurfaces> scans{stop_below_wall(0.0, 0.0, 0.0), stop_below_wall(1.0, 0.5, 0.0)};
  SurfaceMatcher matcher;
  matcher.update(scans, {0, 1});
  ASSERT_EQ(matcher.matched().walls.size(), 1U);
  scans[1].surfaces.clear();
  matcher.update(scans, {1});
  EXPECT_TRUE(matcher.matched().features.empty());
}

}  // namespace
}  // namespace echomap::mapping
