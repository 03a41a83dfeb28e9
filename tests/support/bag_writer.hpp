// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mcap/mcap_writer.hpp"
#include "host/ros_messages/message_definition.hpp"
#include "host/ros_messages/nav_msgs.hpp"
#include "host/ros_messages/sensor_msgs.hpp"
#include "host/ros_messages/serialization.hpp"
#include "host/ros_messages/tf2_msgs.hpp"

namespace echomap::tests {

/// Writes a bag as `ros2 bag record` does.
class BagWriter {
 public:
  explicit BagWriter(const std::filesystem::path& path,
                     mcap::Compression compression = mcap::Compression::kNone)
      : writer_({"ros2", "rosbag2"}, {.compression = compression}) {
    writer_.open(path);
  }

  /// A message that the recorder received at that time, seconds.
  template <ros_messages::Message M>
  void write(const std::string& topic, const M& message, double log_time_s) {
    write_bytes(topic, std::string(M::kName), ros_messages::serialize(message), log_time_s);
  }
  void write_bytes(const std::string& topic,
                   const std::string& type,
                   std::span<const std::uint8_t> bytes,
                   double log_time_s,
                   const std::string& encoding = "cdr") {
    auto known = channels_.find(topic);
    if (known == channels_.end()) {
      const auto schema = writer_.add_schema({type, "ros2msg", ""});
      known = channels_.emplace(topic, writer_.add_channel({topic, schema, encoding, {}})).first;
    }
    const auto time_ns = static_cast<std::uint64_t>(std::llround(log_time_s * 1e9));
    writer_.write(known->second, time_ns, time_ns, bytes);
  }
  void flush() { writer_.flush(); }
  void finish() { writer_.finish(); }

 private:
  mcap::McapWriter writer_;
  std::map<std::string, std::uint16_t> channels_;
};

/// A header of an instant, seconds.
inline ros_messages::Header ros_header(double stamp_s, const std::string& frame) {
  const double whole_s = std::floor(stamp_s);
  const auto nanoseconds = std::llround((stamp_s - whole_s) * 1e9);
  return {{static_cast<std::int32_t>(whole_s), static_cast<std::uint32_t>(nanoseconds)}, frame};
}

/// A turn about z.
inline ros_messages::Quaternion ros_turn(double yaw_rad) {
  return {0.0, 0.0, std::sin(yaw_rad / 2.0), std::cos(yaw_rad / 2.0)};
}

/// Odometry of a robot whose frame is base_link.
inline ros_messages::Odometry ros_odometry(double stamp_s, const geometry::Pose2& T_odom_robot) {
  ros_messages::Odometry odometry;
  odometry.header = ros_header(stamp_s, "odom");
  odometry.child_frame_id = "base_link";
  odometry.pose.pose.position = {T_odom_robot.x_m(), T_odom_robot.y_m(), 0.0};
  odometry.pose.pose.orientation = ros_turn(T_odom_robot.heading_rad());
  return odometry;
}

/// A reading of a sonar of 15 degrees and 0.02 .. 4 m.
inline ros_messages::Range ros_range(double stamp_s, const std::string& frame, double range_m) {
  ros_messages::Range range;
  range.header = ros_header(stamp_s, frame);
  range.field_of_view = 0.26F;
  range.min_range = 0.02F;
  range.max_range = 4.0F;
  range.range = static_cast<float>(range_m);
  return range;
}

/// One transform of the plane.
inline ros_messages::TFMessage ros_transform(double stamp_s,
                                             const std::string& parent,
                                             const std::string& child,
                                             const geometry::Pose2& T_parent_child) {
  ros_messages::TransformStamped transform;
  transform.header = ros_header(stamp_s, parent);
  transform.child_frame_id = child;
  transform.transform.translation = {T_parent_child.x_m(), T_parent_child.y_m(), 0.1};
  transform.transform.rotation = ros_turn(T_parent_child.heading_rad());
  return {{transform}};
}

}  // namespace echomap::tests
