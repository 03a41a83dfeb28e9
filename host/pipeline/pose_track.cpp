// SPDX-License-Identifier: MIT
#include "host/pipeline/pose_track.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "host/localization/pose_gaussian.hpp"
#include "host/pipeline/detached.hpp"

namespace echomap::pipeline {

PoseTrack::PoseTrack(double track_m, std::unique_ptr<slam::SlamMethod> slam, double beam_width_rad)
    : odometry_(track_m) {
  if (slam) {
    slam_.emplace(std::move(slam), beam_width_rad);
  }
}

geometry::Pose2 PoseTrack::follow(time::RobotTime stamp, const sensors::WheelTravel& travel) {
  return follow(stamp, odometry_.update(travel));
}

geometry::Pose2 PoseTrack::follow(time::RobotTime stamp, const geometry::Pose2& T_odom_robot) {
  T_odom_robot_ = T_odom_robot;
  if (trajectory_->empty() || stamp > trajectory_->back().stamp) {
    if (slam_) {
      slam_->follow(T_odom_robot);
    }
    detached(trajectory_).push_back({stamp, T_map_robot()});
  }
  return T_odom_robot;
}

void PoseTrack::carry(const sensors::CarriedObservation& observation) {
  carried_to_.push_back(trajectory_->size());
  odometry_.move_to(T_map_odom().inverse() * observation.T_map_robot, observation.travel);
  if (slam_) {
    slam_->carry(odometry_.T_odom_robot());
  }
  follow(observation.stamp, observation.travel);
}

void PoseTrack::fix(const geometry::Pose2& T_map_robot) {
  T_map_mapped_ = T_map_robot * (T_map_mapped_.inverse() * this->T_map_robot()).inverse();
  if (!trajectory_->empty()) {
    detached(trajectory_).back().T_map_robot = T_map_robot;
  }
}

std::vector<geometry::Pose2> PoseTrack::apply_corrected_trajectory() {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): only a SLAM method corrects
  std::vector<geometry::Pose2> T_map_robots = slam_->trajectory();
  auto& trajectory = detached(trajectory_);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    trajectory[i].T_map_robot = T_map_robots[i];
  }
  return T_map_robots;
}

std::vector<StampedPose> PoseTrack::corrected_trajectory() const {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): only a SLAM method corrects
  const std::vector<geometry::Pose2> T_slam_robots = slam_->trajectory();
  std::vector<StampedPose> trajectory = *trajectory_;
  // While a stop is open, its poses are held back.
  for (std::size_t i = 0; i < std::min(trajectory.size(), T_slam_robots.size()); ++i) {
    trajectory[i].T_map_robot = T_map_mapped_ * T_slam_robots[i];
  }
  return trajectory;
}

void PoseTrack::update_last_pose() {
  if (!trajectory_->empty()) {
    detached(trajectory_).back().T_map_robot = T_map_robot();
  }
}

std::vector<Eigen::Vector2d> PoseTrack::positions_m() const {
  constexpr double kApartM = 0.04;
  std::vector<Eigen::Vector2d> positions_m;
  for (const StampedPose& pose : *trajectory_) {
    const Eigen::Vector2d& position_m = pose.T_map_robot.position_m();
    if (positions_m.empty() || (position_m - positions_m.back()).norm() >= kApartM) {
      positions_m.push_back(position_m);
    }
  }
  return positions_m;
}

geometry::Pose2 PoseTrack::T_map_odom() const {
  return slam_ ? T_map_mapped_ * slam_->T_map_odom() : T_map_mapped_;
}

PoseEstimate PoseTrack::estimate() const {
  PoseEstimate estimate{T_map_robot(), T_odom_robot_, std::nullopt};
  if (slam_) {
    Eigen::Matrix3d to_map = Eigen::Matrix3d::Identity();
    to_map.topLeftCorner<2, 2>() =
        Eigen::Rotation2Dd(T_map_mapped_.heading_rad()).toRotationMatrix();
    estimate.covariance = to_map * slam_->method().belief().covariance * to_map.transpose();
  }
  return estimate;
}

void PoseTrack::describe(Snapshot& snapshot) const {
  if (!trajectory_->empty()) {
    snapshot.latest = trajectory_->back();
  }
  if (slam_) {
    snapshot.position_stddev_m = localization::position_stddev_m(slam_->method().belief());
  }
  snapshot.T_odom_robot = T_odom_robot_;
  snapshot.trajectory = trajectory_;
  snapshot.carried_to = carried_to_;
}

}  // namespace echomap::pipeline
