// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "host/ros_messages/geometry_msgs.hpp"

namespace echomap::ros_messages {

/// One reading of a sonar or an infra-red ranger that looks along x of its frame. This is the
/// layout of ROS 2 Humble; later distributions append the variance of the range.
struct Range {
  static constexpr std::string_view kName = "sensor_msgs/msg/Range";
  static constexpr std::uint8_t kUltrasound = 0;
  static constexpr std::uint8_t kInfrared = 1;
  Header header;
  std::uint8_t radiation_type = kUltrasound;
  float field_of_view = 0.0F;  ///< Full width of the cone, radians.
  float min_range = 0.0F;
  float max_range = 0.0F;
  float range = 0.0F;  ///< Metres; without an echo infinite or outside of min .. max.
  bool operator==(const Range&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("radiation_type", self.radiation_type);
    visit("field_of_view", self.field_of_view);
    visit("min_range", self.min_range);
    visit("max_range", self.max_range);
    visit("range", self.range);
  }
};

/// One sweep of a planar laser: ranges at equal steps of angle, counter-clockwise about z.
struct LaserScan {
  static constexpr std::string_view kName = "sensor_msgs/msg/LaserScan";
  Header header;  ///< The stamp is that of the first beam.
  float angle_min = 0.0F;
  float angle_max = 0.0F;
  float angle_increment = 0.0F;
  float time_increment = 0.0F;  ///< Seconds from beam to beam.
  float scan_time = 0.0F;       ///< Seconds from scan to scan.
  float range_min = 0.0F;
  float range_max = 0.0F;
  std::vector<float> ranges;  ///< Metres; outside of range_min .. range_max there was no return.
  std::vector<float> intensities;
  bool operator==(const LaserScan&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("angle_min", self.angle_min);
    visit("angle_max", self.angle_max);
    visit("angle_increment", self.angle_increment);
    visit("time_increment", self.time_increment);
    visit("scan_time", self.scan_time);
    visit("range_min", self.range_min);
    visit("range_max", self.range_max);
    visit("ranges", self.ranges);
    visit("intensities", self.intensities);
  }
};

/// An inertial sensor's orientation, rates and accelerations, each with its 3 x 3 covariance. A
/// first element of -1 in a covariance says that the sensor does not measure that quantity.
struct Imu {
  static constexpr std::string_view kName = "sensor_msgs/msg/Imu";
  Header header;
  Quaternion orientation;
  std::array<double, 9> orientation_covariance{};
  Vector3 angular_velocity;  ///< Radians a second.
  std::array<double, 9> angular_velocity_covariance{};
  Vector3 linear_acceleration;  ///< Metres a second squared.
  std::array<double, 9> linear_acceleration_covariance{};
  bool operator==(const Imu&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("orientation", self.orientation);
    visit("orientation_covariance", self.orientation_covariance);
    visit("angular_velocity", self.angular_velocity);
    visit("angular_velocity_covariance", self.angular_velocity_covariance);
    visit("linear_acceleration", self.linear_acceleration);
    visit("linear_acceleration_covariance", self.linear_acceleration_covariance);
  }
};

/// The state of a battery; what nobody measures is not a number.
struct BatteryState {
  static constexpr std::string_view kName = "sensor_msgs/msg/BatteryState";
  static constexpr std::uint8_t kStatusUnknown = 0;
  static constexpr std::uint8_t kStatusCharging = 1;
  static constexpr std::uint8_t kStatusDischarging = 2;
  static constexpr float kUnmeasured = std::numeric_limits<float>::quiet_NaN();
  Header header;
  float voltage = 0.0F;
  float temperature = kUnmeasured;      ///< Degrees Celsius.
  float current = kUnmeasured;          ///< Amperes, negative while discharging.
  float charge = kUnmeasured;           ///< Ampere-hours.
  float capacity = kUnmeasured;         ///< Ampere-hours when last full.
  float design_capacity = kUnmeasured;  ///< Ampere-hours when new.
  float percentage = kUnmeasured;       ///< 0 .. 1.
  std::uint8_t power_supply_status = kStatusUnknown;
  std::uint8_t power_supply_health = 0;      ///< 0: unknown.
  std::uint8_t power_supply_technology = 0;  ///< 0: unknown.
  bool present = false;
  std::vector<float> cell_voltage;
  std::vector<float> cell_temperature;
  std::string location;
  std::string serial_number;
  bool operator==(const BatteryState&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("voltage", self.voltage);
    visit("temperature", self.temperature);
    visit("current", self.current);
    visit("charge", self.charge);
    visit("capacity", self.capacity);
    visit("design_capacity", self.design_capacity);
    visit("percentage", self.percentage);
    visit("power_supply_status", self.power_supply_status);
    visit("power_supply_health", self.power_supply_health);
    visit("power_supply_technology", self.power_supply_technology);
    visit("present", self.present);
    visit("cell_voltage", self.cell_voltage);
    visit("cell_temperature", self.cell_temperature);
    visit("location", self.location);
    visit("serial_number", self.serial_number);
  }
};

/// Joints by name: radians or metres, their rates and efforts. A list that is not known is empty.
struct JointState {
  static constexpr std::string_view kName = "sensor_msgs/msg/JointState";
  Header header;
  std::vector<std::string> name;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> effort;
  bool operator==(const JointState&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("name", self.name);
    visit("position", self.position);
    visit("velocity", self.velocity);
    visit("effort", self.effort);
  }
};

/// A picture as the bytes of a file, whose format is named: "jpeg", "png".
struct CompressedImage {
  static constexpr std::string_view kName = "sensor_msgs/msg/CompressedImage";
  Header header;
  std::string format;
  std::vector<std::uint8_t> data;
  bool operator==(const CompressedImage&) const = default;

  template <class M, class V>
  static void fields(M& self, V& visit) {
    visit("header", self.header);
    visit("format", self.format);
    visit("data", self.data);
  }
};

}  // namespace echomap::ros_messages
