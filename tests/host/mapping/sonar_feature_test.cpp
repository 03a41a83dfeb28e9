// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_feature.hpp"

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

double random_in(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

SonarFeature random_feature(std::mt19937& random) {
  const bool is_wall = random() % 2 == 0;
  return {is_wall, {random_in(random, -3.0, 3.0), random_in(random, 1.0, 3.0)}};
}

Sighting sighting_of(const SonarFeature& feature, const Eigen::Vector2d& center_m) {
  const FeatureView view = view_from(center_m, feature);
  return {0, 0, center_m, {view.bearing_rad, view.range_m, 0.0, 10}};
}

TEST(SonarFeature, SeesAWallAtTheFootOfThePerpendicular) {
  const SonarFeature wall{true, {geometry::radians(90.0), 3.0}};
  const FeatureView view = view_from({5.0, 1.0}, wall);
  EXPECT_NEAR(view.bearing_rad, geometry::radians(90.0), 1e-12);
  EXPECT_NEAR(view.range_m, 2.0, 1e-12);
}

TEST(SonarFeature, SeesAPostWhereItStands) {
  const FeatureView view = view_from({1.0, 1.0}, {false, {1.0, -1.0}});
  EXPECT_NEAR(view.bearing_rad, geometry::radians(-90.0), 1e-12);
  EXPECT_NEAR(view.range_m, 2.0, 1e-12);
}

TEST(SonarFeature, HasTheJacobianOfItsDifferences) {
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    const SonarFeature feature = random_feature(random);
    const Eigen::Vector2d center_m(random_in(random, -0.9, 0.9), random_in(random, -0.9, 0.9));
    const FeatureView view = view_from(center_m, feature);
    for (int column = 0; column < 2; ++column) {
      constexpr double kStep = 1e-6;
      SonarFeature moved = feature;
      moved.parameters(column) += kStep;
      const FeatureView other = view_from(center_m, moved);
      EXPECT_NEAR(view.jacobian(0, column),
                  geometry::angle_between(view.bearing_rad, other.bearing_rad) / kStep,
                  1e-4);
      EXPECT_NEAR(view.jacobian(1, column), (other.range_m - view.range_m) / kStep, 1e-4);
    }
  }
}

TEST(FeaturesThrough, FindTheOneThatWasSeenTwice) {
  std::mt19937 random(6);
  for (int i = 0; i < 100; ++i) {
    const SonarFeature feature = random_feature(random);
    const Sighting first = sighting_of(feature, {random_in(random, -0.9, -0.4), 0.1});
    const Sighting second = sighting_of(feature, {random_in(random, 0.1, 0.6), -0.3});
    const auto is_it = [&](const SonarFeature& found) {
      const Eigen::Vector2d off = found.parameters - feature.parameters;
      const double first_off = feature.is_wall ? geometry::wrap_angle(off.x()) : off.x();
      return found.is_wall == feature.is_wall && std::hypot(first_off, off.y()) < 1e-6;
    };
    EXPECT_THAT(features_through(first, second), Contains(Truly(is_it)));
  }
}

TEST(FeaturesThrough, FitBothRanges) {
  const Sighting first{0, 0, {0.0, 0.0}, {0.3, 1.2, 0.0, 10}};
  const Sighting second{1, 0, {0.8, 0.0}, {0.5, 0.9, 0.0, 10}};
  const auto features = features_through(first, second);
  EXPECT_EQ(features.size(), 4U);
  for (const auto& feature : features) {
    EXPECT_NEAR(view_from(first.center_m, feature).range_m, 1.2, 1e-9);
    EXPECT_NEAR(view_from(second.center_m, feature).range_m, 0.9, 1e-9);
  }
}

TEST(FeaturesThrough, NeedABaseline) {
  const Sighting first{0, 0, {0.0, 0.0}, {0.0, 1.0, 0.0, 10}};
  const Sighting second{1, 0, {0.1, 0.0}, {0.0, 0.9, 0.0, 10}};
  EXPECT_TRUE(features_through(first, second).empty());
}

TEST(FeaturesThrough, AreNoneWhereRangesCannotMeet) {
  const Sighting first{0, 0, {0.0, 0.0}, {0.0, 0.5, 0.0, 10}};
  const Sighting second{1, 0, {1.0, 0.0}, {0.0, 3.0, 0.0, 10}};
  EXPECT_TRUE(features_through(first, second).empty());
}

}  // namespace
}  // namespace echomap::mapping
