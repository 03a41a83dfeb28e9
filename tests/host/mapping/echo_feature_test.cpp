// SPDX-License-Identifier: MIT
#include "host/mapping/echo_feature.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using ::testing::Contains;
using ::testing::Truly;

constexpr double kSlantRad = 0.26;
constexpr double kBeamHalfAngleRad = 0.23;

const EchoFeature wall_ahead{LandmarkKind::kWall, {1.5, 0.2}};
const EchoFeature leg{LandmarkKind::kPoint, {1.0, 0.3}};

Echo cone(double x_m, double y_m, double axis_rad) {
  return {{x_m, y_m}, axis_rad, 0.0, kBeamHalfAngleRad};
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
        EXPECT_NEAR((there.range_m - here.range_m) / kStep, here.jacobian(0, i), 1e-4);
        EXPECT_NEAR((there.bearing_rad - here.bearing_rad) / kStep, here.jacobian(1, i), 1e-4);
      }
    }
  }
}

TEST(EchoFeature, TwoEchoesOfAThingSayWhereItIs) {
  for (const EchoFeature& feature : {wall_ahead, leg}) {
    const auto found = features_through(heard(feature, cone(0.0, 0.0, 0.2)),
                                        heard(feature, cone(0.1, 0.5, 0.0)),
                                        {.max_incidence_rad = kSlantRad});
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const EchoFeature& one) {
      return one.kind == feature.kind && (one.value - feature.value).norm() < 0.05;
    }));
  }
}

TEST(EchoFeature, FromOnePlaceAWallAndAPointAreInTheMiddle) {
  const auto found = features_through(heard(wall_ahead, cone(0.0, 0.0, 0.1)),
                                      heard(wall_ahead, cone(0.0, 0.0, 0.3)),
                                      {.max_incidence_rad = 0.0});
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

// --- without a beam

double random_in(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

EchoFeature random_feature(std::mt19937& random) {
  const double first = random_in(random, -3.0, 3.0);
  const double second = random_in(random, 1.0, 3.0);
  return random() % 2 == 0 ? EchoFeature{LandmarkKind::kWall, {second, first}}
                           : EchoFeature{LandmarkKind::kPoint, {first, second}};
}

RangeCircle circle_of(const EchoFeature& feature, const Eigen::Vector2d& center_m) {
  return {center_m, view_from(center_m, feature).range_m};
}

TEST(FeatureView, SeesAWallAtTheFootOfThePerpendicular) {
  const EchoFeature wall{LandmarkKind::kWall, {3.0, geometry::radians(90.0)}};
  const FeatureView view = view_from({5.0, 1.0}, wall);
  EXPECT_NEAR(view.bearing_rad, geometry::radians(90.0), 1e-12);
  EXPECT_NEAR(view.range_m, 2.0, 1e-12);
}

TEST(FeatureView, SeesAPointWhereItStands) {
  const FeatureView view = view_from({1.0, 1.0}, {LandmarkKind::kPoint, {1.0, -1.0}});
  EXPECT_NEAR(view.bearing_rad, geometry::radians(-90.0), 1e-12);
  EXPECT_NEAR(view.range_m, 2.0, 1e-12);
}

TEST(FeatureView, HasTheJacobianOfItsDifferences) {
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    const EchoFeature feature = random_feature(random);
    const Eigen::Vector2d center_m(random_in(random, -0.9, 0.9), random_in(random, -0.9, 0.9));
    const FeatureView view = view_from(center_m, feature);
    for (int column = 0; column < 2; ++column) {
      constexpr double kStep = 1e-6;
      EchoFeature moved = feature;
      moved.value[column] += kStep;
      const FeatureView other = view_from(center_m, moved);
      EXPECT_NEAR(view.jacobian(0, column), (other.range_m - view.range_m) / kStep, 1e-4);
      EXPECT_NEAR(view.jacobian(1, column),
                  geometry::angle_between(view.bearing_rad, other.bearing_rad) / kStep,
                  1e-4);
    }
  }
}

TEST(FeaturesThroughCircles, FindTheOneThatWasSeenTwice) {
  std::mt19937 random(6);
  for (int i = 0; i < 100; ++i) {
    const EchoFeature feature = random_feature(random);
    const RangeCircle first = circle_of(feature, {random_in(random, -0.9, -0.4), 0.1});
    const RangeCircle second = circle_of(feature, {random_in(random, 0.1, 0.6), -0.3});
    const auto is_it = [&](const EchoFeature& found) {
      const Eigen::Vector2d off = found.value - feature.value;
      const bool is_wall = feature.kind == LandmarkKind::kWall;
      const double second_off = is_wall ? geometry::wrap_angle(off.y()) : off.y();
      return found.kind == feature.kind && std::hypot(off.x(), second_off) < 1e-6;
    };
    EXPECT_THAT(features_through(first, second), Contains(Truly(is_it)));
  }
}

TEST(FeaturesThroughCircles, FitBothRanges) {
  const RangeCircle first{{0.0, 0.0}, 1.2};
  const RangeCircle second{{0.8, 0.0}, 0.9};
  const auto features = features_through(first, second);
  EXPECT_EQ(features.size(), 4U);
  for (const auto& feature : features) {
    EXPECT_NEAR(view_from(first.center_m, feature).range_m, 1.2, 1e-9);
    EXPECT_NEAR(view_from(second.center_m, feature).range_m, 0.9, 1e-9);
  }
}

TEST(FeaturesThroughCircles, NeedABaseline) {
  const RangeCircle first{{0.0, 0.0}, 1.0};
  const RangeCircle second{{0.1, 0.0}, 0.9};
  EXPECT_TRUE(features_through(first, second).empty());
}

TEST(FeaturesThroughCircles, AreNoneWhereRangesCannotMeet) {
  const RangeCircle first{{0.0, 0.0}, 0.5};
  const RangeCircle second{{1.0, 0.0}, 3.0};
  EXPECT_TRUE(features_through(first, second).empty());
}

}  // namespace
}  // namespace echomap::mapping
