// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/fleet_messages/conversions.hpp"
#include "host/team_exploration/team_view.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::fleet {

/// Whether a robot takes part.
enum class Attendance : std::uint8_t {
  kAlive,
  kLeft,  ///< It has said good-bye.
  kGone,  ///< Its last will has come, or nothing for a while.
};

/// Where a robot said it is.
struct FleetPose {
  fleet_messages::PoseEstimate estimate;
  std::uint16_t map_number = 0;
  double stamp_s = 0.0;  ///< On its own clock.
  double age_s = 0.0;    ///< Since it was heard.
  /// Forward, on the way from the pose before; zero where that is long ago.
  double speed_m_per_s = 0.0;
};

/// One map of a robot. A robot that was carried away, or whose host has started again, has several.
struct FleetMap {
  std::uint16_t number = 0;
  /// Submaps from the first on as far as there is no gap and the pose graph has them. Never null.
  std::shared_ptr<const team_map::RobotRecord> record;
  Eigen::Matrix3d latest_covariance = Eigen::Matrix3d::Zero();  ///< Of the last pose of its graph.
  /// By submap; each once. Never null.
  std::shared_ptr<const std::vector<fleet_messages::SourceBatch>> source_batches;
};

/// All that one robot has told.
struct FleetRobot {
  std::string name;
  double age_s = 0.0;  ///< Since it was heard.
  fleet_messages::RobotTraits traits;
  std::vector<FleetMap> maps;  ///< In ascending order of their numbers.
  std::optional<FleetPose> pose;
  /// In its map of `claims_map_number`; none of a robot that is not alive.
  std::vector<team_exploration::Claim> claims;
  /// In its map of `search_map_number`; empty where it does not search.
  std::optional<fleet_messages::SearchReport> search;
  std::vector<fleet_messages::AlignedMap> alignment;
  std::size_t known_objects = 0;          ///< How many objects it has, of whomever,
  fleet_messages::ContentHash known_set;  ///< and the hash of their set.
  std::uint16_t map_number = 0;           ///< Of the map that it is making now.
  std::uint16_t claims_map_number = 0;
  std::uint16_t search_map_number = 0;
  Attendance attendance = Attendance::kAlive;
  bool is_heard = false;  ///< By itself; otherwise all that is known was kept by others.
};

/// What one robot knows of its fleet, itself included, all of it as it was sent: in whole
/// millimetres, so that all robots compute the same.
struct FleetState {
  std::vector<FleetRobot> robots;  ///< By name.
  std::size_t objects = 0;         ///< Submaps and source batches, of all robots.
  fleet_messages::ContentHash object_set;
  /// Grows with each change of a record, a source batch or an alignment.
  std::uint64_t revision = 0;
};

}  // namespace echomap::fleet
