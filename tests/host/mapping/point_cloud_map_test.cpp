// SPDX-License-Identifier: MIT
#include "host/mapping/point_cloud_map.hpp"

#include <cmath>
#include <random>
#include <set>
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

TEST(ThinnedPointCloud, KeepsTheFirstPointOfAVoxel) {
  const PointCloudMap map({geometry::Pose2()},
                          {{{0.01, 0.01}, 0}, {{0.09, 0.09}, 0}, {{-0.01, 0.01}, 0}});
  const auto thin = thinned(map, 0.1);
  ASSERT_EQ(thin.points().size(), 2U);
  EXPECT_EQ(thin.points()[0].position_m, Eigen::Vector2d(0.01, 0.01));
  EXPECT_EQ(thin.points()[1].position_m, Eigen::Vector2d(-0.01, 0.01));
  EXPECT_EQ(thin.poses().size(), 1U);
}

TEST(ThinnedPointCloud, HasAPointInEveryVoxelThatHadOneAndOnlyOne) {
  std::mt19937 random(2);
  std::normal_distribution<double> place_m(0.0, 1.0);
  std::vector<MapPoint> points;
  for (int i = 0; i < 5000; ++i) {
    points.push_back({{place_m(random), place_m(random)}, 0});
  }
  const PointCloudMap map({geometry::Pose2()}, points);
  const auto thin = thinned(map, 0.25);
  const auto voxels_of = [](const PointCloudMap& cloud) {
    std::set<std::pair<int, int>> voxels;
    for (const auto& point : cloud.points()) {
      voxels.emplace(static_cast<int>(std::floor(point.position_m.x() / 0.25)),
                     static_cast<int>(std::floor(point.position_m.y() / 0.25)));
    }
    return voxels;
  };
  EXPECT_EQ(voxels_of(thin), voxels_of(map));
  EXPECT_EQ(voxels_of(thin).size(), thin.points().size());
  EXPECT_EQ(thinned(thin, 0.25).points().size(), thin.points().size());
}

TEST(ThinnedPointCloud, RefusesAnEdgeOfNothing) {
  EXPECT_THROW(thinned(PointCloudMap(), 0.0), std::invalid_argument);
  EXPECT_THROW(thinned(PointCloudMap(), std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
