// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/geometry/segment.hpp"
#include "host/slam/pose_graph.hpp"

namespace echomap::slam {

/// What is known of a landmark, a point, from a pose.
struct LandmarkEdge {
  std::size_t from = 0;  ///< A node.
  std::size_t landmark = 0;
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();  ///< In the frame of `from`.
  /// Of x and y (m) on the axes of `from`.
  Eigen::Matrix2d information = Eigen::Matrix2d::Identity();
};

/// What SLAM has estimated and what it knows of it, for programs that solve such graphs: no edge is
/// doubtful, and with the nodes and landmarks where they are the squares of all errors are least,
/// as far as SLAM was done. The first node holds the map: it is known.
struct FactorGraph {
  std::vector<geometry::Pose2> T_map_nodes;
  std::vector<Eigen::Vector2d> landmarks_m;  ///< In the map.
  std::vector<PoseEdge> edges;
  std::vector<LandmarkEdge> landmark_edges;
  /// Landmarks that are walls, as far as they have been seen, in the map: no edge leads to them.
  std::vector<geometry::Segment> walls{};
};

/// The same graph in another frame.
FactorGraph in_frame_a(const geometry::Pose2& T_a_map, FactorGraph graph);

}  // namespace echomap::slam
