// SPDX-License-Identifier: MIT
#include "host/slam/factor_graph.hpp"

namespace echomap::slam {

FactorGraph in_frame_a(const geometry::Pose2& T_a_map, FactorGraph graph) {
  for (geometry::Pose2& node : graph.T_map_nodes) {
    node = T_a_map * node;
  }
  for (Eigen::Vector2d& landmark_m : graph.landmarks_m) {
    landmark_m = T_a_map * landmark_m;
  }
  for (geometry::Segment& wall : graph.walls) {
    wall = {T_a_map * wall.from_m, T_a_map * wall.to_m};
  }
  return graph;
}

}  // namespace echomap::slam
