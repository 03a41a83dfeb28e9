// SPDX-License-Identifier: MIT
#include "host/exports/observations_csv.hpp"

#include <optional>

#include "host/exports/number_table.hpp"

namespace echomap::exports {
namespace {

constexpr std::string_view kHeader = "kind,stamp_us,values";
/// The range of a ping that the sonar did not answer.
constexpr std::string_view kSilent = "silent";

}  // namespace

ObservationsCsv::ObservationsCsv() : text_(std::string(kHeader) + '\n') {}

void ObservationsCsv::on_odometry(const sensors::OdometryObservation& observation) {
  begin_line("odometry", observation.stamp, observation.travel);
  text_ += '\n';
}

void ObservationsCsv::on_sonar(const sensors::SonarObservation& observation) {
  begin_line("sonar", observation.stamp, observation.travel);
  add(observation.pan_rad);
  if (observation.has_answered) {
    add(observation.range_m);
  } else {
    text_ += ',';
    text_ += kSilent;
  }
  text_ += '\n';
}

void ObservationsCsv::on_infrared(const sensors::InfraredObservation& observation) {
  begin_line("infrared", observation.stamp, observation.travel);
  for (const auto& range_m : observation.range_m) {
    add(range_m);
  }
  text_ += '\n';
}

void ObservationsCsv::on_hazards(const sensors::HazardObservation& observation) {
  begin_line("hazards", observation.stamp);
  const auto& cliffs = observation.cliffs;
  for (const bool flag : {observation.bump_left,
                          observation.bump_right,
                          cliffs[0],
                          cliffs[1],
                          cliffs[2],
                          cliffs[3],
                          observation.lifted,
                          observation.virtual_wall,
                          observation.wall}) {
    text_ += flag ? ",1" : ",0";
  }
  text_ += '\n';
}

void ObservationsCsv::on_scalar(const sensors::ScalarObservation& observation) {
  begin_line("scalar", observation.stamp, observation.travel);
  add(observation.count);
  add(observation.dwell_s);
  text_ += '\n';
}

void ObservationsCsv::on_carried(const sensors::CarriedObservation& observation) {
  begin_line("carried", observation.stamp, observation.travel);
  add(observation.T_map_robot);
  text_ += '\n';
}

void ObservationsCsv::on_pose_fix(const sensors::PoseFixObservation& observation) {
  begin_line("fix", observation.stamp);
  add(observation.T_map_robot);
  text_ += '\n';
}

void ObservationsCsv::begin_scan() { text_ += "begin-scan\n"; }

void ObservationsCsv::end_scan() { text_ += "end-scan\n"; }

void ObservationsCsv::begin_line(std::string_view kind, time::RobotTime stamp) {
  text_ += kind;
  text_ += ',' + std::to_string(stamp.time_since_epoch().count());
}

void ObservationsCsv::begin_line(std::string_view kind,
                                 time::RobotTime stamp,
                                 const sensors::WheelTravel& travel) {
  begin_line(kind, stamp);
  add(travel.left_m);
  add(travel.right_m);
}

void ObservationsCsv::add(double value) {
  text_ += ',';
  append_number(text_, value);
}

void ObservationsCsv::add(const geometry::Pose2& pose) {
  add(pose.x_m());
  add(pose.y_m());
  add(pose.heading_rad());
}

void ObservationsCsv::add(const std::optional<double>& value) {
  if (value) {
    add(*value);
  } else {
    text_ += ",none";
  }
}

}  // namespace echomap::exports
