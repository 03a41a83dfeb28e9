// SPDX-License-Identifier: MIT
#include "host/slam/landmark_graph.hpp"

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

TEST(LandmarkGraph, HoldsPosesAndPointsAndNoWalls) {
  const localization::PoseGaussian start{{1.0, 2.0, 0.3}, 0.01 * Eigen::Matrix3d::Identity()};
  EkfSlamFilter filter({&start, 1});
  EXPECT_TRUE(landmark_graph(filter).T_map_nodes.empty()) << "it keeps no pose yet";
  filter.store_pose();
  filter.move(0, geometry::Pose2(1.0, 0.0, 0.0), {.drive_m = 1.0}, {0.01, 0.05, 0.01, 0.02});
  LandmarkSighting sighting;
  sighting.value = {2.0, 0.1};
  filter.add(sighting);
  sighting.kind = LandmarkKind::kWall;
  filter.add(sighting);
  const FactorGraph graph = landmark_graph(filter);
  EXPECT_EQ(graph.T_map_nodes.size(), 2U);
  EXPECT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.landmarks_m.size(), 1U);
  EXPECT_EQ(graph.landmark_edges.size(), 1U);
}

}  // namespace
}  // namespace echomap::slam
