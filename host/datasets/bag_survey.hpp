// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/datasets/transform_tree.hpp"
#include "host/mcap/records.hpp"
#include "host/ros_messages/tf2_msgs.hpp"

namespace echomap::datasets {

/// The frame of odometry where only transforms tell of it.
inline constexpr std::string_view kOdometryFrame = "odom";

/// The type of a channel's messages as ROS 2 writes it; empty where the channel has none.
std::string type_of(const mcap::Channel& channel);

/// Adds the transforms of a message; those of a topic `tf_static` hold for good. Such as are no
/// rotations are left out, as ROS does.
void add_transforms(const std::string& topic,
                    const ros_messages::TFMessage& message,
                    TransformTree& tree);

/// What has to be known of a whole bag before its first record: which topics are read, and where
/// the sensors are.
struct BagSurvey {
  std::string odometry_topic;    ///< Empty where transforms tell of odometry, or nothing does.
  std::string laser_topic;       ///< Empty where there is none.
  std::set<std::string> unused;  ///< Topics of sensors that look up or down.
  std::string base_frame;        ///< The robot.
  TransformTree static_transforms;
  std::vector<std::string> notes;  ///< What of the bag is not used, one sentence each.

  /// Where a sensor is on the robot at an instant, by transforms. A sensor whose frame is the
  /// robot's, or has no name, is at the robot's origin. Empty where no transforms lead to it.
  std::optional<SpatialPose> find_sensor(const TransformTree& transforms,
                                         const std::string& frame,
                                         double stamp_s) const;
};

/// Reads a bag once. Throws files::FileError where it has no topic that can be read (with all that
/// it has), where messages are in another encoding than CDR, and where no transform says where a
/// sensor is. Damage ends the survey; who reads the bag then comes upon it.
BagSurvey survey_bag(const std::filesystem::path& path);

}  // namespace echomap::datasets
