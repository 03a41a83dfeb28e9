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

// Messages from metres, seconds and radians, and back. What goes to whole numbers and back changes
// by half a millimetre, half a millisecond and 0.05 mrad at most; a second time by nothing. A
// conversion is empty where a number is none, or outside of its field's range.
namespace echomap::fleet_messages {

/// A pose that is known to some degree.
struct PoseEstimate {
  geometry::Pose2 T_map_robot;
  /// Of x and y in metres and the heading in radians.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// What a robot is like, as others need it to use what it has sensed.
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

/// Readings by the odometry of one submap, so that they move with it.
struct SourceBatch {
  std::uint32_t submap_index = 0;
  std::vector<SourceReading> readings;  ///< In the order of time.
};

/// What a robot that searches a source tells of it, in its own map.
struct SearchReport {
  source_search::SourceVerdict verdict = source_search::SourceVerdict::kUndecided;
  double probability = 0.0;                         ///< Of the verdict; to 0.001.
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();   ///< Of the source, where it is found.
  double strength = 0.0;                            ///< Of that, one metre away.
  std::vector<source_search::PlannedDwell> plan{};  ///< What the robot is about to read.
};

/// Where a robot's map lies in the frame of its component, and its submaps, where the component's
/// pose graph has moved them.
struct AlignedMap {
  std::string robot;
  std::uint16_t map_number = 0;
  geometry::Pose2 T_component_map;
  std::vector<geometry::Pose2> T_component_submaps;
};

/// The submap as it is sent.
std::optional<SubmapMessage> to_message(const team_map::Submap& submap, std::uint16_t map_number);
/// The submap as it was sent.
team_map::Submap to_submap(const SubmapMessage& message);
/// The submap as every receiver has it. The robot itself uses this one, so that all of them compute
/// the same.
std::optional<team_map::Submap> quantised(const team_map::Submap& submap);

/// The pose graph as it is sent, with the covariance of its last pose.
std::optional<GraphMessage> to_graph_message(const std::vector<geometry::Pose2>& T_map_submaps,
                                             const Eigen::Matrix3d& latest_covariance,
                                             std::uint16_t map_number);
/// Poses as they were sent.
std::vector<geometry::Pose2> to_poses(const std::vector<PoseRow>& rows);

/// The robot's pose as it is sent; `stamp_s` is of its clock.
std::optional<PoseMessage> to_message(const PoseEstimate& pose,
                                      double stamp_s,
                                      std::uint16_t map_number);
/// The robot's pose as it was sent.
PoseEstimate to_pose_estimate(const PoseMessage& message);
/// Symmetric; standard deviations above 65.535 m and 2 pi have become those.
Eigen::Matrix3d to_covariance(const CovariancePart& part);

/// Claims as they are sent, without their robot: that is the message's author. `utility` above
/// 4294 m2/s has become that.
std::optional<ClaimMessage> to_message(const std::vector<team_exploration::Claim>& claims,
                                       std::uint16_t map_number);
/// Claims as they were sent by that robot.
std::vector<team_exploration::Claim> to_claims(const ClaimMessage& message,
                                               const std::string& robot);

/// Readings as they are sent; empty where there is none, too.
std::optional<SourceMessage> to_message(const SourceBatch& batch, std::uint16_t map_number);
/// Readings as they were sent.
SourceBatch to_source_batch(const SourceMessage& message);

/// A searching robot's report as it is sent.
std::optional<SearchMessage> to_message(const SearchReport& report, std::uint16_t map_number);
/// A report as it was sent.
SearchReport to_search_report(const SearchMessage& message);

/// An alignment as it is sent.
std::optional<AlignmentMessage> to_message(const std::vector<AlignedMap>& maps);
/// An alignment as it was sent.
std::vector<AlignedMap> to_aligned_maps(const AlignmentMessage& message);

/// The presence with what the robot is like.
std::optional<PresenceMessage> with_traits(PresenceMessage message, const RobotTraits& traits);
/// What a robot is like that has sent such a presence.
RobotTraits to_traits(const PresenceMessage& message);

}  // namespace echomap::fleet_messages
