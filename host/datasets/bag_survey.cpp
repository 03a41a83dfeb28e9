// SPDX-License-Identifier: MIT
#include "host/datasets/bag_survey.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <map>
#include <utility>

#include "host/datasets/bag_files.hpp"
#include "host/datasets/ros_observations.hpp"
#include "host/files/atomic_file.hpp"
#include "host/ros_messages/nav_msgs.hpp"
#include "host/ros_messages/sensor_msgs.hpp"
#include "host/ros_messages/serialization.hpp"

namespace echomap::datasets {
namespace {

/// As the stamp that asks for the last of what is known.
constexpr double kLatest = std::numeric_limits<double>::max();
constexpr std::array<std::string_view, 2> kBaseFrames{"base_footprint", "base_link"};
constexpr std::array kReadTypes{ros_messages::Odometry::kName,
                                ros_messages::Range::kName,
                                ros_messages::LaserScan::kName,
                                ros_messages::TFMessage::kName};

/// Collects what a BagSurvey says, message by message.
class Surveyor {
 public:
  explicit Surveyor(const std::filesystem::path& path) : path_(path) {}

  void add(const mcap::Message& message);
  BagSurvey finish() &&;
  bool has_read_types() const { return has_read_types_; }
  [[noreturn]] void fail_without_types() const;

 private:
  /// The first topic of a type is used; that others are not is noted.
  void use_first(std::string& used, const std::string& topic, const std::string& what);
  void take(const std::string& topic, const std::string& type, const mcap::Bytes& data);
  std::string chosen_base() const;
  void find_sensors();
  [[noreturn]] void fail_without_transform(const std::string& topic,
                                           const std::string& frame) const;

  std::filesystem::path path_;
  BagSurvey survey_;
  bool has_read_types_ = false;
  std::map<std::string, std::string> types_;              ///< By topic.
  std::set<std::pair<std::string, std::string>> frames_;  ///< Topics and frames of sensors.
  std::string odometry_child_;
  TransformTree transforms_;  ///< All, moving ones as they were last.
};

void Surveyor::add(const mcap::Message& message) {
  const mcap::Channel& channel = *message.channel;
  const std::string& topic = channel.info.topic;
  const std::string type = type_of(channel);
  const bool is_first = types_.emplace(topic, type).second;
  if (std::find(kReadTypes.begin(), kReadTypes.end(), type) == kReadTypes.end()) {
    return;
  }
  has_read_types_ = true;
  if (channel.info.message_encoding != "cdr") {
    throw files::FileError(path_.string() + ": " + topic + " is encoded as '" +
                           channel.info.message_encoding +
                           "', not as cdr\n  next: convert the bag to one of ROS 2");
  }
  if (is_first && type == ros_messages::Odometry::kName) {
    use_first(survey_.odometry_topic, topic, "odometry");
  } else if (is_first && type == ros_messages::LaserScan::kName) {
    use_first(survey_.laser_topic, topic, "laser");
  }
  try {
    take(topic, type, message.data);
  } catch (const ros_messages::CdrError&) {
    // Who reads the records comes upon it, and knows what was before it.
  }
}

void Surveyor::use_first(std::string& used, const std::string& topic, const std::string& what) {
  if (used.empty()) {
    used = topic;
  } else {
    survey_.notes.push_back(topic + " is ignored: the " + what + " is that of " + used);
  }
}

void Surveyor::take(const std::string& topic, const std::string& type, const mcap::Bytes& data) {
  using ros_messages::deserialize;
  if (type == ros_messages::TFMessage::kName) {
    const auto message = deserialize<ros_messages::TFMessage>(data);
    add_transforms(topic, message, transforms_);
    if (topic.ends_with("tf_static")) {
      add_transforms(topic, message, survey_.static_transforms);
    }
  } else if (type == ros_messages::Odometry::kName) {
    if (topic == survey_.odometry_topic && odometry_child_.empty()) {
      odometry_child_ = frame_name(deserialize<ros_messages::Odometry>(data).child_frame_id);
    }
  } else if (type == ros_messages::Range::kName || topic == survey_.laser_topic) {
    // Messages begin with their header.
    frames_.emplace(topic, frame_name(deserialize<ros_messages::Header>(data).frame_id));
  }
}

std::string Surveyor::chosen_base() const {
  if (!odometry_child_.empty()) {
    return odometry_child_;
  }
  for (const std::string_view base : kBaseFrames) {
    if (transforms_.find(std::string(kOdometryFrame), std::string(base), kLatest)) {
      return std::string(base);
    }
  }
  return "base_link";
}

BagSurvey Surveyor::finish() && {
  survey_.base_frame = chosen_base();
  find_sensors();
  return std::move(survey_);
}

void Surveyor::find_sensors() {
  for (const auto& [topic, frame] : frames_) {
    const auto T_robot_sensor = survey_.find_sensor(transforms_, frame, kLatest);
    if (!T_robot_sensor) {
      fail_without_transform(topic, frame);
    }
    sensors::RangeScan scan;
    scan.beams.resize(types_.at(topic) == ros_messages::Range::kName ? 1 : 2);
    if (!place_on_robot(*T_robot_sensor, scan) && survey_.unused.insert(topic).second) {
      survey_.notes.push_back(topic + " is ignored: its beams look up or down");
    }
    if (frame.empty()) {
      survey_.notes.push_back(topic + " names no frame: it is taken to be at the robot's origin");
    }
  }
}

void Surveyor::fail_without_transform(const std::string& topic, const std::string& frame) const {
  throw files::FileError(path_.string() + ": " + topic + ": no transform leads from " +
                         survey_.base_frame + " to its frame " + frame +
                         ": was /tf_static recorded?\n  next: record /tf_static too");
}

void Surveyor::fail_without_types() const {
  std::string list;
  for (const auto& [topic, type] : types_) {
    list += "\n  " + topic + " of " + (type.empty() ? "no type" : type);
  }
  throw files::FileError(path_.string() +
                         ": the bag has no ranges, laser scans, odometry or transforms" +
                         (list.empty() ? std::string(": it is empty") : "; it has" + list));
}

}  // namespace

std::string type_of(const mcap::Channel& channel) {
  std::string type = channel.schema ? channel.schema->name : "";
  // As ROS 1 writes it.
  if (const auto slash = type.find('/'); slash != std::string::npos && slash == type.rfind('/')) {
    type.insert(slash, "/msg");
  }
  return type;
}

void add_transforms(const std::string& topic,
                    const ros_messages::TFMessage& message,
                    TransformTree& tree) {
  for (const ros_messages::TransformStamped& transform : message.transforms) {
    const std::string parent = frame_name(transform.header.frame_id);
    const std::string child = frame_name(transform.child_frame_id);
    try {
      const SpatialPose T_p_c = spatial_pose(transform.transform);
      if (topic.ends_with("tf_static")) {
        tree.add_static(parent, child, T_p_c);
      } else {
        tree.add(parent, child, seconds_of(transform.header.stamp), T_p_c);
      }
    } catch (const files::FileError&) {
      continue;
    }
  }
}

std::optional<SpatialPose> BagSurvey::find_sensor(const TransformTree& transforms,
                                                  const std::string& frame,
                                                  double stamp_s) const {
  if (frame.empty()) {
    return SpatialPose{};
  }
  if (auto T_base_sensor = transforms.find(base_frame, frame, stamp_s)) {
    return T_base_sensor;
  }
  // Both names are of one robot; what is between them is its height over the floor.
  for (const std::string_view base : kBaseFrames) {
    if (auto T_base_sensor = transforms.find(std::string(base), frame, stamp_s)) {
      return T_base_sensor;
    }
  }
  return std::nullopt;
}

BagSurvey survey_bag(const std::filesystem::path& path) {
  BagFiles files(path);
  Surveyor surveyor(path);
  std::exception_ptr damage;
  while (true) {
    std::optional<mcap::Message> message;
    try {
      message = files.next();
    } catch (const files::FileError&) {
      damage = std::current_exception();
    }
    if (!message) {
      break;
    }
    surveyor.add(*message);
  }
  if (!surveyor.has_read_types()) {
    if (damage) {
      std::rethrow_exception(damage);
    }
    surveyor.fail_without_types();
  }
  return std::move(surveyor).finish();
}

}  // namespace echomap::datasets
