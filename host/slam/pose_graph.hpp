// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::slam {

/// What is known of the way from one pose to another.
struct PoseEdge {
  std::size_t from = 0;
  std::size_t to = 0;
  geometry::Pose2 T_from_to;
  /// Of x, y (m) and heading (rad) on the axes of `to`.
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
  /// It may be wrong, as a closed loop may be: the farther it is off, the less it pulls.
  bool is_doubtful = false;
};

/// How a graph is solved.
struct PoseGraphParams {
  int max_iterations = 10;
  double min_step_m = 1e-4;  ///< The last iteration moves no pose by more, nor turns it by
  double min_step_rad = 1e-4;
  /// A doubtful edge so many standard deviations off counts a quarter (Geman and McClure).
  double kernel = 5.0;
};

/// Information on a pose in the map, on the axes of the map, turned to those of the pose.
Eigen::Matrix3d in_frame_of(const geometry::Pose2& T_map_robot, const Eigen::Matrix3d& information);

/// Information that is left when an estimate may be off by more than it knows of: normal errors of
/// so many metres in x and y and radians in heading are added to it. What it says nothing of stays
/// so.
Eigen::Matrix3d with_spread(const Eigen::Matrix3d& information, double spread_m, double spread_rad);

/// The pose after a step of its x, y (m) and heading (rad) in the map.
geometry::Pose2 moved(const geometry::Pose2& T_map_pose, const Eigen::Vector3d& step);

/// How far an edge is off, and how that changes with the poses it joins.
struct EdgeError {
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  ///< Of x, y (m) and heading (rad).
  Eigen::Matrix3d by_from = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d by_to = Eigen::Matrix3d::Zero();
};

/// Of an edge between poses in the map (Grisetti et al. 2010, equations 30 to 33); derivatives by x
/// and y in the map and by heading.
EdgeError edge_error(const PoseEdge& edge,
                     const geometry::Pose2& T_map_from,
                     const geometry::Pose2& T_map_to);

/// Poses and what is known between them. Solving moves the poses to where the squares of all errors
/// are least (Lu and Milios 1997; Grisetti et al. 2010). The first pose stays.
class PoseGraph {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit PoseGraph(const PoseGraphParams& params = {});

  /// The number of the new node; they count from 0.
  std::size_t add_node(const geometry::Pose2& T_map_node);
  /// Throws std::invalid_argument for nodes that are not there, or are one.
  void add_edge(const PoseEdge& edge);

  const std::vector<geometry::Pose2>& nodes() const { return T_map_nodes_; }
  const std::vector<PoseEdge>& edges() const { return edges_; }
  /// How far the nodes are off what the edge says: the square of the error in standard deviations.
  double square_error(const PoseEdge& edge) const;
  /// The edges for those who know of no doubt: of a doubtful one, the information that is left
  /// where the nodes are now.
  std::vector<PoseEdge> weighed_edges() const;

  /// Gauss-Newton with a sparse Cholesky factorisation. Each node has to hang on the first one by
  /// edges. False where that is not so: then nothing moves any more.
  bool solve();

 private:
  double robust_weight(const PoseEdge& edge, double squared_error) const;

  PoseGraphParams params_;
  std::vector<geometry::Pose2> T_map_nodes_;
  std::vector<PoseEdge> edges_;
};

}  // namespace echomap::slam
