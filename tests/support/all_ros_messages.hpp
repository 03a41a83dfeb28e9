// SPDX-License-Identifier: MIT
#pragma once

#include "host/ros_messages/builtin_interfaces.hpp"
#include "host/ros_messages/diagnostic_msgs.hpp"
#include "host/ros_messages/geometry_msgs.hpp"
#include "host/ros_messages/nav_msgs.hpp"
#include "host/ros_messages/rcl_interfaces.hpp"
#include "host/ros_messages/sensor_msgs.hpp"
#include "host/ros_messages/std_msgs.hpp"
#include "host/ros_messages/tf2_msgs.hpp"
#include "host/ros_messages/visualization_msgs.hpp"

namespace echomap::tests {

/// A compile-time list of ROS messages.
template <class... Messages>
struct RosMessageList {
  /// Calls `visit.template operator()<M>()` for each message M in order.
  template <class Visit>
  static void for_each(Visit&& visit) {
    (visit.template operator()<Messages>(), ...);
  }
};

/// Every message of host/ros_messages.
using AllRosMessages = RosMessageList<ros_messages::Time,
                                      ros_messages::Duration,
                                      ros_messages::Header,
                                      ros_messages::ColorRGBA,
                                      ros_messages::String,
                                      ros_messages::Point,
                                      ros_messages::Vector3,
                                      ros_messages::Quaternion,
                                      ros_messages::Pose,
                                      ros_messages::Pose2D,
                                      ros_messages::PoseStamped,
                                      ros_messages::PoseWithCovariance,
                                      ros_messages::PoseWithCovarianceStamped,
                                      ros_messages::PoseArray,
                                      ros_messages::Transform,
                                      ros_messages::TransformStamped,
                                      ros_messages::Twist,
                                      ros_messages::TwistWithCovariance,
                                      ros_messages::Range,
                                      ros_messages::LaserScan,
                                      ros_messages::Imu,
                                      ros_messages::BatteryState,
                                      ros_messages::JointState,
                                      ros_messages::CompressedImage,
                                      ros_messages::Odometry,
                                      ros_messages::Path,
                                      ros_messages::MapMetaData,
                                      ros_messages::OccupancyGrid,
                                      ros_messages::TFMessage,
                                      ros_messages::UVCoordinate,
                                      ros_messages::MeshFile,
                                      ros_messages::Marker,
                                      ros_messages::MarkerArray,
                                      ros_messages::KeyValue,
                                      ros_messages::DiagnosticStatus,
                                      ros_messages::DiagnosticArray,
                                      ros_messages::Log>;

}  // namespace echomap::tests
