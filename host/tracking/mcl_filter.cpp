// SPDX-License-Identifier: MIT
#include "host/tracking/mcl_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/console/exit_code.hpp"
#include "host/console/print.hpp"
#include "host/exploration/nxt_rounds.hpp"
#include "host/pipeline/preset_names.hpp"
#include "host/tracking/localize_troubles.hpp"
#include "host/tracking/pose_report.hpp"

namespace echomap::tracking {

using localization::LocalizationStatus;
using localization::LocalizedBy;
using localization::LocalizerPreset;

namespace {

/// Of a place that a person points at.
constexpr double kToldStddevM = 0.2;
constexpr double kToldStddevRad = 0.3;
/// Of an infra-red sensor's field, 10 degrees wide.
constexpr double kInfraredHalfAngleRad = 0.0873;

/// Others see a wall that the robot follows, which tells little of its place.
bool looks_ahead(const std::vector<sensors::InfraredSensor>& sensors) {
  constexpr double kAheadRad = 0.55;
  return std::ranges::any_of(sensors, [](const sensors::InfraredSensor& sensor) {
    return std::abs(sensor.T_robot_sensor.heading_rad()) < kAheadRad;
  });
}

LocalizedBy sensor_of(const session::RobotProfile& profile) {
  if (profile.has_sonar) {
    return LocalizedBy::kSonar;
  }
  return looks_ahead(profile.sensors.infrared) ? LocalizedBy::kInfrared : LocalizedBy::kContacts;
}

/// Of the ring, or of the wall sensor of a robot with contacts. It is read about once a radius of
/// the body.
void add_infrared(const session::RobotProfile& profile, pipeline::RobotLocalizerParams& params) {
  params.sensor->beam_half_angle_rad = kInfraredHalfAngleRad;
  params.sensor->max_range_m =
      profile.sensors.infrared_curve ? profile.sensors.infrared_curve->max_m() : 0.0;
  params.step_m = 0.9 * profile.body_radius_m;
  params.infrared_step_m = params.step_m;
  for (const sensors::InfraredSensor& sensor : profile.sensors.infrared) {
    params.T_robot_infrared.push_back(sensor.T_robot_sensor);
  }
}

/// A paper's filter goes by the sensor of its robot.
void validate_preset(const session::RobotProfile& profile, LocalizerPreset preset) {
  const LocalizedBy sensor = sensor_of(profile);
  const auto refuse = [&](const std::string& needs, const std::string& robot) {
    throw console::CommandError(console::ExitCode::kConfigInvalid,
                                "preset '" + pipeline::name_of(preset) + "' needs " + needs +
                                    ", and profile '" + profile.name +
                                    "' is localized otherwise\n"
                                    "  next: leave --preset out, or localize a robot as " +
                                    robot);
  };
  if (preset == LocalizerPreset::kNxt && sensor != LocalizedBy::kSonar) {
    refuse("a sonar", "nxt_tribot");
  }
  if (preset == LocalizerPreset::kCreate && sensor != LocalizedBy::kContacts) {
    refuse("contacts, and neither sonar nor a ring of infra-red sensors", "create");
  }
  if (preset == LocalizerPreset::kEpuck && sensor == LocalizedBy::kContacts) {
    refuse("ranges all round", "epuck");
  }
}

}  // namespace

pipeline::RobotLocalizerParams localizer_params(const session::RobotProfile& profile,
                                                localization::LocalizerPreset preset) {
  validate_preset(profile, preset);
  pipeline::RobotLocalizerParams params;
  params.preset = preset;
  localization::LocalizedRobot& robot = params.sensor.emplace();
  robot.by = sensor_of(profile);
  robot.body_radius_m = profile.body_radius_m;
  if (robot.by == LocalizedBy::kSonar) {
    robot.beam_half_angle_rad = profile.beam_half_angle_rad;
    robot.max_range_m = profile.range.max_range_m;
  } else {
    add_infrared(profile, params);
  }
  if (preset == LocalizerPreset::kNxt) {
    params.bearings_rad = exploration::round_bearings_rad({});
  }
  return params;
}

MclFilter::MclFilter(const mapping::RasterMap& map,
                     const sensors::RobotGeometry& robot,
                     const pipeline::RobotLocalizerParams& params,
                     const std::optional<StartPose>& start,
                     std::mt19937 random)
    : start_(start), localizer_(map, robot, params, random) {}

void MclFilter::poll(const session::RobotSession& /*session*/) {
  if (localizer_.times_lifted() > lifts_told_) {
    lifts_told_ = localizer_.times_lifted();
    was_lifted_ = true;
    console::print("  lost: the robot was lifted and may be put down anywhere");
  }
  const auto trouble = trouble_of_start(localizer_.start_outcome());
  if (trouble && !std::exchange(start_is_told_, true)) {
    spdlog::warn("{}", *trouble);
  }
}

void MclFilter::begin(session::RobotSession& /*session*/) {
  if (start_) {
    localizer_.start_at(start_->T_map_robot, start_->stddev_m, start_->stddev_rad);
  }
}

std::optional<localization::PoseGaussian> MclFilter::estimate() const {
  const auto& hypotheses = localizer_.belief().hypotheses;
  return hypotheses.empty() ? std::nullopt
                            : std::optional(localization::PoseGaussian{
                                  hypotheses.front().T_map_robot, hypotheses.front().covariance});
}

void MclFilter::report_moved() {
  localizer_.start_anywhere();
  was_lifted_ = true;
}

void MclFilter::place(const geometry::Pose2& T_map_robot) {
  localizer_.start_at(T_map_robot, kToldStddevM, kToldStddevRad);
}

bool MclFilter::has_lost_it() {
  return std::exchange(was_lifted_, false) ||
         localizer_.belief().status == LocalizationStatus::kLost;
}

std::string MclFilter::line() const { return text_of(localizer_.belief()); }

nlohmann::ordered_json MclFilter::report() const {
  auto json = to_json(localizer_.belief());
  json["times_lifted"] = localizer_.times_lifted();
  return json;
}

}  // namespace echomap::tracking
