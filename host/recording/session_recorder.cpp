// SPDX-License-Identifier: MIT
#include "host/recording/session_recorder.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "host/files/atomic_file.hpp"
#include "host/mapping/room_outline.hpp"
#include "host/recording/map_messages.hpp"
#include "host/recording/session_messages.hpp"
#include "host/ros_messages/rcl_interfaces.hpp"

namespace echomap::recording {
namespace {

mcap::Attachment attachment_of(std::uint64_t time_ns,
                               const std::string& name,
                               const std::string& media_type,
                               const std::string& bytes) {
  return {time_ns, time_ns, name, media_type, {bytes.begin(), bytes.end()}};
}

ros_messages::KeyValue flag(const std::string& name, bool value) {
  return {name, value ? "true" : "false"};
}

std::string infrared_frame(std::size_t index) { return "infrared_" + std::to_string(index); }

}  // namespace

SessionRecorder::SessionRecorder(const SessionRecorderParams& params)
    : params_(params), odometry_(params.geometry.track_m) {}

void SessionRecorder::attempt(const std::function<void()>& write) {
  if (is_finished_) {
    return;
  }
  try {
    write();
  } catch (const files::FileError& error) {
    trouble_ = error.what();
  }
}

void SessionRecorder::describe(const std::string& name,
                               const std::map<std::string, std::string>& facts) {
  file_.describe(name, facts);
}

void SessionRecorder::describe(const std::string& file_name, const std::string& text) {
  file_.describe(attachment_of(time_ns_, file_name, "text/plain", text));
}

void SessionRecorder::open(const std::filesystem::path& path, std::uint64_t split_bytes) {
  file_.open(path, split_bytes);
  path_ = path;
}

void SessionRecorder::begin_session(std::uint64_t epoch_ns) {
  epoch_ns_ = std::max(epoch_ns, time_ns_);
  time_ns_ = epoch_ns_;
  add_event({SessionEventKind::kBeginSession});
  add_static_transforms();
}

void SessionRecorder::set_time(time::HostTime now) {
  const std::chrono::nanoseconds since(now.time_since_epoch());
  time_ns_ = epoch_ns_ + static_cast<std::uint64_t>(since.count());
}

void SessionRecorder::add_received(std::span<const std::uint8_t> bytes,
                                   std::optional<std::uint32_t> robot_stamp_us) {
  write(kReceivedTopic,
        LineFrame{
            robot_stamp_us.has_value(), robot_stamp_us.value_or(0), {bytes.begin(), bytes.end()}});
}

void SessionRecorder::add_sent(std::span<const std::uint8_t> bytes) {
  write(kSentTopic, LineFrame{false, 0, {bytes.begin(), bytes.end()}});
}

void SessionRecorder::add_event(const SessionEvent& event) {
  const geometry::Pose2& pose = event.T_map_robot;
  write(kEventTopic,
        SessionEventMessage{std::string(name_of(event.kind)),
                            event.value,
                            {pose.x_m(), pose.y_m(), pose.heading_rad()}});
}

void SessionRecorder::on(const sensors::Observation& observation) {
  std::visit([this](const auto& one) { add(one); }, observation);
}

void SessionRecorder::add(const sensors::OdometryObservation& odometry) {
  const geometry::Pose2 T_odom_last = T_odom_told_;
  T_odom_told_ = odometry_.update(odometry.travel);
  const geometry::Pose2& T_odom_robot = T_odom_told_;
  const geometry::Pose2 T_last_now = T_odom_last.inverse() * T_odom_robot;
  const auto last_stamp = std::exchange(told_stamp_, odometry.stamp);
  const double passed_s = std::chrono::duration<double>(told_stamp_ - last_stamp).count();
  write("/odom",
        odometry_message(
            time_ns_,
            T_odom_robot,
            passed_s > 0.0 ? Speed{T_last_now.x_m() / passed_s, T_last_now.heading_rad() / passed_s}
                           : Speed{}));
  add_transforms({transform_of(time_ns_, kMapFrame, kOdomFrame, T_map_odom_),
                  transform_of(time_ns_, kOdomFrame, kRobotFrame, T_odom_robot)});
}

void SessionRecorder::add(const sensors::SonarObservation& ping) {
  odometry_.update(ping.travel);
  add_transforms({transform_of(
      time_ns_, kRobotFrame, kSonarFrame, params_.geometry.T_robot_sonar(ping.pan_rad))});
  write("/sonar", sonar_message(time_ns_, ping, params_.sonar));
  write("/sonar/cone", cone_message(time_ns_, ping, params_.sonar));
}

void SessionRecorder::add(const sensors::InfraredObservation& infrared) {
  for (std::size_t i = 0; i < infrared.range_m.size(); ++i) {
    const std::string frame = infrared_frame(i);
    write("/" + frame, infrared_message(time_ns_, frame, infrared.range_m[i]));
  }
}

void SessionRecorder::add(const sensors::HazardObservation& hazards) {
  const auto facts = [](const sensors::HazardObservation& of) {
    return std::tuple(of.bump_left, of.bump_right, of.cliffs, of.lifted, of.virtual_wall, of.wall);
  };
  if (facts(std::exchange(hazards_, hazards)) == facts(hazards)) {
    return;
  }
  const bool is_endangered = hazards.is_touching() || hazards.is_in_the_air();
  using ros_messages::DiagnosticStatus;
  add_diagnostics({is_endangered ? DiagnosticStatus::kWarn : DiagnosticStatus::kOk,
                   "contacts",
                   hazards.is_in_the_air() ? "lifted"
                   : hazards.is_touching() ? "touching"
                                           : "clear",
                   "",
                   {flag("bump left", hazards.bump_left),
                    flag("bump right", hazards.bump_right),
                    flag("cliff left", hazards.cliffs[0]),
                    flag("cliff front left", hazards.cliffs[1]),
                    flag("cliff front right", hazards.cliffs[2]),
                    flag("cliff right", hazards.cliffs[3]),
                    flag("lifted", hazards.lifted),
                    flag("virtual wall", hazards.virtual_wall),
                    flag("wall", hazards.wall)}});
}

void SessionRecorder::add(const sensors::YawObservation& yaw) {
  write("/imu", imu_message(time_ns_, yaw));
}

void SessionRecorder::add(const sensors::BatteryObservation& battery) {
  write("/battery", battery_message(time_ns_, battery.voltage_v));
}

void SessionRecorder::add(const sensors::ScalarObservation& scalar) {
  write("/scalar", scalar_message(time_ns_, scalar, params_.scalar_unit));
}

void SessionRecorder::add(const sensors::PoseFixObservation& fix) {
  add_event({SessionEventKind::kPoseFix, fix.stamp.time_since_epoch().count(), fix.T_map_robot});
}

void SessionRecorder::add(const sensors::BeginScan& /*scan*/) {
  scan_is_open_ = true;
  add_event({SessionEventKind::kBeginScan});
}

void SessionRecorder::add(const sensors::EndScan& /*scan*/) {
  if (std::exchange(scan_is_open_, false)) {
    add_event({SessionEventKind::kEndScan});
  }
}

void SessionRecorder::add_transforms(
    const std::vector<ros_messages::TransformStamped>& transforms) {
  write("/tf", ros_messages::TFMessage{transforms});
}

void SessionRecorder::add_static_transforms() {
  std::vector<ros_messages::TransformStamped> transforms;
  transforms.reserve(params_.T_robot_infrared.size());
  for (const geometry::Pose2& T_robot_sensor : params_.T_robot_infrared) {
    transforms.push_back(
        transform_of(time_ns_, kRobotFrame, infrared_frame(transforms.size()), T_robot_sensor));
  }
  if (!transforms.empty()) {
    write("/tf_static", ros_messages::TFMessage{std::move(transforms)});
  }
}

void SessionRecorder::add_map(const pipeline::Snapshot& snapshot) {
  T_map_odom_ = snapshot.latest.T_map_robot * odometry_.T_odom_robot().inverse();
  const mapping::RasterMap map = mapping::rasterize(*snapshot.grid);
  write("/map", map_message(time_ns_, map));
  write("/path", path_message(time_ns_, *snapshot.trajectory));
  write("/pose", pose_message(time_ns_, snapshot));
  write("/map/features",
        features_message(
            time_ns_, *snapshot.features, mapping::room_outline(map, *snapshot.features)));
  if (snapshot.last_scan) {
    const auto scan = scan_message(
        time_ns_, *snapshot.last_scan, snapshot.latest.T_map_robot, params_.sonar.max_range_m);
    if (scan) {
      write("/scan", *scan);
    }
  }
  flush();
}

void SessionRecorder::add_localization(const geometry::Pose2& T_map_robot,
                                       const std::vector<geometry::Pose2>& T_map_particles) {
  T_map_odom_ = T_map_robot * odometry_.T_odom_robot().inverse();
  ros_messages::PoseWithCovarianceStamped pose;
  pose.header = header_of(time_ns_, kMapFrame);
  pose.pose.pose = pose_of(T_map_robot);
  write("/pose", pose);
  write("/particles", particles_message(time_ns_, T_map_particles));
}

void SessionRecorder::add_diagnostics(ros_messages::DiagnosticStatus status) {
  write("/diagnostics",
        ros_messages::DiagnosticArray{header_of(time_ns_, ""), {std::move(status)}});
}

void SessionRecorder::add_log(std::uint8_t level, const std::string& text) {
  ros_messages::Log line;
  line.stamp = stamp_of(time_ns_);
  line.level = level;
  line.name = "echomap";
  line.msg = text;
  write("/rosout", line);
}

void SessionRecorder::flush() {
  attempt([this] { file_.flush(); });
}

void SessionRecorder::attach(const std::string& file_name,
                             const std::string& media_type,
                             const std::string& bytes) {
  file_.attach(attachment_of(time_ns_, file_name, media_type, bytes));
}

void SessionRecorder::describe_ending(const std::map<std::string, std::string>& facts) {
  file_.add_metadata("ending", facts);
}

void SessionRecorder::finish() {
  file_.finish();
  is_finished_ = true;
  trouble_.clear();
}

}  // namespace echomap::recording
