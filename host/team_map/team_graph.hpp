// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/surface_matching.hpp"
#include "host/slam/stop_graph.hpp"
#include "host/slam/stop_heading.hpp"
#include "host/slam/stop_stand.hpp"
#include "host/team_map/robot_map.hpp"

namespace echomap::team_map {

/// How the stops of several robots are aligned. Values are those of slam::StopAlignmentParams.
struct TeamGraphParams {
  slam::StopStandParams stands;
  mapping::SurfaceMatchingParams matching{.wall_bearing_tolerance_rad = 0.18,
                                          .post_bearing_tolerance_rad = 0.18};
  slam::StopHeadingParams heading;
  slam::StopGraphParams graph;
  int rounds = 2;
  /// Weight of a reading as a measurement of its stop's heading, for the standard deviations:
  /// neighbours in a beam share their errors.
  double reading_weight = 0.1;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const TeamGraphParams& params);

/// The stops of one robot in a team's graph.
struct TeamTrack {
  const RobotMap* map = nullptr;
  std::vector<geometry::Pose2> T_team_submaps;  ///< Initial poses, which are then aligned.
  /// Standard deviations of the last one against the first submap of the first track; infinite
  /// where nothing connects the two.
  double position_stddev_m = 0.0;
  double heading_stddev_rad = 0.0;
};

/// Relative pose of two stops of two robots, known from outside or by a join.
struct TeamRelation {
  std::size_t robot = 0;  ///< Index of its track, and its submap.
  std::size_t submap = 0;
  std::size_t peer = 0;
  std::size_t peer_submap = 0;
  geometry::Pose2 T_submap_peer;
  double position_stddev_m = 0.0;
  double heading_stddev_rad = 0.0;
};

/// Aligns all stops of all robots on the walls and posts that they share, with the odometry of each
/// between its own: one least-squares pose graph (slam::align_stops) over surfaces that are matched
/// across robots. The first submap of the first track stays fixed.
void align_team(const TeamGraphParams& params,
                const std::vector<TeamRelation>& relations,
                std::vector<TeamTrack>& tracks);

}  // namespace echomap::team_map
