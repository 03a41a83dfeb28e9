// SPDX-License-Identifier: MIT
#include "host/mapping/feature_contradiction.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

/// A stop that has listened around one bearing alone.
ScanSurfaces stop(double x_m, double y_m, double bearing_deg, std::optional<double> range_m) {
  return {{x_m, y_m}, {}, {{radians(bearing_deg), range_m}}};
}

/// A supporter of whatever there is.
Sighting supporter(std::size_t scan, double x_m, double y_m) {
  return sighting_of({{x_m, y_m}, {{0.0, 1.0, 0.0, 9}}, {}}, scan, 0);
}

std::size_t contradictions(const std::vector<ScanSurfaces>& stops,
                           const EchoFeature& feature,
                           const std::vector<Sighting>& supporters,
                           double weight = 0.5) {
  SurfaceMatchingParams params;
  params.contradiction_weight = weight;
  const std::vector<bool> all(stops.size(), true);
  return FeatureContradiction(stops, all, params).count(feature, supporters);
}

const EchoFeature kPost{LandmarkKind::kPoint, {2.0, 0.0}};
/// y = 2, seen from below.
const EchoFeature kWallAbove{LandmarkKind::kWall, {2.0, radians(90.0)}};

TEST(FeatureContradiction, CountsStopsThatHearPastAPost) {
  EXPECT_EQ(contradictions({stop(0.0, 0.0, 0.0, 2.5)}, kPost, {}), 1U);
  EXPECT_EQ(contradictions({stop(0.0, 0.0, 0.0, std::nullopt)}, kPost, {}), 1U);
}

TEST(FeatureContradiction, CountsNoStopThatHearsThePostOrSomethingNearer) {
  EXPECT_EQ(contradictions({stop(0.0, 0.0, 0.0, 2.1)}, kPost, {}), 0U);
  EXPECT_EQ(contradictions({stop(0.0, 0.0, 0.0, 1.0)}, kPost, {}), 0U);
}

TEST(FeatureContradiction, CountsNoStopThatHasNotListenedThere) {
  EXPECT_EQ(contradictions({stop(0.0, 0.0, 30.0, std::nullopt)}, kPost, {}), 0U);
}

TEST(FeatureContradiction, CountsNoStopFromWhichSilenceIsUsual) {
  EXPECT_EQ(contradictions({stop(-2.0, 0.0, 0.0, std::nullopt)}, kPost, {}), 0U);
}

TEST(FeatureContradiction, CountsNoSupporter) {
  EXPECT_EQ(contradictions({stop(0.0, 0.0, 0.0, 2.5)}, kPost, {supporter(0, 0.0, 0.0)}), 0U);
}

TEST(FeatureContradiction, AsksOfAWallOnlyStopsWithTheirFootBetweenThoseThatHeardIt) {
  const std::vector<Sighting> feet{supporter(1, 0.0, 0.0), supporter(2, 1.0, 0.0)};
  EXPECT_EQ(contradictions({stop(0.5, 0.0, 90.0, std::nullopt)}, kWallAbove, feet), 1U);
  EXPECT_EQ(contradictions({stop(1.5, 0.0, 90.0, std::nullopt)}, kWallAbove, feet), 0U);
}

TEST(FeatureContradiction, LeavesRoomForADoorBetweenTwoFeet) {
  const std::vector<Sighting> feet{supporter(1, 0.0, 0.0), supporter(2, 2.0, 0.0)};
  EXPECT_EQ(contradictions({stop(1.0, 0.0, 90.0, std::nullopt)}, kWallAbove, feet), 0U);
}

TEST(FeatureContradiction, HearsNobodyWithoutWeight) {
  EXPECT_EQ(contradictions({stop(0.0, 0.0, 0.0, 2.5)}, kPost, {}, 0.0), 0U);
}

}  // namespace
}  // namespace echomap::mapping
