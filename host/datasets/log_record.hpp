// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::datasets {

/// What a log says, in SI units and our directions: x forward, y left, counter-clockwise. The
/// records of a log come in the order in which they hold: a pose holds for the scans that follow
/// it. `stamp_s` is seconds of the log's own clock; it rises from record to record of one kind, and
/// is empty where the log has no stamp or one that does not rise.

/// Where the robot believes to be by its own odometry.
struct OdometryPose {
  std::optional<double> stamp_s;
  geometry::Pose2 T_odom_robot;
};

/// What the robot has moved since the last such record, by its own odometry.
struct OdometryStep {
  std::optional<double> stamp_s;
  geometry::Pose2 T_last_now;
};

/// What each wheel has rolled since the last such record, forward positive.
struct WheelIncrement {
  std::optional<double> stamp_s;
  double left_m = 0.0;
  double right_m = 0.0;
  double track_m = 0.0;  ///< Distance between the wheels.
};

/// Direction of the robot by a gyro or compass, counter-clockwise from a direction of its own.
struct Heading {
  std::optional<double> stamp_s;
  double heading_rad = 0.0;
};

/// A corrected or reference pose that the log brings along.
struct GivenPose {
  std::optional<double> stamp_s;
  geometry::Pose2 T_map_robot;
};

/// A reference of the robot's place that does not say which way it looks.
struct GivenPosition {
  std::optional<double> stamp_s;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
};

/// What touches the robot.
struct Contact {
  std::optional<double> stamp_s;
  bool bump_left = false;
  bool bump_right = false;
  double bumper_radius_m = 0.0;  ///< From the middle of the robot to its bumper.
};

/// Something known by its number, seen from the robot.
struct LandmarkSighting {
  std::optional<double> stamp_s;
  std::int64_t id = 0;
  double range_m = 0.0;
  double bearing_rad = 0.0;
};

/// One record of a log.
using LogRecord = std::variant<OdometryPose,
                               OdometryStep,
                               WheelIncrement,
                               Heading,
                               GivenPose,
                               GivenPosition,
                               sensors::RangeScan,
                               Contact,
                               LandmarkSighting>;

/// Of any record.
inline std::optional<double> stamp_s(const LogRecord& record) {
  return std::visit([](const auto& kind) { return kind.stamp_s; }, record);
}

}  // namespace echomap::datasets
