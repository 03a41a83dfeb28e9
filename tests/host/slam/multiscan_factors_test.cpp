// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_factors.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using geometry::Pose2;

constexpr double kAlongsM[] = {-0.4, -0.2, 0.0, 0.2, 0.4};

/// The wall x = 2 as a robot at `T_map_begin` sees it.
std::vector<SurfacePatch> wall_seen_from(const Pose2& T_map_begin) {
  std::vector<SurfacePatch> patches;
  for (const double along_m : kAlongsM) {
    patches.push_back({T_map_begin.inverse() * Eigen::Vector2d(2.0, along_m),
                       -T_map_begin.heading_rad(),
                       0.01,
                       0.02});
  }
  return patches;
}

/// And the wall y = 1.
std::vector<SurfacePatch> walls_seen_from(const Pose2& T_map_begin) {
  std::vector<SurfacePatch> patches = wall_seen_from(T_map_begin);
  for (const double along_m : kAlongsM) {
    patches.push_back({T_map_begin.inverse() * Eigen::Vector2d(1.0 + along_m, 1.0),
                       std::numbers::pi / 2 - T_map_begin.heading_rad(),
                       0.01,
                       0.02});
  }
  return patches;
}

/// Of a robot that turns as it drives, by odometry that is off by chance.
template <class See>
MultiscanGraph driven(See see) {
  MultiscanGraph graph;
  Pose2 believed;
  for (int i = 0; i <= 5; ++i) {
    graph.multiscans.push_back(
        {believed, see(Pose2(0.2 * i, 0.0, 0.05 * i)), Eigen::Matrix3d::Zero()});
    const Pose2 step(0.2, 0.03 * std::sin(i), 0.05 + 0.05 * std::cos(3.0 * i));
    graph.pieces.push_back({step, 0.2, 0.05, 0.05, 0.0, 0.0});
    believed = believed * step;
  }
  graph.pieces.pop_back();
  graph.odometry_scale = 3.0;
  return graph;
}

const MultiscanAlignmentParams params;

std::vector<PatchMatch> aligned(MultiscanGraph& graph) {
  const auto matches = match_patches(graph.multiscans, 1, {});
  for (int i = 0; i < 30; ++i) {
    align_multiscans(graph, matches, 1, 1, params);
  }
  return matches;
}

PoseGraph pose_graph_of(const FactorGraph& factors) {
  PoseGraph graph;
  for (const Pose2& node : factors.T_map_nodes) {
    graph.add_node(node);
  }
  for (const PoseEdge& edge : factors.edges) {
    graph.add_edge(edge);
  }
  return graph;
}

double max_moved_m(const std::vector<Pose2>& from, const std::vector<Pose2>& to) {
  double max_m = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    max_m = std::max(max_m, (to[i].position_m() - from[i].position_m()).norm());
  }
  return max_m;
}

TEST(MultiscanFactors, OfOdometryAreOffByWhatThePosesAreOffIt) {
  MultiscanGraph graph = driven(walls_seen_from);
  aligned(graph);
  const FactorGraph factors = factor_graph(graph, {}, 1, params);
  const PoseGraph poses = pose_graph_of(factors);
  ASSERT_EQ(factors.edges.size(), graph.pieces.size());
  for (std::size_t i = 0; i < graph.pieces.size(); ++i) {
    const Pose2 driven = calibrated(graph.pieces[i], graph.calibration);
    const Pose2 now =
        graph.multiscans[i].T_map_begin.inverse() * graph.multiscans[i + 1].T_map_begin;
    const Eigen::Vector3d off(now.x_m() - driven.x_m(),
                              now.y_m() - driven.y_m(),
                              now.heading_rad() - driven.heading_rad());
    const Eigen::Vector3d sds = 3.0 * variances(graph.pieces[i], params.odometry).cwiseSqrt();
    const double expected = off.cwiseQuotient(sds).squaredNorm();
    EXPECT_GT(expected, 1e-4);
    EXPECT_NEAR(poses.square_error(factors.edges[i]), expected, 1e-9 * expected) << i;
  }
}

TEST(MultiscanFactors, HoldThePosesWhereAlignmentHasPutThem) {
  MultiscanGraph graph = driven(walls_seen_from);
  const std::vector<Pose2> by_odometry = factor_graph(graph, {}, 1, params).T_map_nodes;
  const auto matches = aligned(graph);
  const FactorGraph factors = factor_graph(graph, matches, 1, params);
  ASSERT_GT(factors.edges.size(), graph.pieces.size());
  ASSERT_GT(max_moved_m(by_odometry, factors.T_map_nodes), 0.02);
  PoseGraph solved = pose_graph_of(factors);
  ASSERT_TRUE(solved.solve());
  EXPECT_LT(max_moved_m(factors.T_map_nodes, solved.nodes()), 1e-4);
}

TEST(MultiscanFactors, KnowNothingAlongASingleWall) {
  MultiscanGraph graph = driven(wall_seen_from);
  const auto matches = aligned(graph);
  const FactorGraph factors = factor_graph(graph, matches, 1, params);
  ASSERT_GT(factors.edges.size(), graph.pieces.size());
  for (std::size_t i = graph.pieces.size(); i < factors.edges.size(); ++i) {
    const PoseEdge& edge = factors.edges[i];
    const double heading_rad = factors.T_map_nodes[edge.to].heading_rad();
    const Eigen::Vector3d along(std::sin(heading_rad), std::cos(heading_rad), 0.0);
    const Eigen::Vector3d across(std::cos(heading_rad), -std::sin(heading_rad), 0.0);
    EXPECT_LT(along.dot(edge.information * along), 0.02 * across.dot(edge.information * across));
  }
}

}  // namespace
}  // namespace echomap::slam
