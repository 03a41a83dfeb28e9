// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/company.hpp"
#include "host/geometry/pose2.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_features.hpp"

namespace echomap::team_exploration {

/// Another robot, at its place on this robot's map.
struct Peer {
  std::string robot;
  geometry::Pose2 T_map_robot;
  double position_stddev_m = 0.0;
  double radius_m = 0.0;
  double age_s = 0.0;          ///< Since it published its pose.
  double speed_m_per_s = 0.0;  ///< Forward, when it published its pose.
  bool stays = false;          ///< It has left the fleet and does not move any more.
};

/// A viewpoint that a robot claims. Of two claims the one with more utility wins; of equal ones,
/// that of the robot whose name comes first.
struct Claim {
  std::string robot;
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();  ///< In this robot's map.
  double utility = 0.0;  ///< Unknown floor that is expected from there, square metres per second.
  double reach_m = 0.0;  ///< How far a look from there shows floor.
  std::string waits_for{};  ///< The robot that stands in its way; empty for none.
};

/// What the team knows, in one robot's own map frame. Robots whose relative pose is not known are
/// not in it.
struct TeamView {
  /// What all of them have seen; null where no other robot is known: then the robot's own map
  /// holds.
  std::shared_ptr<const mapping::OccupancyGrid> grid;
  std::shared_ptr<const std::vector<mapping::Scan>> scans;     ///< What `grid` is made of.
  std::shared_ptr<const mapping::SonarFeatures> features;      ///< What `grid` is drawn from.
  std::shared_ptr<const std::vector<Eigen::Vector2d>> been_m;  ///< Where the others have been.
  std::vector<Peer> peers;
  std::vector<Claim> claims;  ///< Of others.
};

/// The part of a view that matters to a robot's choice of its goal.
exploration::Company company_of(const TeamView& view);

}  // namespace echomap::team_exploration
