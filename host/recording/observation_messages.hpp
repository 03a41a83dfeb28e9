// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/geometry/pose2.hpp"
#include "host/ros_messages/geometry_msgs.hpp"
#include "host/ros_messages/nav_msgs.hpp"
#include "host/ros_messages/sensor_msgs.hpp"
#include "host/ros_messages/tf2_msgs.hpp"
#include "host/ros_messages/visualization_msgs.hpp"
#include "host/sensors/observations.hpp"

namespace echomap::recording {

/// Frames of REP 105, and the face of the panned sonar.
inline constexpr const char* kMapFrame = "map";
inline constexpr const char* kOdomFrame = "odom";
inline constexpr const char* kRobotFrame = "base_link";
inline constexpr const char* kSonarFrame = "sonar";

/// What a sonar's messages have to say of it.
struct SonarFacts {
  double beam_half_angle_rad = 0.0;
  double min_range_m = 0.0;
  double max_range_m = 0.0;
};

/// Nanoseconds since 1970, or since the session's begin, as a stamp.
ros_messages::Time stamp_of(std::uint64_t time_ns);
ros_messages::Header header_of(std::uint64_t time_ns, const std::string& frame);
ros_messages::Pose pose_of(const geometry::Pose2& T_a_b);
ros_messages::Point point_of(const Eigen::Vector2d& point_m);
/// The transform of `child` in `parent`.
ros_messages::TransformStamped transform_of(std::uint64_t time_ns,
                                            const std::string& parent,
                                            const std::string& child,
                                            const geometry::Pose2& T_parent_child);

/// A reading of a scalar sensor, of which no ROS message is.
struct ScalarReadingMessage {
  static constexpr std::string_view kName = "echomap_msgs/msg/ScalarReading";
  ros_messages::Header header{};
  std::string unit{};  ///< Of the value.
  double value = 0.0;  ///< Pulses per second as they were counted, or a level.
  double count = 0.0;  ///< Pulses; 0 of a level.
  double dwell_s = 0.0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("unit", self.unit);
    visit("value", self.value);
    visit("count", self.count);
    visit("dwell_s", self.dwell_s);
  }
};

/// How fast a robot drives and turns, in its own frame.
struct Speed {
  double forward_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;
};

/// Where the wheels have the robot, in the frame `odom`, and how fast they move it.
ros_messages::Odometry odometry_message(std::uint64_t time_ns,
                                        const geometry::Pose2& T_odom_robot,
                                        const Speed& speed);
/// One ping; infinity without an echo, as REP 117 has it.
ros_messages::Range sonar_message(std::uint64_t time_ns,
                                  const sensors::SonarObservation& ping,
                                  const SonarFacts& sonar);
/// The cone of one ping, from the sonar to its echo, or as far as it reaches.
ros_messages::MarkerArray cone_message(std::uint64_t time_ns,
                                       const sensors::SonarObservation& ping,
                                       const SonarFacts& sonar);
/// One infra-red range.
ros_messages::Range infrared_message(std::uint64_t time_ns,
                                     const std::string& frame,
                                     const std::optional<double>& range_m);
/// What the gyro has turned, as an orientation; it knows no accelerations.
ros_messages::Imu imu_message(std::uint64_t time_ns, const sensors::YawObservation& yaw);
ros_messages::BatteryState battery_message(std::uint64_t time_ns, double voltage_v);
/// A reading of the scalar sensor, whose unit this is.
ScalarReadingMessage scalar_message(std::uint64_t time_ns,
                                    const sensors::ScalarObservation& scalar,
                                    const std::string& unit);

}  // namespace echomap::recording
