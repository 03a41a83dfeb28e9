// SPDX-License-Identifier: MIT
#include "host/slam/landmark_graph.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;

/// Nothing where all of it is known: then it is where the map begins.
void add_pose(const localization::PoseGaussian& pose, FactorGraph& graph) {
  if (!localization::is_covariance(pose.covariance)) {
    return;
  }
  const Eigen::Matrix3d information = pose.covariance.llt().solve(Eigen::Matrix3d::Identity());
  graph.edges.push_back({0,
                         graph.T_map_nodes.size(),
                         graph.T_map_nodes.front().inverse() * pose.T_map_robot,
                         in_frame_of(pose.T_map_robot, information),
                         false});
  graph.T_map_nodes.push_back(pose.T_map_robot);
}

void add_landmark(const Eigen::Vector2d& place_m,
                  const Eigen::Matrix2d& covariance,
                  FactorGraph& graph) {
  const Pose2 T_first_map = graph.T_map_nodes.front().inverse();
  const Eigen::Matrix2d to_first = Eigen::Rotation2Dd(T_first_map.heading_rad()).toRotationMatrix();
  const Eigen::Matrix2d on_axes_of_first = to_first * covariance * to_first.transpose();
  graph.landmark_edges.push_back({0,
                                  graph.landmarks_m.size(),
                                  T_first_map * place_m,
                                  on_axes_of_first.llt().solve(Eigen::Matrix2d::Identity())});
  graph.landmarks_m.push_back(place_m);
}

/// The part of a wall that has been seen.
geometry::Segment seen_piece(const Landmark& wall) {
  const Eigen::Vector2d normal = geometry::unit_vector(wall.value.y());
  const Eigen::Vector2d foot_m = wall.value.x() * normal;
  const Eigen::Vector2d along = geometry::perpendicular(normal);
  return {foot_m + wall.along_from_m * along, foot_m + wall.along_to_m * along};
}

}  // namespace

FactorGraph landmark_graph(const EkfSlamFilter& filter) {
  FactorGraph graph;
  if (filter.stored_poses() == 0) {
    return graph;
  }
  graph.T_map_nodes = {filter.T_map_stored(0)};
  for (std::size_t kept = 1; kept < filter.stored_poses(); ++kept) {
    add_pose({filter.T_map_stored(kept), filter.stored_covariance(kept)}, graph);
  }
  add_pose(filter.belief(), graph);
  for (std::size_t i = 0; i < filter.landmarks().size(); ++i) {
    const Landmark& landmark = filter.landmarks()[i];
    if (landmark.kind == LandmarkKind::kPoint) {
      add_landmark(landmark.value, filter.landmark_covariance(i), graph);
    } else {
      graph.walls.push_back(seen_piece(landmark));
    }
  }
  return graph;
}

}  // namespace echomap::slam
