// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_localizer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::pipeline {

using localization::LocalizedBy;

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
  robot.by = is_light(scan) ? LocalizedBy::kLaser : LocalizedBy::kSonar;
  return robot;
}

}  // namespace

/// The particle filter, what it knows of the range sensor, and what monitors it.
struct RobotLocalizer::Filter {
  std::unique_ptr<localization::ObservationModel> observation;
  /// Null where the monitor compares no places, or by `observation`.
  std::unique_ptr<localization::ObservationModel> places;
  localization::MonteCarloLocalizer localizer;
  LocalizationMonitor monitor;
};

RobotLocalizer::RobotLocalizer(mapping::RasterMap map,
                               const sensors::RobotGeometry& robot,
                               const RobotLocalizerParams& params,
                               std::mt19937 random)
    : robot_(robot),
      params_(params),
      map_(std::move(map)),
      random_(random),
      odometry_(robot.track_m) {
  geometry::ParameterValidator("robot localizer")
      .positive("step_m", params.step_m)
      .positive("step_rad", params.step_rad)
      .positive("scan_step_m", params.scan_step_m)
      .positive("scan_step_rad", params.scan_step_rad)
      .positive("infrared_step_m", params.infrared_step_m)
      .positive("infrared_step_rad", params.infrared_step_rad)
      .positive("max_readings", params.max_readings);
  validate(params.monitor);
  if (params.sensor) {
    make_filter(*params.sensor);
  }
}

RobotLocalizer::~RobotLocalizer() = default;

void RobotLocalizer::make_filter(const localization::LocalizedRobot& robot) {
  auto observation = localization::observation_model(params_.preset, map_, robot);
  localization::LocalizerParams filter = localization::localizer_params(params_.preset, robot);
  filter.filter.min_particles = params_.particles.value_or(filter.filter.min_particles);
  filter.filter.max_particles = params_.particles.value_or(filter.filter.max_particles);
  filter.filter.resampling_share =
      params_.resampling_share.value_or(filter.filter.resampling_share);
  localization::MonteCarloLocalizer localizer(*observation, filter, random_);
  const bool has_scans = robot.by == LocalizedBy::kSonar || robot.by == LocalizedBy::kLaser;
  auto places = is_checked() && robot.by == LocalizedBy::kSonar
                    ? localization::own_map_model(map_, robot)
                    : nullptr;
  localization::ObservationModel* const compared = places ? places.get() : observation.get();
  LocalizationMonitor monitor(
      map_, is_checked() && has_scans ? compared : nullptr, robot.max_range_m, params_.monitor);
  filter_ = std::make_unique<Filter>(
      std::move(observation), std::move(places), std::move(localizer), std::move(monitor));
  belief_ = filter_->localizer.belief();
}

void RobotLocalizer::start_at(const geometry::Pose2& T_map_robot,
                              double stddev_m,
                              double stddev_rad) {
  start_ = {T_map_robot, stddev_m, stddev_rad};
  if (T_odom_updated_) {
    update({});
    begin_at_told_start();
  }
}

void RobotLocalizer::begin_at_told_start() {
  if (start_ && filter_) {
    on_the_way_.clear();
    start_outcome_ =
        filter_->localizer.start_at(start_->T_map_robot, start_->stddev_m, start_->stddev_rad);
    belief_ = filter_->localizer.belief();
    filter_->monitor.start_at(start_outcome_);
    start_.reset();
  }
}

void RobotLocalizer::start_anywhere() {
  on_the_way_.clear();
  round_fit_.restart();
  if (filter_) {
    filter_->localizer.start_anywhere();
    filter_->monitor.start_anywhere();
    belief_ = filter_->localizer.belief();
  }
}

void RobotLocalizer::on_odometry(const sensors::OdometryObservation& observation) {
  follow(observation.stamp, observation.travel);
}

void RobotLocalizer::on_sonar(const sensors::SonarObservation& observation) {
  follow(observation.stamp, observation.travel);
  const localization::RangeReading reading{
      T_odom_robot_ * robot_.T_robot_sonar(observation.pan_rad), observation.range_m};
  if (is_lifted_) {
    return;
  }
  if (scan_is_open_) {
    gathered_.push_back(reading);
  } else if (is_checked()) {
    add_on_the_way(reading);
  }
}

/// Of a way without an end the newest part counts.
void RobotLocalizer::add_on_the_way(const localization::RangeReading& reading) {
  constexpr std::ptrdiff_t kMaxOnTheWay = 1000;
  if (std::ssize(on_the_way_) == kMaxOnTheWay) {
    on_the_way_.erase(on_the_way_.begin(), on_the_way_.begin() + kMaxOnTheWay / 2);
  }
  on_the_way_.push_back(reading);
}

void RobotLocalizer::on_hazards(const sensors::HazardObservation& observation) {
  add_contact({observation.bump_left, observation.bump_right, observation.virtual_wall});
  const bool was_lifted = std::exchange(is_lifted_, observation.is_in_the_air());
  if (is_lifted_ && !was_lifted) {
    lose_pose();
  }
}

void RobotLocalizer::on_carried(const sensors::CarriedObservation& observation) {
  follow(observation.stamp, observation.travel);
  lose_pose();
}

void RobotLocalizer::lose_pose() {
  ++times_lifted_;
  gathered_.clear();
  start_anywhere();
}

void RobotLocalizer::on_infrared(const sensors::InfraredObservation& observation) {
  const std::vector<geometry::Pose2>& T_robot_sensors = params_.T_robot_infrared;
  if (T_robot_sensors.empty() || observation.range_m.size() != T_robot_sensors.size()) {
    return;
  }
  T_odom_robot_ = odometry_.update(observation.travel);
  stamp_ = std::max(stamp_, observation.stamp);
  const bool is_due =
      !T_odom_infrared_ ||
      has_moved(
          *T_odom_infrared_, T_odom_robot_, params_.infrared_step_m, params_.infrared_step_rad);
  if (is_lifted_ || !is_due) {
    return;
  }
  T_odom_infrared_ = T_odom_robot_;
  std::vector<localization::RangeReading> readings;
  for (std::size_t i = 0; i < T_robot_sensors.size(); ++i) {
    readings.push_back({T_robot_sensors[i], observation.range_m[i]});
  }
  update(readings);
  begin_at_told_start();
  check_round(readings);
  scans_ += is_localized_by(LocalizedBy::kInfrared) ? 1 : 0;
  ++updates_;
  note_pose();
}

void RobotLocalizer::check_round(const std::vector<localization::RangeReading>& readings) {
  if (!is_checked() || !is_localized_by(LocalizedBy::kInfrared) || belief_.hypotheses.empty()) {
    return;
  }
  if (std::ranges::any_of(readings,
                          [](const auto& reading) { return reading.range_m.has_value(); })) {
    localization::Particles place;
    place.resize(1);
    place.set_pose(0, belief_.hypotheses.front().T_map_robot);
    filter_->observation->update_weights(1.0F, {0, 1}, place);
    round_fit_.add(static_cast<double>(place.log_weight[0]));
  }
  limit_by_rounds();
}

/// A place where rounds contradict the map is no claim, however sure the particles are.
void RobotLocalizer::limit_by_rounds() {
  constexpr double kDoubt = 0.5;
  if (round_fit_.contradicts() && belief_.status == localization::LocalizationStatus::kLocalized) {
    belief_.status = localization::LocalizationStatus::kRecovering;
    belief_.lost_probability = std::max(belief_.lost_probability, kDoubt);
  }
}

bool RobotLocalizer::is_localized_by(LocalizedBy sensor) const {
  return params_.sensor && params_.sensor->by == sensor;
}

/// A contact counts where it begins; between contacts, models of ranges know nothing new.
void RobotLocalizer::add_contact(const models::ContactReading& contact) {
  if (!filter_) {
    return;
  }
  filter_->observation->add_contact(contact);
  const models::ContactReading before = std::exchange(contact_, contact);
  const bool begins = (contact.bump_left && !before.bump_left) ||
                      (contact.bump_right && !before.bump_right) ||
                      (contact.virtual_wall && !before.virtual_wall);
  if (!begins || is_lifted_ || !T_odom_updated_) {
    return;
  }
  update({});
  if (is_localized_by(LocalizedBy::kContacts)) {
    ++scans_;
    ++updates_;
    note_pose();
  }
}

void RobotLocalizer::begin_scan() {
  end_scan();
  scan_is_open_ = true;
}

void RobotLocalizer::end_scan() {
  if (!std::exchange(scan_is_open_, false)) {
    return;
  }
  const auto readings = params_.bearings_rad.empty()
                            ? evenly_picked(gathered_, T_odom_robot_, params_.max_readings)
                            : picked_at_bearings(gathered_, T_odom_robot_, params_.bearings_rad);
  update(readings);
  check_place(readings);
  gathered_.clear();
  on_the_way_.clear();
  ++scans_;
  ++updates_;
  note_pose();
}

bool RobotLocalizer::is_checked() const {
  return params_.preset == localization::LocalizerPreset::kDefault;
}

void RobotLocalizer::check_place(const std::vector<localization::RangeReading>& readings) {
  if (!filter_) {
    return;
  }
  const auto checked = filter_->monitor.check(
      filter_->localizer.belief(),
      {T_odom_robot_, readings, evenly_picked(on_the_way_, T_odom_robot_, params_.max_readings)});
  belief_ = checked.belief;
  if (checked.T_map_restart) {
    filter_->localizer.start_at(
        *checked.T_map_restart, localization::kFoundStddevM, localization::kFoundStddevRad);
  }
}

std::vector<geometry::Pose2> RobotLocalizer::sampled_poses(std::size_t count) const {
  std::vector<geometry::Pose2> poses;
  if (!filter_ || count == 0) {
    return poses;
  }
  const localization::Particles& particles = filter_->localizer.particles();
  const std::size_t step = (particles.size() + count - 1) / count;
  poses.reserve(count);
  for (std::size_t i = 0; i < particles.size(); i += step) {
    poses.push_back(particles.pose(i));
  }
  return poses;
}

double RobotLocalizer::telling(const geometry::Pose2& T_robot_goal) const {
  if (!filter_ || belief_.status == localization::LocalizationStatus::kLocalized) {
    return 0.0;
  }
  return filter_->monitor.telling(belief_.hypotheses, T_robot_goal);
}

void RobotLocalizer::follow(time::RobotTime stamp, const sensors::WheelTravel& travel) {
  T_odom_robot_ = odometry_.update(travel);
  stamp_ = std::max(stamp_, stamp);
  if (!T_odom_updated_) {
    update({});
    begin_at_told_start();
  } else if (has_moved(*T_odom_updated_, T_odom_robot_, params_.step_m, params_.step_rad)) {
    update({});
  }
}

void RobotLocalizer::on_odometry_pose(const sensors::OdometryPoseObservation& observation) {
  T_odom_robot_ = observation.T_odom_robot;
  stamp_ = observation.stamp;
}

void RobotLocalizer::on_range_scan(const sensors::RangeScan& scan) {
  ++scans_;
  if (is_late(scan)) {
    ++late_scans_;
    belief_.outcome = localization::LocalizerOutcome::kTimeRanBack;
    return;
  }
  gather(scan);
  const bool is_due =
      !T_odom_updated_ ||
      has_moved(*T_odom_updated_, T_odom_robot_, params_.scan_step_m, params_.scan_step_rad);
  if (!gathered_.empty() && is_due) {
    update(evenly_picked(gathered_, T_odom_robot_, params_.max_readings));
    gathered_.clear();
    ++updates_;
    note_pose();
  }
}

bool RobotLocalizer::is_late(const sensors::RangeScan& scan) {
  if (!scan.stamp_s) {
    return false;
  }
  const double last_s = scan_stamp_s_.value_or(-std::numeric_limits<double>::infinity());
  if (!(*scan.stamp_s >= last_s)) {
    return true;
  }
  scan_stamp_s_ = scan.stamp_s;
  stamp_ = time::robot_time(*scan.stamp_s);
  return false;
}

void RobotLocalizer::gather(const sensors::RangeScan& scan) {
  if (!filter_) {
    make_filter(robot_of(scan));
    if (start_) {
      filter_->localizer.update(T_odom_robot_, {});
      begin_at_told_start();
    }
  }
  scan_beam_width_rad_ = scan_beam_width_rad_.value_or(scan.beam_width_rad);
  if (scan.beam_width_rad != *scan_beam_width_rad_) {
    ++unused_scans_;
    return;
  }
  const geometry::Pose2 T_odom_sensor = T_odom_robot_ * scan.T_robot_sensor;
  for (const sensors::Beam& beam : scan.beams) {
    // Light's silence says nothing, and maps end not far beyond what it saw well.
    if (!is_light(scan) || (beam.range_m && *beam.range_m <= params_.max_laser_range_m)) {
      gathered_.push_back(
          {T_odom_sensor * geometry::Pose2(0.0, 0.0, beam.bearing_rad), beam.range_m});
    }
  }
}

void RobotLocalizer::update(const std::vector<localization::RangeReading>& readings) {
  if (!filter_) {
    return;
  }
  T_odom_updated_ = T_odom_robot_;
  belief_ = filter_->localizer.update(T_odom_robot_, readings);
  filter_->monitor.limit_confidence(belief_, T_odom_robot_);
  limit_by_rounds();
}

void RobotLocalizer::note_pose() {
  if (!belief_.hypotheses.empty()) {
    trajectory_.push_back({stamp_, belief_.hypotheses.front().T_map_robot});
  }
}

}  // namespace echomap::pipeline
