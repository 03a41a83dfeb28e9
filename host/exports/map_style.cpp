// SPDX-License-Identifier: MIT
#include "host/exports/map_style.hpp"

namespace echomap::exports {

std::vector<LegendEntry> legend_of(const pipeline::Snapshot& snapshot,
                                   bool has_outline,
                                   const MapStyle& style) {
  std::vector<LegendEntry> legend{
      {kFloorColour, "floor"}, {kWallColour, "occupied"}, {kUnknownColour, "unknown"}};
  if (has_outline) {
    legend.push_back({kOutlineColour, "outline"});
  }
  const mapping::SonarFeatures& features = *snapshot.features;
  if (style.shows_features && !(features.walls.empty() && features.circles.empty())) {
    legend.push_back({kFittedColour, "fitted"});
  }
  if (!style.landmarks.empty()) {
    legend.push_back({kLandmarkColour, "landmark"});
  }
  if (!snapshot.points->points().empty()) {
    legend.push_back({kEchoColour, "echo"});
  }
  if (!snapshot.trajectory->empty()) {
    legend.push_back({kTrailColour, "trail"});
    legend.push_back({kStartColour, "start"});
  }
  legend.push_back({kRobotColour, "robot"});
  return legend;
}

std::vector<Eigen::Vector2d> held_points_m(const pipeline::Snapshot& snapshot,
                                           const MapStyle& style) {
  std::vector<Eigen::Vector2d> points_m;
  // The picture may be turned: a square around the robot that holds it however it is turned.
  const double reach_m = 1.5 * style.robot_radius_m;
  const auto add = [&](const geometry::Pose2& T_map_robot) {
    for (const double x_m : {-reach_m, reach_m}) {
      for (const double y_m : {-reach_m, reach_m}) {
        points_m.emplace_back(T_map_robot.position_m() + Eigen::Vector2d(x_m, y_m));
      }
    }
  };
  for (const pipeline::StampedPose& pose : *snapshot.trajectory) {
    add(pose.T_map_robot);
  }
  add(snapshot.latest.T_map_robot);
  if (style.holds_echoes) {
    for (const mapping::MapPoint& echo : snapshot.points->points()) {
      points_m.push_back(echo.position_m);
    }
  }
  return points_m;
}

}  // namespace echomap::exports
