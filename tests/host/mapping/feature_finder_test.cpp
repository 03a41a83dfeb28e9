// SPDX-License-Identifier: MIT
#include "host/mapping/feature_finder.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

const SurfaceMatchingParams kParams;

/// A wall at y = 2 as one stop sees it.
Sighting of_wall(std::size_t scan, double x_m, double y_m) {
  return sighting_of({{x_m, y_m}, {{radians(90.0), 2.0 - y_m, 0.2, 12}}, {}}, scan, 0);
}

/// A post at (1, 0) likewise.
Sighting of_post(std::size_t scan, double x_m, double y_m) {
  const Eigen::Vector2d offset_m = Eigen::Vector2d(1.0, 0.0) - Eigen::Vector2d(x_m, y_m);
  const double bearing_rad = std::atan2(offset_m.y(), offset_m.x());
  return sighting_of({{x_m, y_m}, {{bearing_rad, offset_m.norm(), 0.0, 9}}, {}}, scan, 0);
}

TEST(FeatureFinder, TakesTheBestSupportedFirstAndThenWhatIsLeft) {
  FeatureFinder finder({of_wall(0, 0.0, 0.0),
                        of_post(0, 0.0, 0.0),
                        of_wall(1, 0.8, 0.5),
                        of_post(1, 0.8, 0.5),
                        of_wall(2, 1.5, 0.9)},
                       kParams);
  const auto wall = finder.take_best();
  ASSERT_TRUE(wall);
  EXPECT_EQ(wall->feature.kind, LandmarkKind::kWall);
  EXPECT_EQ(wall->supporters.size(), 3U);
  const auto post = finder.take_best();
  ASSERT_TRUE(post);
  EXPECT_EQ(post->feature.kind, LandmarkKind::kPoint);
  EXPECT_EQ(post->supporters.size(), 2U);
  EXPECT_FALSE(finder.take_best());
}

TEST(FeatureFinder, FindsNothingInWhatOneStopHasSeen) {
  EXPECT_FALSE(FeatureFinder({of_wall(0, 0.0, 0.0), of_post(0, 0.0, 0.0)}, kParams).take_best());
  EXPECT_FALSE(FeatureFinder({}, kParams).take_best());
}

}  // namespace
}  // namespace echomap::mapping
