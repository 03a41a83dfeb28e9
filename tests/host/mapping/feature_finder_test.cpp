// SPDX-License-Identifier: MIT
#include "host/mapping/feature_finder.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "tests/host/mapping/default_params.hpp"

namespace echomap::mapping {
namespace {

using geometry::radians;

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
                       FeatureContradiction({}, {}, kMatchingParams),
                       kMatchingParams);
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
  const FeatureContradiction nobody({}, {}, kMatchingParams);
  EXPECT_FALSE(FeatureFinder({of_wall(0, 0.0, 0.0), of_post(0, 0.0, 0.0)}, nobody, kMatchingParams)
                   .take_best());
  EXPECT_FALSE(FeatureFinder({}, nobody, kMatchingParams).take_best());
}

TEST(FeatureFinder, DropsAPostThatOtherStopsHearPast) {
  SurfaceMatchingParams params;
  params.contradiction_weight = 0.5;
  const std::vector<Sighting> sightings{of_post(0, 0.0, 0.0), of_post(1, 0.8, 0.5)};
  std::vector<ScanSurfaces> stops(2);
  for (const double y_m : {-1.0, -0.5}) {
    const double bearing_rad = std::atan2(-y_m, 1.0);
    stops.push_back({{0.0, y_m}, {}, {{bearing_rad, 2.5}}});
  }
  const auto found_after = [&](std::size_t heard) {
    std::vector<bool> among(stops.size(), false);
    std::fill_n(among.begin() + 2, heard, true);
    return FeatureFinder(sightings, FeatureContradiction(stops, among, params), params)
        .take_best()
        .has_value();
  };
  EXPECT_TRUE(found_after(0));
  EXPECT_FALSE(found_after(2));
}

}  // namespace
}  // namespace echomap::mapping
