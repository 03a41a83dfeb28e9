// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "host/datasets/log_record.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::pipeline {

/// Which of a log's poses count.
enum class PoseSource : std::uint8_t {
  kOdometry,  ///< What the robot believed, from where its log begins.
  kGiven,     ///< What the log gives as corrected or true; between two of them, odometry goes on.
};

/// Follows a robot through its log.
class LogPoses {
 public:
  explicit LogPoses(PoseSource source) : source_(source) {}

  /// Takes what a record says of the robot's place; answers whether it says anything of use.
  bool follow(const datasets::LogRecord& record);
  /// Where the robot is; empty before the first given pose, where those count. By odometry it is at
  /// the origin before the log says otherwise.
  std::optional<geometry::Pose2> T_map_robot() const;

  /// How many records the log had of either source.
  std::size_t odometry_records() const { return odometry_records_; }
  std::size_t given_records() const { return given_records_; }

 private:
  bool take(const datasets::OdometryPose& pose);
  bool take(const datasets::OdometryStep& step);
  bool take(const datasets::WheelIncrement& wheels);
  bool take(const datasets::Heading& heading);
  bool take(const datasets::GivenPose& pose);
  template <class Other>
  bool take(const Other& /*says_nothing_of_the_pose*/) {
    return false;
  }
  bool moved();

  PoseSource source_;
  geometry::Pose2 T_odom_robot_;
  std::optional<geometry::Pose2> T_map_odom_;  ///< Since the last given pose.
  /// The direction that a gyro gave last, and the one that the wheels' last increment ended with.
  std::optional<double> heading_rad_;
  std::optional<double> used_heading_rad_;
  std::size_t odometry_records_ = 0;
  std::size_t given_records_ = 0;
};

}  // namespace echomap::pipeline
