// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/recording/observation_messages.hpp"
#include "host/recording/session_event.hpp"
#include "host/recording/session_file.hpp"
#include "host/ros_messages/diagnostic_msgs.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "host/time/host_time.hpp"

namespace echomap::recording {

/// What the recorder of a session has to know of it.
struct SessionRecorderParams {
  sensors::RobotGeometry geometry;
  SonarFacts sonar;
  std::vector<geometry::Pose2> T_robot_infrared;
  std::string scalar_unit = {};  ///< Of the scalar sensor, if there is one.
};

/// Records a session while it takes place: the frames on the line and what happens beside them,
/// from which it is replayed, and for other tools what the host made of them. Takes observations as
/// a sink of the session. What cannot be written is tried again; nothing throws but `open` and
/// `finish`.
class SessionRecorder final : public pipeline::AnyObservationSink {
 public:
  explicit SessionRecorder(const SessionRecorderParams& params);

  /// Says what the session is, before `open`.
  void describe(const std::string& name, const std::map<std::string, std::string>& facts);
  void describe(const std::string& file_name, const std::string& text);
  /// The listener hears of all that is recorded from now on, whether or not there is a file. Null
  /// for nobody; else it outlives this.
  void listen(TopicListener* listener) { file_.listen(listener); }
  /// Begins the file; what was recorded until then is in it. Throws files::FileError.
  void open(const std::filesystem::path& path, std::uint64_t split_bytes = 0);

  /// A session's clock begins at this log time, nanoseconds since 1970 or of simulated time, and
  /// not before what was recorded so far.
  void begin_session(std::uint64_t epoch_ns);
  /// All that follows happens at this instant of the session's clock.
  void set_time(time::HostTime now);
  /// All that follows happened at this log time, in an earlier session.
  void set_log_time(std::uint64_t time_ns) { time_ns_ = time_ns; }

  /// `robot_stamp_us` is there where the host took the frame for an observation.
  void add_received(std::span<const std::uint8_t> bytes,
                    std::optional<std::uint32_t> robot_stamp_us);
  void add_sent(std::span<const std::uint8_t> bytes);
  void add_event(const SessionEvent& event);
  /// Scans and pose fixes are events as well; all else is for other tools.
  void on(const sensors::Observation& observation) override;

  /// The map after a stop, and where it has the robot.
  void add_map(const pipeline::Snapshot& snapshot);
  /// Where a localizer has the robot, and poses where it may be.
  void add_localization(const geometry::Pose2& T_map_robot,
                        const std::vector<geometry::Pose2>& T_map_particles);
  void add_diagnostics(ros_messages::DiagnosticStatus status);
  /// A line of the log; `level` is one of ros_messages::Log.
  void add_log(std::uint8_t level, const std::string& text);

  /// Hands everything so far to the system.
  void flush();
  /// Adds what came of the session and ends the file: what comes later is not recorded. Throws
  /// files::FileError.
  void attach(const std::string& file_name,
              const std::string& media_type,
              const std::string& bytes);
  void describe_ending(const std::map<std::string, std::string>& facts);
  void finish();

  /// Why something could not be written; empty where everything was.
  const std::string& trouble() const { return trouble_; }
  /// Where `open` has put it; empty before.
  const std::filesystem::path& path() const { return path_; }

 private:
  template <class M>
  void write(std::string_view topic, const M& message) {
    attempt([&] { file_.write(topic, time_ns_, message); });
  }
  void attempt(const std::function<void()>& write);

  void add(const sensors::OdometryObservation& odometry);
  void add(const sensors::SonarObservation& ping);
  void add(const sensors::InfraredObservation& infrared);
  void add(const sensors::HazardObservation& hazards);
  void add(const sensors::YawObservation& yaw);
  void add(const sensors::BatteryObservation& battery);
  void add(const sensors::ScalarObservation& scalar);
  void add(const sensors::PoseFixObservation& fix);
  void add(const sensors::CarriedObservation& /*is_of_the_maps*/) {}
  void add(const sensors::EncoderErrorObservation& /*is_in_the_diagnostics*/) {}
  void add(const sensors::BeginScan& scan);
  void add(const sensors::EndScan& scan);
  void add_transforms(const std::vector<ros_messages::TransformStamped>& transforms);
  void add_static_transforms();

  SessionRecorderParams params_;
  SessionFile file_;
  std::filesystem::path path_;
  std::uint64_t epoch_ns_ = 0;
  std::uint64_t time_ns_ = 0;
  std::string trouble_;
  bool is_finished_ = false;
  bool scan_is_open_ = false;
  sensors::WheelOdometry odometry_;
  geometry::Pose2 T_odom_told_;  ///< Of the last odometry, and its stamp.
  time::RobotTime told_stamp_;
  geometry::Pose2 T_map_odom_;
  sensors::HazardObservation hazards_;
};

}  // namespace echomap::recording
