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

/// Whether a robot takes part in its fleet.
enum class Attendance : std::uint8_t {
  kAlive,
  kLeft,  ///< It has announced that it leaves.
  kGone,  ///< Its last will was received, or nothing for a while.
};

/// Pose that a robot has published.
struct FleetPose {
  fleet_messages::PoseEstimate estimate;
  std::uint16_t map_number = 0;
  double stamp_s = 0.0;  ///< On the robot's clock.
  double age_s = 0.0;    ///< Since it was received.
  /// Forward speed since the pose before; zero where that one is too old.
  double speed_m_per_s = 0.0;
};

/// One map of a robot. A robot that was carried away, or whose host has started again, has several.
struct FleetMap {
  std::uint16_t number = 0;
  /// Submaps from the first one up to the first gap, as far as the pose graph covers them. Never
  /// null.
  std::shared_ptr<const team_map::RobotRecord> record;
  Eigen::Matrix3d latest_covariance = Eigen::Matrix3d::Zero();  ///< Of the last pose of its graph.
  /// Source batches in the order of their submaps, each once. Never null.
  std::shared_ptr<const std::vector<fleet_messages::SourceBatch>> source_batches;
};

/// All that one robot has published.
struct FleetRobot {
  std::string name;
  double age_s = 0.0;  ///< Since its last message.
  fleet_messages::RobotTraits traits;
  std::vector<FleetMap> maps;  ///< In ascending order of their numbers.
  std::optional<FleetPose> pose;
  /// Claims in its map `claims_map_number`; none for a robot that is not alive.
  std::vector<team_exploration::Claim> claims;
  /// Search report in its map `search_map_number`; empty where it does not search.
  std::optional<fleet_messages::SearchReport> search;
  std::vector<fleet_messages::AlignedMap> alignment;
  std::size_t known_objects = 0;          ///< Number of objects that it has, of any robot,
  fleet_messages::ContentHash known_set;  ///< and the hash of their set.
  std::uint16_t map_number = 0;           ///< Map that it is building now.
  std::uint16_t claims_map_number = 0;
  std::uint16_t search_map_number = 0;
  Attendance attendance = Attendance::kAlive;
  bool has_reported = false;  ///< It has sent a message itself; otherwise all comes from others.
};

/// What one robot knows of its fleet, itself included. All values are as they were sent, in whole
/// millimetres, so that all robots compute the same.
struct FleetState {
  std::vector<FleetRobot> robots;  ///< By name.
  std::size_t objects = 0;         ///< Submaps and source batches, of all robots.
  fleet_messages::ContentHash object_set;
  /// Grows with each change of a record, a source batch or an alignment.
  std::uint64_t revision = 0;
};

}  // namespace echomap::fleet
