// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/datasets/transform_tree.hpp"
#include "host/geometry/pose2.hpp"
#include "host/ros_messages/geometry_msgs.hpp"
#include "host/ros_messages/sensor_msgs.hpp"
#include "host/sensors/range_scan.hpp"

// What ROS messages say, in our units. Functions that throw files::FileError name the field and why
// it cannot be used; who calls them knows the file and the topic.
namespace echomap::datasets {

/// A beam or the plane of a laser may be so much off the horizontal, radians.
inline constexpr double kMaxTiltRad = 0.52;

/// Seconds since the epoch of the stamp's clock.
double seconds_of(const ros_messages::Time& stamp);

/// The name of a frame without the slash before it, which older drivers write.
std::string frame_name(std::string_view frame_id);

/// A pose in space. Throws files::FileError where its position is farther than 1e9 m or none, and
/// where its quaternion is far from unit length.
SpatialPose spatial_pose(const ros_messages::Pose& pose);
SpatialPose spatial_pose(const ros_messages::Transform& transform);

/// The part of a pose that is in the plane: x, y and the direction of its x axis.
geometry::Pose2 planar_pose(const SpatialPose& pose);

/// One reading as a scan of one beam along x of the sensor's frame, without stamp and place. A
/// range outside of the sensor's limits, or beyond 20 m, is silence. Throws files::FileError, also
/// for a cone of more than a right angle.
sensors::RangeScan scan_of(const ros_messages::Range& range);
/// The sweep of a laser, without stamp and place. Throws files::FileError.
sensors::RangeScan scan_of(const ros_messages::LaserScan& sweep);

/// Places a scan on the robot; bearings of a laser that is mounted upside down change their sign.
/// False where its beams look up or down by more than kMaxTiltRad: such a scan is none of the
/// plane.
bool place_on_robot(const SpatialPose& T_robot_sensor, sensors::RangeScan& scan);

}  // namespace echomap::datasets
