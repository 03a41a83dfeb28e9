// SPDX-License-Identifier: MIT
#include "host/slam/landmark_graph.hpp"

#include <gtest/gtest.h>

#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {
namespace {

TEST(LandmarkGraph, HoldsPosesPointsAndTheSeenPiecesOfWalls) {
  const localization::PoseGaussian start{{1.0, 2.0, 0.3}, 0.01 * Eigen::Matrix3d::Identity()};
  EkfSlamFilter filter({&start, 1});
  EXPECT_TRUE(landmark_graph(filter).T_map_nodes.empty()) << "it keeps no pose yet";
  filter.store_pose();
  filter.move(0, geometry::Pose2(1.0, 0.0, 0.0), {.drive_m = 1.0}, {0.01, 0.05, 0.01, 0.02});
  LandmarkSighting sighting;
  sighting.value = {2.0, 0.1};
  filter.add(sighting);
  sighting.kind = LandmarkKind::kWall;
  sighting.value = {3.0, -0.3};
  sighting.along_from_m = -1.0;
  sighting.along_to_m = 2.0;
  filter.add(sighting);
  const FactorGraph graph = landmark_graph(filter);
  EXPECT_EQ(graph.T_map_nodes.size(), 2U);
  EXPECT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.landmarks_m.size(), 1U);
  EXPECT_EQ(graph.landmark_edges.size(), 1U);
  ASSERT_EQ(graph.walls.size(), 1U);
  const geometry::Pose2 T_map_robot = filter.belief().T_map_robot;
  const Eigen::Vector2d ahead = geometry::unit_vector(-0.3);
  const Eigen::Vector2d along = geometry::perpendicular(ahead);
  EXPECT_LT((graph.walls[0].from_m - T_map_robot * (3.0 * ahead - 1.0 * along)).norm(), 1e-9);
  EXPECT_LT((graph.walls[0].to_m - T_map_robot * (3.0 * ahead + 2.0 * along)).norm(), 1e-9);
}

}  // namespace
}  // namespace echomap::slam
