// SPDX-License-Identifier: MIT
#include "host/slam/echo_feature.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/slam/heard_room.hpp"

namespace echomap::slam {
namespace {

constexpr double kSlantRad = 0.26;

const EchoFeature wall_ahead{LandmarkKind::kWall, {1.5, 0.2}};
const EchoFeature leg{LandmarkKind::kPoint, {1.0, 0.3}};

Echo cone(double x_m, double y_m, double axis_rad) {
  return {{x_m, y_m}, axis_rad, 0.0, kHalfOpeningRad};
}

Echo heard(const EchoFeature& feature, Echo echo) {
  echo.range_m = echo_of(feature, echo, kSlantRad).value().range_m;
  return echo;
}

TEST(EchoFeature, AWallAnswersAlittleOutsideOfTheConeAndAPointDoesNot) {
  EXPECT_TRUE(echo_of(wall_ahead, cone(0.0, 0.0, 0.2 + 0.45), kSlantRad));
  EXPECT_FALSE(echo_of(wall_ahead, cone(0.0, 0.0, 0.2 + 0.55), kSlantRad));
  EXPECT_FALSE(echo_of(wall_ahead, cone(2.0, 0.0, 0.2), kSlantRad)) << "from behind";
  EXPECT_TRUE(echo_of(leg, cone(0.0, 0.3, 0.2), kSlantRad));
  EXPECT_FALSE(echo_of(leg, cone(0.0, 0.3, 0.25), kSlantRad));
}

TEST(EchoFeature, DerivativesAreThoseOfTheRangeAndTheBearing) {
  constexpr double kStep = 1e-6;
  for (const EchoFeature& feature : {wall_ahead, leg}) {
    for (const Echo& echo : {cone(0.1, 0.2, 0.1), cone(-0.3, 0.4, -0.05)}) {
      const FeatureEcho here = echo_of(feature, echo, kSlantRad).value();
      for (const int i : {0, 1}) {
        EchoFeature moved = feature;
        moved.value[i] += kStep;
        const FeatureEcho there = echo_of(moved, echo, kSlantRad).value();
        EXPECT_NEAR((there.range_m - here.range_m) / kStep, here.range_by_feature[i], 1e-4);
        EXPECT_NEAR(
            (there.bearing_rad - here.bearing_rad) / kStep, here.bearing_by_feature[i], 1e-4);
      }
    }
  }
}

TEST(EchoFeature, TwoEchoesOfAThingSayWhereItIs) {
  for (const EchoFeature& feature : {wall_ahead, leg}) {
    const auto found = features_through(heard(feature, cone(0.0, 0.0, 0.2)),
                                        heard(feature, cone(0.1, 0.5, 0.0)),
                                        {.most_slant_rad = kSlantRad});
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const EchoFeature& one) {
      return one.kind == feature.kind && (one.value - feature.value).norm() < 0.05;
    }));
  }
}

TEST(EchoFeature, FromOnePlaceAWallAndAPointAreInTheMiddle) {
  const auto found = features_through(heard(wall_ahead, cone(0.0, 0.0, 0.1)),
                                      heard(wall_ahead, cone(0.0, 0.0, 0.3)),
                                      {.most_slant_rad = 0.0});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, LandmarkKind::kWall);
  EXPECT_NEAR(found[0].value.x(), 1.5, 1e-9);
  EXPECT_NEAR(found[0].value.y(), 0.2, 1e-9);
  EXPECT_EQ(found[1].kind, LandmarkKind::kPoint);
  EXPECT_NEAR(std::atan2(found[1].value.y(), found[1].value.x()), 0.2, 1e-9);
}

TEST(EchoFeature, WhereAlongAWallAnAnswerIsFromIsMeasuredCounterClockwise) {
  const EchoFeature ahead{LandmarkKind::kWall, {1.0, 0.0}};
  EXPECT_NEAR(along_m(ahead, cone(0.0, 0.4, 0.1)), 0.4, 1e-9);
  EXPECT_GT(along_m(ahead, cone(0.0, 0.4, 0.4)), 0.5);
}

}  // namespace
}  // namespace echomap::slam
