// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/files/atomic_file.hpp"
#include "host/pipeline/observation_sink.hpp"

namespace echomap::exports {

/// What moves a robot's pose and map as a table for other programs, an observation a line as
/// `kind,stamp_us,values`. Battery and yaw are left out: they are of the moment.
///
///     odometry,STAMP_US,LEFT_M,RIGHT_M                   what the wheels have rolled
///     sonar,STAMP_US,LEFT_M,RIGHT_M,PAN_RAD,RANGE_M      `none` without an echo in range,
///                                                        `silent` where the sonar did not answer
///     infrared,STAMP_US,LEFT_M,RIGHT_M,RANGE_M,...       in the order of the profile
///     scalar,STAMP_US,LEFT_M,RIGHT_M,COUNT,DWELL_S       pulses and their time, or a level and 0
///     hazards,STAMP_US,BUMP,BUMP,CLIFF,CLIFF,CLIFF,CLIFF,LIFTED,VIRTUAL_WALL,WALL    0 or 1
///     carried,STAMP_US,LEFT_M,RIGHT_M,X_M,Y_M,HEADING_RAD    on the map, from there on
///     fix,STAMP_US,X_M,Y_M,HEADING_RAD                   on the map, as a camera knows
///     begin-scan
///     end-scan
class ObservationsCsv final : public pipeline::ObservationSink {
 public:
  ObservationsCsv();

  void on_odometry(const sensors::OdometryObservation& observation) override;
  void on_sonar(const sensors::SonarObservation& observation) override;
  void on_hazards(const sensors::HazardObservation& observation) override;
  void on_infrared(const sensors::InfraredObservation& observation) override;
  void on_scalar(const sensors::ScalarObservation& observation) override;
  void on_carried(const sensors::CarriedObservation& observation) override;
  void on_pose_fix(const sensors::PoseFixObservation& observation) override;
  void begin_scan() override;
  void end_scan() override;

  /// A file of all so far, 10 MB after an hour of odometry at 50 Hz. Throws files::FileError.
  void save(const std::filesystem::path& path) const { files::write_text_file(path, text_); }

 private:
  void begin_line(std::string_view kind, time::RobotTime stamp);
  void begin_line(std::string_view kind, time::RobotTime stamp, const sensors::WheelTravel& travel);
  void add(double value);
  void add(const geometry::Pose2& pose);
  void add(const std::optional<double>& value);

  std::string text_;
};

}  // namespace echomap::exports
