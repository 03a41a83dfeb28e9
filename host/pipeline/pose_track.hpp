// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/pipeline/robot_slam.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/odometry.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::pipeline {

/// Where a robot is and was. Its wheels' odometry leads to the map by two corrections: SLAM's and
/// that of a camera. The stamps of the trajectory rise.
class PoseTrack {
 public:
  /// `slam` is null for odometry alone.
  PoseTrack(double track_m, std::unique_ptr<slam::SlamMethod> slam, double beam_width_rad);

  /// Appends a pose where the stamp rises. Returns the pose by odometry alone.
  geometry::Pose2 follow(time::RobotTime stamp, const sensors::WheelTravel& travel);
  geometry::Pose2 follow(time::RobotTime stamp, const geometry::Pose2& T_odom_robot);
  /// The robot was put down there.
  void carry(const sensors::CarriedObservation& observation);
  /// A camera has the robot there.
  void fix(const geometry::Pose2& T_map_robot);
  /// Moves all poses to where SLAM has them now, and returns these.
  std::vector<geometry::Pose2> apply_corrected_trajectory();
  /// All poses where SLAM has them now.
  std::vector<StampedPose> corrected_trajectory() const;
  /// The last pose is where the corrections of now have the robot.
  void update_last_pose();

  /// From odometry to the map.
  geometry::Pose2 T_map_odom() const;
  geometry::Pose2 T_map_robot() const { return T_map_odom() * T_odom_robot_; }
  PoseEstimate estimate() const;
  const geometry::Pose2& T_odom_robot() const { return T_odom_robot_; }
  /// From SLAM's map to the camera's.
  const geometry::Pose2& T_map_slam() const { return T_map_mapped_; }
  /// The last pose of the trajectory; before it, at the stamp 0.
  StampedPose latest() const {
    return trajectory_->empty() ? StampedPose{{}, T_map_robot()} : trajectory_->back();
  }
  std::size_t poses() const { return trajectory_->size(); }
  /// Where the robot's centre has been, some centimetres apart.
  std::vector<Eigen::Vector2d> positions_m() const;
  /// What odometry has placed, on the map.
  template <class Placed>
  Placed on_map(const Placed& by_odometry) const {
    return mapping::moved(by_odometry, T_map_odom());
  }

  /// Null without SLAM.
  RobotSlam* slam() { return slam_ ? &*slam_ : nullptr; }
  const RobotSlam* slam() const { return slam_ ? &*slam_ : nullptr; }
  void describe(Snapshot& snapshot) const;

 private:
  sensors::WheelOdometry odometry_;
  geometry::Pose2 T_odom_robot_;
  std::optional<RobotSlam> slam_;
  geometry::Pose2 T_map_mapped_;  ///< The camera's correction.
  std::shared_ptr<std::vector<StampedPose>> trajectory_ =
      std::make_shared<std::vector<StampedPose>>();
  std::vector<std::size_t> carried_to_;  ///< Indices of the trajectory.
};

}  // namespace echomap::pipeline
