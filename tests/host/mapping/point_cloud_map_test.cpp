// SPDX-License-Identifier: MIT
#include "host/mapping/point_cloud_map.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

PlacedReading reading_at(const geometry::Pose2& pose, std::optional<double> range_m) {
  return {pose, pose, range_m};
}

TEST(PointCloudMap, AddsAPoseOnlyWhenTheRobotHasMoved) {
  PointCloudMap map;
  map.add(reading_at({0.0, 0.0, 0.0}, 1.0));
  map.add(reading_at({0.0, 0.0, 0.0}, 2.0));
  map.add(reading_at({0.0, 0.0, 0.1}, 3.0));
  map.add(reading_at({0.5, 0.0, 0.1}, 4.0));
  ASSERT_EQ(map.poses().size(), 3U);
  ASSERT_EQ(map.points().size(), 4U);
  EXPECT_EQ(map.points()[1].pose_index, 0U);
  EXPECT_EQ(map.points()[2].pose_index, 1U);
  EXPECT_EQ(map.points()[3].pose_index, 2U);
  EXPECT_EQ(map.points()[1].position_m, Eigen::Vector2d(2.0, 0.0));
}

TEST(PointCloudMap, DropsReadingsWithoutEchoButKeepsThePose) {
  PointCloudMap map;
  map.add(reading_at({1.0, 1.0, 0.0}, std::nullopt));
  EXPECT_EQ(map.poses().size(), 1U);
  EXPECT_TRUE(map.points().empty());
}

TEST(PointCloudMap, RefusesAPointOfNoPose) {
  EXPECT_THROW(PointCloudMap({geometry::Pose2()}, {{{0.0, 0.0}, 1}}), std::invalid_argument);
  EXPECT_NO_THROW(PointCloudMap({geometry::Pose2()}, {{{0.0, 0.0}, 0}}));
}

TEST(PointCloudMap, OfThePapersRunHasOneRowForEachReadingWithEcho) {
  // Singh and Bedi 2013, section 3.2: 120 readings at each of 100 positions make 12000 records.
  PointCloudMap map;
  for (int stop = 0; stop < 100; ++stop) {
    for (int i = 0; i < 120; ++i) {
      map.add(reading_at({0.1 * stop, 0.0, 0.0}, 1.0 + 0.01 * i));
    }
  }
  EXPECT_EQ(map.points().size(), 12000U);
  EXPECT_EQ(map.poses().size(), 100U);
  EXPECT_EQ(map.poses().front().position_m(), Eigen::Vector2d(0.0, 0.0)) << "the map's origin";
}

}  // namespace
}  // namespace echomap::mapping
