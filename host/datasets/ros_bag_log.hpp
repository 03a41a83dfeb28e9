// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "host/datasets/log_reader.hpp"

namespace echomap::datasets {

/// A bag of ROS 2 as an MCAP file, or the folder that `ros2 bag record` makes of several: ranges
/// (sensor_msgs/Range) of every topic, the scans of a laser (sensor_msgs/LaserScan), odometry
/// (nav_msgs/Odometry, or the transform from odom to the robot) and where the sensors are
/// (tf2_msgs/TFMessage).
///
/// Records are sorted by the stamps of their headers; a message that the recorder received half a
/// second or more after one with a later stamp stays behind it.
std::unique_ptr<LogReader> open_ros_bag_log(const std::filesystem::path& path);

}  // namespace echomap::datasets
