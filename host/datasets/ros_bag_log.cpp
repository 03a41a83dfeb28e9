// SPDX-License-Identifier: MIT
#include "host/datasets/ros_bag_log.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "host/datasets/bag_files.hpp"
#include "host/datasets/bag_survey.hpp"
#include "host/datasets/rising_stamp.hpp"
#include "host/datasets/ros_observations.hpp"
#include "host/files/atomic_file.hpp"
#include "host/ros_messages/nav_msgs.hpp"
#include "host/ros_messages/serialization.hpp"

namespace echomap::datasets {
namespace {

using ros_messages::deserialize;

class RosBagLog : public LogReader {
 public:
  explicit RosBagLog(const std::filesystem::path& path)
      : path_(path),
        survey_(survey_bag(path)),
        files_(path),
        transforms_(survey_.static_transforms) {}

  std::optional<LogRecord> next() override;
  double progress() const override { return files_.progress(); }
  std::vector<std::string> notes() const override { return survey_.notes; }

 private:
  /// How long a record waits for others with an earlier stamp, and for transforms after it.
  static constexpr std::uint64_t kWindowNs = 500'000'000;
  /// No more wait, should the times of the recorder not rise.
  static constexpr std::size_t kMaxHeld = 10000;

  /// A stamp, and 0 for odometry, which comes before the scans of its instant.
  using Place = std::pair<double, int>;
  struct Held {
    std::uint64_t log_time_ns = 0;
    std::string frame;  ///< Of the sensor, for a scan.
    LogRecord record;
  };

  bool is_settled() const;
  /// Reads one message; keeps the error of a damaged bag, which comes after all records before it.
  void read_message();
  void take(const mcap::Message& message);
  void take_transforms(const mcap::Message& message);
  void hold_odometry(const mcap::Message& message,
                     const ros_messages::Header& header,
                     const SpatialPose& T_odom_robot);
  template <class Reading>
  void hold_scan(const mcap::Message& message);
  std::optional<LogRecord> finished(double stamp_s, Held held);

  std::filesystem::path path_;
  BagSurvey survey_;
  BagFiles files_;
  TransformTree transforms_;
  std::multimap<Place, Held> held_;
  std::uint64_t latest_log_time_ns_ = 0;
  bool is_ended_ = false;
  std::exception_ptr failure_;
  RisingStamp odometry_stamps_;
  RisingStamp scan_stamps_;
};

std::optional<LogRecord> RosBagLog::next() {
  while (true) {
    while (!is_settled()) {
      read_message();
    }
    if (held_.empty()) {
      break;
    }
    auto first = held_.extract(held_.begin());
    if (auto record = finished(first.key().first, std::move(first.mapped()))) {
      return record;
    }
  }
  if (failure_) {
    std::rethrow_exception(failure_);
  }
  return std::nullopt;
}

bool RosBagLog::is_settled() const {
  return is_ended_ || held_.size() > kMaxHeld ||
         (!held_.empty() && latest_log_time_ns_ >= kWindowNs &&
          held_.begin()->second.log_time_ns <= latest_log_time_ns_ - kWindowNs);
}

void RosBagLog::read_message() {
  try {
    const auto message = files_.next();
    is_ended_ = !message;
    if (message) {
      latest_log_time_ns_ = std::max(latest_log_time_ns_, message->log_time_ns);
      take(*message);
    }
  } catch (const files::FileError&) {
    failure_ = std::current_exception();
    is_ended_ = true;
  }
}

void RosBagLog::take(const mcap::Message& message) {
  const std::string& topic = message.channel->info.topic;
  const std::string type = type_of(*message.channel);
  try {
    if (type == ros_messages::TFMessage::kName) {
      take_transforms(message);
    } else if (type == ros_messages::Odometry::kName) {
      if (topic == survey_.odometry_topic) {
        const auto odometry = deserialize<ros_messages::Odometry>(message.data);
        hold_odometry(message, odometry.header, spatial_pose(odometry.pose.pose));
      }
    } else if (type == ros_messages::Range::kName) {
      hold_scan<ros_messages::Range>(message);
    } else if (topic == survey_.laser_topic) {
      hold_scan<ros_messages::LaserScan>(message);
    }
  } catch (const std::runtime_error& error) {
    throw files::FileError(path_.string() + ": message " + std::to_string(message.sequence) +
                           " of " + topic + ": " + error.what());
  }
}

void RosBagLog::take_transforms(const mcap::Message& message) {
  const auto transforms = deserialize<ros_messages::TFMessage>(message.data);
  add_transforms(message.channel->info.topic, transforms, transforms_);
  if (!survey_.odometry_topic.empty()) {
    return;
  }
  for (const ros_messages::TransformStamped& transform : transforms.transforms) {
    if (frame_name(transform.header.frame_id) == kOdometryFrame &&
        frame_name(transform.child_frame_id) == survey_.base_frame) {
      hold_odometry(message, transform.header, spatial_pose(transform.transform));
    }
  }
}

/// The stamp of a header; that of the recorder where nobody has set it.
double stamp_of(const mcap::Message& message, const ros_messages::Header& header) {
  return header.stamp == ros_messages::Time{} ? 1e-9 * static_cast<double>(message.log_time_ns)
                                              : seconds_of(header.stamp);
}

void RosBagLog::hold_odometry(const mcap::Message& message,
                              const ros_messages::Header& header,
                              const SpatialPose& T_odom_robot) {
  held_.emplace(Place(stamp_of(message, header), 0),
                Held{message.log_time_ns, "", OdometryPose{{}, planar_pose(T_odom_robot)}});
}

template <class Reading>
void RosBagLog::hold_scan(const mcap::Message& message) {
  if (!survey_.unused.contains(message.channel->info.topic)) {
    const auto reading = deserialize<Reading>(message.data);
    held_.emplace(Place(stamp_of(message, reading.header), 1),
                  Held{message.log_time_ns, frame_name(reading.header.frame_id), scan_of(reading)});
  }
}

/// The record with its stamp and place; empty for a scan before the first transform to its sensor,
/// and where a sensor that moves looks up or down.
std::optional<LogRecord> RosBagLog::finished(double stamp_s, Held held) {
  if (auto* pose = std::get_if<OdometryPose>(&held.record)) {
    pose->stamp_s = odometry_stamps_.accept(stamp_s);
  } else if (auto* scan = std::get_if<sensors::RangeScan>(&held.record)) {
    const auto T_robot_sensor = survey_.find_sensor(transforms_, held.frame, stamp_s);
    if (!T_robot_sensor || !place_on_robot(*T_robot_sensor, *scan)) {
      return std::nullopt;
    }
    scan->stamp_s = scan_stamps_.accept(stamp_s);
  }
  return std::move(held.record);
}

}  // namespace

std::unique_ptr<LogReader> open_ros_bag_log(const std::filesystem::path& path) {
  return std::make_unique<RosBagLog>(path);
}

}  // namespace echomap::datasets
