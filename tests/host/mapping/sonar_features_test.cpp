// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_features.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

/// Two stops at y = 0.
std::vector<ScanSurfaces> two_stops() { return {{{0.0, 0.0}, {}, {}}, {{1.0, 0.0}, {}, {}}}; }

/// The wall y = 2 as they see it, from x = -1 to 2.
const MatchedWall kMatchedWall{radians(90.0), 2.0, {{-2.0, 1.0}}, {{-2.0, 1.0}}};
const MatchedFeature kWallFeature{{LandmarkKind::kWall, {2.0, radians(90.0)}}, {{0, 0}, {1, 0}}};

MatchedFeature round_at(double x_m, double y_m, double radius_m) {
  return {{LandmarkKind::kPoint, {x_m, y_m}, radius_m}, {{0, 1}, {1, 1}}};
}

SonarFeatures features_of(const MatchedSurfaces& matched,
                          const std::vector<Eigen::Vector2d>& track_m = {}) {
  return sonar_features(matched, two_stops(), track_m, {});
}

TEST(SonarFeatures, HaveTheFloorToTheLeftOfAWall) {
  const auto features = features_of({{kMatchedWall}, {kWallFeature}});
  ASSERT_EQ(features.walls.size(), 1U);
  EXPECT_NEAR((features.walls[0].from_m - Eigen::Vector2d(2.0, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((features.walls[0].to_m - Eigen::Vector2d(-1.0, 2.0)).norm(), 0.0, 1e-9);
}

TEST(SonarFeatures, KnowWhichStretchesOfAWallNobodyHasHeard) {
  MatchedWall wall = kMatchedWall;
  EXPECT_TRUE(features_of({{wall}, {kWallFeature}}).unobserved.empty());
  wall.pieces = {{-2.0, -0.8}, {0.1, 1.0}};
  const auto features = features_of({{wall}, {kWallFeature}});
  ASSERT_EQ(features.walls.size(), 1U);
  ASSERT_EQ(features.unobserved.size(), 1U);
  EXPECT_NEAR((features.unobserved[0].from_m - Eigen::Vector2d(0.8, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((features.unobserved[0].to_m - Eigen::Vector2d(-0.1, 2.0)).norm(), 0.0, 1e-9);
}

TEST(SonarFeatures, NameGapsThatAreOpenAmongWhatMayBeADoor) {
  MatchedWall wall = kMatchedWall;
  wall.pieces = {{-2.0, -0.8}, {-0.1, 1.0}};
  wall.heard = wall.pieces;
  const std::vector<Eigen::Vector2d> through_it{{0.45, 1.8}, {0.45, 2.2}};
  const auto features = features_of({{wall}, {kWallFeature}}, through_it);
  ASSERT_EQ(features.walls.size(), 2U);
  ASSERT_EQ(features.unheard.size(), 1U);
  EXPECT_NEAR((features.unheard[0].from_m - Eigen::Vector2d(0.8, 2.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((features.unheard[0].to_m - Eigen::Vector2d(0.1, 2.0)).norm(), 0.0, 1e-9);
}

TEST(SonarFeatures, KnowTheRimOfACircleWhereStopsHaveLooked) {
  const auto features = features_of({{}, {round_at(0.5, 1.0, 0.2)}});
  ASSERT_EQ(features.circles.size(), 1U);
  const FittedCircle& circle = features.circles[0];
  EXPECT_EQ(circle.radius_m, 0.2);
  EXPECT_TRUE(circle.seen[FittedCircle::kSectors / 4]) << "downwards, to the stops";
  EXPECT_FALSE(circle.seen[3 * FittedCircle::kSectors / 4]);
}

TEST(SonarFeatures, LeaveOutWhatIsMirroredByAWall) {
  const auto features = features_of({{kMatchedWall}, {kWallFeature, round_at(0.5, 3.0, 0.1)}});
  EXPECT_EQ(features.walls.size(), 1U);
  EXPECT_TRUE(features.circles.empty());
}

TEST(SonarFeatures, LeaveOutWhatTheRobotHasDrivenOver) {
  const MatchedSurfaces matched{{}, {round_at(0.5, 1.0, 0.2)}};
  EXPECT_TRUE(features_of(matched, {{0.5, 0.76}}).circles.empty());
  EXPECT_EQ(features_of(matched, {{0.5, 0.7}}).circles.size(), 1U);
}

}  // namespace
}  // namespace echomap::mapping
