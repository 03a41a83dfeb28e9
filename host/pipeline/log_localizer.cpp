// SPDX-License-Identifier: MIT
#include "host/pipeline/log_localizer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/localization/likelihood_field_model.hpp"
#include "host/localization/range_table_model.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

namespace {

/// As infra-red is, and a laser, whose beams have no opening.
bool is_light(const sensors::RangeScan& scan) {
  return scan.is_light || scan.beam_width_rad == 0.0;
}

localization::LocalizedRobot robot_of(const sensors::RangeScan& scan) {
  localization::LocalizedRobot robot;
  robot.beam_half_angle_rad = 0.5 * scan.beam_width_rad;
  // A log that does not say how far its sensor reaches, as of our own runs.
  constexpr double kUnknownReachM = 4.0;
  robot.max_range_m = std::isfinite(scan.max_range_m) ? scan.max_range_m : kUnknownReachM;
  robot.is_light = is_light(scan);
  return robot;
}

time::RobotTime robot_time(double stamp_s) {
  return time::RobotTime(time::RobotClock::duration(std::llround(stamp_s * 1e6)));
}

}  // namespace

/// What the ranges of one kind of sensor need.
struct LogLocalizer::Sensor {
  Sensor(const mapping::RasterMap& map,
         double sensor_beam_width_rad,
         const localization::LocalizedRobot& robot,
         localization::LocalizerPreset preset,
         std::mt19937 random)
      : beam_width_rad(sensor_beam_width_rad),
        observation(localization::observation_model(preset, map, robot)),
        localizer(*observation, localization::localizer_params(preset, robot), random) {}

  double beam_width_rad;
  std::unique_ptr<localization::ObservationModel> observation;
  localization::MonteCarloLocalizer localizer;
};

LogLocalizer::LogLocalizer(mapping::RasterMap map,
                           const LogLocalizerParams& params,
                           std::mt19937 random)
    : map_(std::move(map)), params_(params), random_(random) {
  geometry::ParameterValidator("log localizer")
      .positive("step_m", params.step_m)
      .positive("step_rad", params.step_rad)
      .positive("max_readings", params.max_readings);
}

LogLocalizer::~LogLocalizer() = default;

void LogLocalizer::start_at(const geometry::Pose2& T_map_robot,
                            double stddev_m,
                            double stddev_rad) {
  start_ = {T_map_robot, stddev_m, stddev_rad};
}

void LogLocalizer::add(const datasets::LogRecord& record) {
  const auto* scan = std::get_if<sensors::RangeScan>(&record);
  if (scan != nullptr && is_late(*scan)) {
    ++scans_;
    ++late_scans_;
    belief_.outcome = localization::LocalizerOutcome::kTimeRanBack;
    return;
  }
  if (const auto stamp = datasets::stamp_s(record)) {
    stamp_s_ = stamp;
  }
  poses_.follow(record);
  if (scan != nullptr) {
    gather(*scan);
    const bool is_due =
        !T_odom_updated_ ||
        // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a scan comes after a pose
        has_moved(*T_odom_updated_, *poses_.T_map_robot(), params_.step_m, params_.step_rad);
    if (!gathered_.empty() && is_due) {
      update();
    }
  }
}

bool LogLocalizer::is_late(const sensors::RangeScan& scan) {
  if (!scan.stamp_s) {
    return false;
  }
  if (scan_stamp_s_ && !(*scan.stamp_s >= *scan_stamp_s_)) {
    return true;
  }
  scan_stamp_s_ = scan.stamp_s;
  return false;
}

void LogLocalizer::gather(const sensors::RangeScan& scan) {
  ++scans_;
  if (!sensor_) {
    sensor_ = std::make_unique<Sensor>(
        map_, scan.beam_width_rad, robot_of(scan), params_.preset, random_);
    if (start_) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a scan comes after a pose
      sensor_->localizer.update(*poses_.T_map_robot(), {});
      start_outcome_ =
          sensor_->localizer.start_at(start_->T_map_robot, start_->stddev_m, start_->stddev_rad);
    }
  }
  if (scan.beam_width_rad != sensor_->beam_width_rad) {
    ++unused_scans_;
    return;
  }
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a scan comes after a pose
  const geometry::Pose2 T_odom_sensor = *poses_.T_map_robot() * scan.T_robot_sensor;
  for (const sensors::Beam& beam : scan.beams) {
    // Light's silence says nothing, and maps end not far beyond what it saw well.
    if (!is_light(scan) || (beam.range_m && *beam.range_m <= params_.max_laser_range_m)) {
      gathered_.push_back(
          {T_odom_sensor * geometry::Pose2(0.0, 0.0, beam.bearing_rad), beam.range_m});
    }
  }
}

void LogLocalizer::update() {
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): a scan comes after a pose
  const geometry::Pose2 T_odom_robot = *poses_.T_map_robot();
  belief_ = sensor_->localizer.update(T_odom_robot,
                                      evenly_picked(gathered_, T_odom_robot, params_.max_readings));
  gathered_.clear();
  T_odom_updated_ = T_odom_robot;
  ++updates_;
  if (stamp_s_ && !belief_.hypotheses.empty()) {
    trajectory_.push_back({robot_time(*stamp_s_), belief_.hypotheses.front().T_map_robot});
  }
}

}  // namespace echomap::pipeline
