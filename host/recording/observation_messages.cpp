// SPDX-License-Identifier: MIT
#include "host/recording/observation_messages.hpp"

#include <cmath>
#include <limits>

#include "host/geometry/unit_vector.hpp"

namespace echomap::recording {
namespace {

using namespace ros_messages;

constexpr std::uint64_t kNanosecondsPerSecond = 1'000'000'000;
/// First element of a covariance whose quantity is not measured (sensor_msgs/Imu).
constexpr double kUnknownCovariance = -1.0;
constexpr float kNoEcho = std::numeric_limits<float>::infinity();
/// A cone is drawn with so many sides at its far end.
constexpr int kArcSides = 6;
constexpr double kConeLineM = 0.01;

Quaternion turned_by(double yaw_rad) {
  return {0.0, 0.0, std::sin(0.5 * yaw_rad), std::cos(0.5 * yaw_rad)};
}

}  // namespace

Time stamp_of(std::uint64_t time_ns) {
  return {static_cast<std::int32_t>(time_ns / kNanosecondsPerSecond),
          static_cast<std::uint32_t>(time_ns % kNanosecondsPerSecond)};
}

Header header_of(std::uint64_t time_ns, const std::string& frame) {
  return {stamp_of(time_ns), frame};
}

Pose pose_of(const geometry::Pose2& T_a_b) {
  return {{T_a_b.x_m(), T_a_b.y_m(), 0.0}, turned_by(T_a_b.heading_rad())};
}

Point point_of(const Eigen::Vector2d& point_m) { return {point_m.x(), point_m.y(), 0.0}; }

TransformStamped transform_of(std::uint64_t time_ns,
                              const std::string& parent,
                              const std::string& child,
                              const geometry::Pose2& T_parent_child) {
  return {
      header_of(time_ns, parent),
      child,
      {{T_parent_child.x_m(), T_parent_child.y_m(), 0.0}, turned_by(T_parent_child.heading_rad())}};
}

Odometry odometry_message(std::uint64_t time_ns,
                          const geometry::Pose2& T_odom_robot,
                          const Speed& speed) {
  Odometry message;
  message.header = header_of(time_ns, kOdomFrame);
  message.child_frame_id = kRobotFrame;
  message.pose.pose = pose_of(T_odom_robot);
  message.twist.twist.linear.x = speed.forward_m_per_s;
  message.twist.twist.angular.z = speed.turn_rad_per_s;
  return message;
}

Range sonar_message(std::uint64_t time_ns,
                    const sensors::SonarObservation& ping,
                    const SonarFacts& sonar) {
  Range message;
  message.header = header_of(time_ns, kSonarFrame);
  message.radiation_type = Range::kUltrasound;
  message.field_of_view = static_cast<float>(2.0 * sonar.beam_half_angle_rad);
  message.min_range = static_cast<float>(sonar.min_range_m);
  message.max_range = static_cast<float>(sonar.max_range_m);
  message.range = !ping.has_answered ? BatteryState::kUnmeasured
                  : ping.range_m     ? static_cast<float>(*ping.range_m)
                                     : kNoEcho;
  return message;
}

MarkerArray cone_message(std::uint64_t time_ns,
                         const sensors::SonarObservation& ping,
                         const SonarFacts& sonar) {
  Marker cone;
  cone.header = header_of(time_ns, kSonarFrame);
  cone.ns = "cone";
  cone.type = Marker::kLineStrip;
  cone.pose.orientation.w = 1.0;
  cone.scale.x = kConeLineM;
  cone.color =
      ping.range_m ? ColorRGBA{0.90F, 0.62F, 0.0F, 0.9F} : ColorRGBA{0.5F, 0.5F, 0.5F, 0.4F};
  const double reach_m = ping.range_m.value_or(sonar.max_range_m);
  cone.points.reserve(kArcSides + 3);
  cone.points.push_back({});
  for (int i = 0; i <= kArcSides; ++i) {
    const double bearing_rad = sonar.beam_half_angle_rad * (2.0 * i / kArcSides - 1.0);
    cone.points.push_back(point_of(reach_m * geometry::unit_vector(bearing_rad)));
  }
  cone.points.push_back({});
  return {{cone}};
}

Range infrared_message(std::uint64_t time_ns,
                       const std::string& frame,
                       const std::optional<double>& range_m) {
  Range message;
  message.header = header_of(time_ns, frame);
  message.radiation_type = Range::kInfrared;
  message.max_range = kNoEcho;
  message.range = range_m ? static_cast<float>(*range_m) : kNoEcho;
  return message;
}

Imu imu_message(std::uint64_t time_ns, const sensors::YawObservation& yaw) {
  Imu message;
  message.header = header_of(time_ns, kRobotFrame);
  message.orientation = turned_by(yaw.yaw.yaw_rad);
  message.angular_velocity_covariance[0] = kUnknownCovariance;
  message.linear_acceleration_covariance[0] = kUnknownCovariance;
  return message;
}

BatteryState battery_message(std::uint64_t time_ns, double voltage_v) {
  BatteryState message;
  message.header = header_of(time_ns, kRobotFrame);
  message.voltage = static_cast<float>(voltage_v);
  message.present = true;
  return message;
}

ScalarReadingMessage scalar_message(std::uint64_t time_ns,
                                    const sensors::ScalarObservation& scalar,
                                    const std::string& unit) {
  const bool is_pulses = scalar.dwell_s > 0.0;
  return {header_of(time_ns, kRobotFrame),
          unit,
          is_pulses ? scalar.count / scalar.dwell_s : scalar.count,
          is_pulses ? scalar.count : 0.0,
          scalar.dwell_s};
}

}  // namespace echomap::recording
