// SPDX-License-Identifier: MIT
#include "host/mapping/feature_support.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "tests/host/mapping/default_params.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

const EchoFeature kWallAhead{LandmarkKind::kWall, {2.0, 0.0}};
const EchoFeature kRound{LandmarkKind::kPoint, {2.0, 1.0}, 0.3};

Sighting sighting(const Eigen::Vector2d& from_m, double bearing_rad, double range_m) {
  ScanSurfaces scan{from_m, {{bearing_rad, range_m, 0.0, 10}}, {}};
  return sighting_of(scan, 0, 0);
}

TEST(SightingOf, HasItsEchoOnItsBearing) {
  EXPECT_NEAR((sighting({1.0, 1.0}, radians(90.0), 0.5).echo_m - Eigen::Vector2d(1.0, 1.5)).norm(),
              0.0,
              1e-12);
}

TEST(FeatureGauge, MeasuresHowFarARangeIsOff) {
  EXPECT_NEAR(
      FeatureGauge(kWallAhead, kMatchingParams).misfit_m(sighting({0.5, 3.0}, 0.1, 1.47)).value(),
      0.03,
      1e-12);
  const double range_m = std::hypot(2.0, 1.0) - 0.3;
  EXPECT_NEAR(FeatureGauge(kRound, kMatchingParams)
                  .misfit_m(sighting({0.0, 0.0}, std::atan2(1.0, 2.0), range_m + 0.02))
                  .value(),
              0.02,
              1e-12);
}

TEST(FeatureGauge, RefusesAnotherRangeAndAnotherDirection) {
  const FeatureGauge wall(kWallAhead, kMatchingParams);
  EXPECT_FALSE(wall.misfit_m(sighting({0.5, 3.0}, 0.0, 1.3)));
  EXPECT_FALSE(wall.misfit_m(sighting({0.5, 3.0}, 1.0, 1.5)));
}

TEST(FeatureGauge, CountsManyReadingsOfTheRightKindMost) {
  Sighting one = sighting({0.0, 0.0}, 0.0, 2.0);
  one.surface.half_length_m = 0.3;
  const FeatureGauge wall(kWallAhead, kMatchingParams);
  EXPECT_EQ(wall.weight(one, 0.0), 1.0);
  one.surface.readings = 5;
  EXPECT_EQ(wall.weight(one, 0.0), 0.5);
  one.surface.half_length_m = 0.0;
  EXPECT_EQ(wall.weight(one, 0.0), 0.5 * kMatchingParams.other_kind_weight);
}

TEST(SeenOverRad, IsTheAngleBetweenTheOutermostViews) {
  const Eigen::Vector2d point_m(0.0, 0.0);
  EXPECT_NEAR(seen_over_rad(point_m,
                            {sighting({1.0, 0.0}, 0.0, 1.0),
                             sighting({0.0, 2.0}, 0.0, 1.0),
                             sighting({1.0, -1.0}, 0.0, 1.0)}),
              radians(135.0),
              1e-9);
}

TEST(Fitted, FindsMiddleAndRadiusOfSomethingRound) {
  std::vector<Sighting> sightings;
  for (const double bearing_deg : {0.0, 80.0, 150.0, 230.0, 300.0}) {
    const Eigen::Vector2d from_m = kRound.value + 1.1 * geometry::unit_vector(radians(bearing_deg));
    sightings.push_back(sighting(from_m, radians(bearing_deg - 180.0), 0.8));
  }
  EchoFeature start = kRound;
  start.value += Eigen::Vector2d(0.04, -0.03);
  start.radius_m = 0.26;
  const EchoFeature found = fitted(start, sightings, kMatchingParams);
  EXPECT_NEAR((found.value - kRound.value).norm(), 0.0, 1e-3);
  EXPECT_NEAR(found.radius_m, kRound.radius_m, 0.005);
}

TEST(Fitted, LeavesAPostAPost) {
  const EchoFeature post{LandmarkKind::kPoint, {2.0, 1.0}};
  const EchoFeature found = fitted(post,
                                   {sighting({2.0, 0.0}, radians(90.0), 0.9),
                                    sighting({1.0, 1.0}, 0.0, 0.9),
                                    sighting({2.0, 2.0}, radians(-90.0), 0.9)},
                                   kMatchingParams);
  EXPECT_EQ(found.radius_m, 0.0);
}

}  // namespace
}  // namespace echomap::mapping
