// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fastcdr/Cdr.h>

#include "host/ros_messages/nav_msgs.hpp"
#include "host/ros_messages/sensor_msgs.hpp"
#include "host/ros_messages/tf2_msgs.hpp"

// The messages of logs, written and read by the library that most of ROS 2 uses. The calls are
// written by hand after the type's definitions, so that they share nothing with ours.
namespace echomap::tests {

/// Writes the fields of a message with fastcdr's operators, in the order of its definition.
class FastcdrFields {
 public:
  explicit FastcdrFields(eprosima::fastcdr::Cdr& cdr) : cdr_(cdr) {}

  void put(const ros_messages::Header& header) {
    cdr_ << header.stamp.sec << header.stamp.nanosec << header.frame_id;
  }
  void put(const ros_messages::Vector3& vector) { cdr_ << vector.x << vector.y << vector.z; }
  void put(const ros_messages::Quaternion& turn) { cdr_ << turn.x << turn.y << turn.z << turn.w; }
  void put(const ros_messages::Pose& pose) {
    cdr_ << pose.position.x << pose.position.y << pose.position.z;
    put(pose.orientation);
  }
  void put(const ros_messages::Odometry& odometry) {
    put(odometry.header);
    cdr_ << odometry.child_frame_id;
    put(odometry.pose.pose);
    cdr_ << odometry.pose.covariance;
    put(odometry.twist.twist.linear);
    put(odometry.twist.twist.angular);
    cdr_ << odometry.twist.covariance;
  }
  void put(const ros_messages::Range& range) {
    put(range.header);
    cdr_ << range.radiation_type << range.field_of_view << range.min_range << range.max_range
         << range.range;
  }
  void put(const ros_messages::LaserScan& scan) {
    put(scan.header);
    cdr_ << scan.angle_min << scan.angle_max << scan.angle_increment << scan.time_increment
         << scan.scan_time << scan.range_min << scan.range_max << scan.ranges << scan.intensities;
  }
  void put(const ros_messages::TFMessage& message) {
    cdr_ << static_cast<std::uint32_t>(message.transforms.size());
    for (const auto& transform : message.transforms) {
      put(transform.header);
      cdr_ << transform.child_frame_id;
      put(transform.transform.translation);
      put(transform.transform.rotation);
    }
  }
  void put(const ros_messages::OccupancyGrid& grid) {
    put(grid.header);
    cdr_ << grid.info.map_load_time.sec << grid.info.map_load_time.nanosec << grid.info.resolution
         << grid.info.width << grid.info.height;
    put(grid.info.origin);
    cdr_ << grid.data;
  }
  void put(const ros_messages::JointState& state) {
    put(state.header);
    cdr_ << state.name << state.position << state.velocity << state.effort;
  }

 private:
  eprosima::fastcdr::Cdr& cdr_;
};

/// Reads what FastcdrFields writes.
class FastcdrValues {
 public:
  explicit FastcdrValues(eprosima::fastcdr::Cdr& cdr) : cdr_(cdr) {}

  void get(ros_messages::Header& header) {
    cdr_ >> header.stamp.sec >> header.stamp.nanosec >> header.frame_id;
  }
  void get(ros_messages::Vector3& vector) { cdr_ >> vector.x >> vector.y >> vector.z; }
  void get(ros_messages::Quaternion& turn) { cdr_ >> turn.x >> turn.y >> turn.z >> turn.w; }
  void get(ros_messages::Pose& pose) {
    cdr_ >> pose.position.x >> pose.position.y >> pose.position.z;
    get(pose.orientation);
  }
  void get(ros_messages::Odometry& odometry) {
    get(odometry.header);
    cdr_ >> odometry.child_frame_id;
    get(odometry.pose.pose);
    cdr_ >> odometry.pose.covariance;
    get(odometry.twist.twist.linear);
    get(odometry.twist.twist.angular);
    cdr_ >> odometry.twist.covariance;
  }
  void get(ros_messages::Range& range) {
    get(range.header);
    cdr_ >> range.radiation_type >> range.field_of_view >> range.min_range >> range.max_range >>
        range.range;
  }
  void get(ros_messages::LaserScan& scan) {
    get(scan.header);
    cdr_ >> scan.angle_min >> scan.angle_max >> scan.angle_increment >> scan.time_increment >>
        scan.scan_time >> scan.range_min >> scan.range_max >> scan.ranges >> scan.intensities;
  }
  void get(ros_messages::TFMessage& message) {
    std::uint32_t count = 0;
    cdr_ >> count;
    message.transforms.resize(count);
    for (auto& transform : message.transforms) {
      get(transform.header);
      cdr_ >> transform.child_frame_id;
      get(transform.transform.translation);
      get(transform.transform.rotation);
    }
  }
  void get(ros_messages::OccupancyGrid& grid) {
    get(grid.header);
    cdr_ >> grid.info.map_load_time.sec >> grid.info.map_load_time.nanosec >>
        grid.info.resolution >> grid.info.width >> grid.info.height;
    get(grid.info.origin);
    cdr_ >> grid.data;
  }
  void get(ros_messages::JointState& state) {
    get(state.header);
    cdr_ >> state.name >> state.position >> state.velocity >> state.effort;
  }

 private:
  eprosima::fastcdr::Cdr& cdr_;
};

/// A message as fastcdr writes it, of up to 16 KiB.
template <class M>
std::vector<std::uint8_t> fastcdr_bytes(
    const M& message,
    eprosima::fastcdr::Cdr::Endianness endianness = eprosima::fastcdr::Cdr::LITTLE_ENDIANNESS) {
  // It leaves padding as it finds it.
  std::vector<char> zeros(16384);
  eprosima::fastcdr::FastBuffer buffer(zeros.data(), zeros.size());
  eprosima::fastcdr::Cdr cdr(buffer, endianness, eprosima::fastcdr::Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  FastcdrFields(cdr).put(message);
  return {zeros.begin(),
          zeros.begin() + static_cast<std::ptrdiff_t>(cdr.getSerializedDataLength())};
}

/// A message as fastcdr reads it.
template <class M>
M read_by_fastcdr(std::vector<std::uint8_t> bytes) {
  eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  eprosima::fastcdr::Cdr cdr(
      buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN, eprosima::fastcdr::Cdr::DDS_CDR);
  cdr.read_encapsulation();
  M message;
  FastcdrValues(cdr).get(message);
  return message;
}

}  // namespace echomap::tests
