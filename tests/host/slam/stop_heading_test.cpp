// SPDX-License-Identifier: MIT
#include "host/slam/stop_heading.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/smooth_room.hpp"

namespace echomap::slam {
namespace {

using geometry::radians;

const tests::SmoothRoom kRectangle = tests::smooth_rectangle();

/// The walls of that room, as long as they are, and its corners.
mapping::MatchedSurfaces features_of_room() {
  mapping::MatchedSurfaces matched;
  for (const tests::EndlessWall& wall : kRectangle.walls) {
    matched.walls.push_back({wall.normal_rad, wall.offset_m, {{-1.3, 1.3}}});
  }
  for (const Eigen::Vector2d& corner_m : kRectangle.corners_m) {
    matched.features.push_back({{mapping::LandmarkKind::kPoint, corner_m}, {}});
  }
  return matched;
}

/// Readings from there, placed with a heading that is `off_rad` too small.
mapping::Scan placed_off(const Eigen::Vector2d& place_m, double off_rad) {
  const geometry::Pose2 T_map_place(place_m.x(), place_m.y(), 0.0);
  return mapping::moved(tests::scan_of(kRectangle, place_m),
                        T_map_place * geometry::Pose2(0.0, 0.0, -off_rad) * T_map_place.inverse());
}

TEST(StopHeading, IsThatFromWhichTheReadingsAreLikely) {
  const SonarScene scene(features_of_room(), {});
  for (const double off_deg : {-6.0, -2.0, 0.0, 1.0, 5.0}) {
    const mapping::Scan readings = placed_off({0.3, 0.1}, radians(off_deg));
    const auto heading = scene.heading_of(readings);
    ASSERT_TRUE(heading.has_value());
    EXPECT_NEAR(heading->heading_rad,
                readings.front().T_map_robot.heading_rad() + radians(off_deg),
                radians(1.5))
        << off_deg;
    EXPECT_LT(heading->stddev_rad, radians(2.0));
  }
}

TEST(StopHeading, IsNotKnownOfFewReadingsOrWithoutFeatures) {
  const mapping::Scan readings = placed_off({0.3, 0.1}, 0.0);
  EXPECT_FALSE(SonarScene({}, {}).heading_of(readings).has_value());
  EXPECT_FALSE(SonarScene(features_of_room(), {})
                   .heading_of({readings.begin(), readings.begin() + 7})
                   .has_value());
}

TEST(StopHeading, ReadingsAreLikeliestAsTheyWereTaken) {
  const SonarScene scene(features_of_room(), {});
  const double as_taken = scene.log_likelihood_of(placed_off({0.3, 0.1}, 0.0));
  EXPECT_GT(as_taken, scene.log_likelihood_of(placed_off({0.3, 0.1}, radians(5.0))) + 5.0);
  EXPECT_GT(as_taken, SonarScene({}, {}).log_likelihood_of(placed_off({0.3, 0.1}, 0.0)) + 5.0);
}

/// Readings of something else leave the heading open instead of turning it.
TEST(StopHeading, IsUncertainWhereTheFeaturesExplainNothing) {
  mapping::MatchedSurfaces far_post;
  far_post.features.push_back({{mapping::LandmarkKind::kPoint, {3.5, 0.0}}, {}});
  const mapping::Scan readings = placed_off({0.3, 0.1}, 0.0);
  const auto heading = SonarScene(far_post, {}).heading_of(readings);
  ASSERT_TRUE(heading.has_value());
  EXPECT_GT(heading->stddev_rad, radians(4.0));
}

TEST(StopHeading, RefusesInvalidParameters) {
  StopHeadingParams params;
  params.step_rad = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
