// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_features.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exploration {

/// A look that somebody else is about to make, in the map frame.
struct PromisedLook {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double reach_m = 0.0;  ///< How far it shows floor.
  double utility = 0.0;  ///< Unknown floor that it is expected to show, square metres per second.
};

/// Floor that somebody else stands on, in the map frame.
struct OccupiedFloor {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  bool is_closed = false;  ///< No way leads over it; otherwise it is dear floor.
};

/// What others who explore the same floor know and do, as far as it matters to a robot that decides
/// where to go. By default there is nobody.
struct Company {
  /// What all have seen together: these take the place of what the robot's own snapshot has. Null
  /// where its own holds.
  std::shared_ptr<const mapping::OccupancyGrid> grid;
  std::shared_ptr<const std::vector<mapping::Scan>> scans;
  std::shared_ptr<const mapping::SonarFeatures> features;
  /// Where the others have been; null for nowhere.
  std::shared_ptr<const std::vector<Eigen::Vector2d>> been_m;
  std::vector<OccupiedFloor> standing;  ///< The others.
  std::vector<PromisedLook> promised;   ///< By the others.
};

/// A robot's snapshot with the map of all in place of its own, and with the ways of the others
/// before its own. It stands where it stands.
pipeline::Snapshot with_company(const pipeline::Snapshot& snapshot, const Company& company);

}  // namespace echomap::exploration
