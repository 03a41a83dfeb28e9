// SPDX-License-Identifier: MIT
#include "host/slam/factor_graph.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using geometry::Pose2;

TEST(FactorGraph, InAnotherFrameHasTheSameEdges) {
  const Pose2 T_a_map(10.0, 20.0, std::numbers::pi / 2);
  const FactorGraph graph{{{}, {1.0, 0.0, 0.5}},
                          {{2.0, 0.0}},
                          {{0, 1, {1.0, 0.1, 0.5}, Eigen::Matrix3d::Identity(), false}},
                          {{0, 0, {2.0, 0.1}, Eigen::Matrix2d::Identity()}},
                          {{{1.0, 0.0}, {3.0, 0.0}}}};
  const FactorGraph moved = in_frame_a(T_a_map, graph);
  EXPECT_EQ(moved.T_map_nodes[0].position_m(), Eigen::Vector2d(10.0, 20.0));
  EXPECT_NEAR(moved.T_map_nodes[1].y_m(), 21.0, 1e-12);
  EXPECT_NEAR(moved.T_map_nodes[1].heading_rad(), 0.5 + std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(moved.landmarks_m[0].y(), 22.0, 1e-12);
  EXPECT_NEAR(moved.walls[0].from_m.y(), 21.0, 1e-12);
  EXPECT_NEAR(moved.walls[0].to_m.y(), 23.0, 1e-12);
  EXPECT_EQ(moved.edges[0].T_from_to.y_m(), 0.1);
  EXPECT_EQ(moved.landmark_edges[0].place_m, Eigen::Vector2d(2.0, 0.1));
  const auto off = [](const FactorGraph& in) {
    return edge_error(in.edges[0], in.T_map_nodes[0], in.T_map_nodes[1]).error;
  };
  EXPECT_LT((off(moved) - off(graph)).norm(), 1e-12);
}

}  // namespace
}  // namespace echomap::slam
