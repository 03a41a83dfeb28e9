// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/fleet_messages/messages.hpp"
#include "host/geometry/pose2.hpp"
#include "host/source_search/information_gain.hpp"
#include "host/source_search/source_estimate.hpp"
#include "host/team_exploration/team_view.hpp"
#include "host/team_map/submap.hpp"

// Conversions between metres, seconds and radians and the whole numbers of messages. Rounding
// changes a value by half a millimetre, half a millisecond and 0.05 mrad at most; rounding it again
// changes nothing. A conversion to a message is empty where a value is not a number or outside of
// its field's range.
namespace echomap::fleet_messages {

/// A pose with its covariance.
struct PoseEstimate {
  geometry::Pose2 T_map_robot;
  /// Covariance of x and y in metres and the heading in radians.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Properties of a robot that others need to use its readings.
struct RobotTraits {
  double body_radius_m = 0.0;
  double beam_half_angle_rad = 0.2269;  ///< Of its sonar.
};

/// A reading of a scalar sensor: pulses of a Geiger tube, or a level of light or gas.
struct SourceReading {
  double stamp_s = 0.0;  ///< On the robot's clock.
  geometry::Pose2 T_odom_robot;
  double value = 0.0;    ///< Pulses, or the level in the sensor's unit; to 0.001.
  double dwell_s = 0.0;  ///< For how long pulses were counted; 0 for a level.
};

/// Readings in the odometry frame of one submap, so that they move with it.
struct SourceBatch {
  std::uint32_t submap_index = 0;
  std::vector<SourceReading> readings;  ///< In the order of time.
};

/// What a robot that searches a source reports of it, in its own map frame.
struct SearchReport {
  source_search::SourceVerdict verdict = source_search::SourceVerdict::kUndecided;
  double probability = 0.0;                         ///< Probability of the verdict; to 0.001.
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();   ///< Position of the source, where it is found.
  double strength = 0.0;                            ///< Strength of the source, one metre away.
  std::vector<source_search::PlannedDwell> plan{};  ///< What the robot is about to read.
};

/// Pose of a robot's map in the frame of its component, and of its submaps where the component's
/// pose graph has moved them.
struct AlignedMap {
  std::string robot;
  std::uint16_t map_number = 0;
  geometry::Pose2 T_component_map;
  std::vector<geometry::Pose2> T_component_submaps;
};

/// Converts a submap to a message.
std::optional<SubmapMessage> to_message(const team_map::Submap& submap, std::uint16_t map_number);
/// Converts a message back to a submap.
team_map::Submap to_submap(const SubmapMessage& message);
/// The submap as every receiver has it. The robot itself uses this one, so that all of them compute
/// the same.
std::optional<team_map::Submap> quantised(const team_map::Submap& submap);

/// Converts a pose graph, with the covariance of its last pose, to a message.
std::optional<GraphMessage> to_graph_message(const std::vector<geometry::Pose2>& T_map_submaps,
                                             const Eigen::Matrix3d& latest_covariance,
                                             std::uint16_t map_number);
/// Converts rows back to poses.
std::vector<geometry::Pose2> to_poses(const std::vector<PoseRow>& rows);

/// Converts a robot's pose to a message; `stamp_s` is on the robot's clock.
std::optional<PoseMessage> to_message(const PoseEstimate& pose,
                                      double stamp_s,
                                      std::uint16_t map_number);
/// Converts a message back to a robot's pose.
PoseEstimate to_pose_estimate(const PoseMessage& message);
/// Converts a message's covariance back to a symmetric matrix. Standard deviations saturate
/// at 65.535 m and 2 pi.
Eigen::Matrix3d to_covariance(const CovariancePart& part);

/// Converts claims to a message, without their robot, which is the message's author. `utility`
/// saturates at 4294 m2/s.
std::optional<ClaimMessage> to_message(const std::vector<team_exploration::Claim>& claims,
                                       std::uint16_t map_number);
/// Converts a message of that robot back to claims.
std::vector<team_exploration::Claim> to_claims(const ClaimMessage& message,
                                               const std::string& robot);

/// Converts readings to a message; empty where there is no reading, too.
std::optional<SourceMessage> to_message(const SourceBatch& batch, std::uint16_t map_number);
/// Converts a message back to readings.
SourceBatch to_source_batch(const SourceMessage& message);

/// Converts the report of a robot that searches a source to a message.
std::optional<SearchMessage> to_message(const SearchReport& report, std::uint16_t map_number);
/// Converts a message back to a search report.
SearchReport to_search_report(const SearchMessage& message);

/// Converts an alignment to a message.
std::optional<AlignmentMessage> to_message(const std::vector<AlignedMap>& maps);
/// Converts a message back to an alignment.
std::vector<AlignedMap> to_aligned_maps(const AlignmentMessage& message);

/// Adds the robot's traits to a presence message.
std::optional<PresenceMessage> with_traits(PresenceMessage message, const RobotTraits& traits);
/// Traits of the robot that has sent a presence message.
RobotTraits to_traits(const PresenceMessage& message);

}  // namespace echomap::fleet_messages
