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

/// Another robot, where this robot's map has it.
struct Peer {
  std::string robot;
  geometry::Pose2 T_map_robot;
  double position_stddev_m = 0.0;
  double radius_m = 0.0;
  double age_s = 0.0;          ///< Since it told its pose.
  double speed_m_per_s = 0.0;  ///< Forward, when it told its pose.
  bool stays = false;          ///< It has said good-bye: nobody drives it any more.
};

/// A place that a robot bids to look from. The claim with more utility holds; of two alike, that
/// of the robot whose name comes first.
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
  /// What all of them have seen; null where nobody else is known: then the robot's own map holds.
  std::shared_ptr<const mapping::OccupancyGrid> grid;
  std::shared_ptr<const std::vector<mapping::Scan>> scans;     ///< What `grid` is made of.
  std::shared_ptr<const mapping::SonarFeatures> features;      ///< What `grid` is drawn from.
  std::shared_ptr<const std::vector<Eigen::Vector2d>> been_m;  ///< Where the others have been.
  std::vector<Peer> peers;
  std::vector<Claim> claims;  ///< Of others.
};

/// What of it matters to a robot that decides where to go.
exploration::Company company_of(const TeamView& view);

}  // namespace echomap::team_exploration
