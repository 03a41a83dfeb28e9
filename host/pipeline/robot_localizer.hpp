// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "host/localization/localizer_preset.hpp"
#include "host/localization/round_fit.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/localization_monitor.hpp"
#include "host/pipeline/localizer_feed.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::pipeline {

/// The sensor of a robot that is looked for in a map, and how.
struct RobotLocalizerParams {
  /// That of the first range scan where it is not known before.
  std::optional<localization::LocalizedRobot> sensor;
  /// The ring of a robot that is localized by infra-red, in the order of its readings.
  std::vector<geometry::Pose2> T_robot_infrared{};
  /// The robot's motion is followed in steps of so much: of a turn to and fro only both ways tell
  /// how far it may be off.
  double step_m = 0.2;
  double step_rad = 0.5;
  /// Range scans are gathered until the robot has moved by so much, since those from one place err
  /// together.
  double scan_step_m = 0.1;
  double scan_step_rad = 0.1745;
  /// A ring of infra-red sensors is read in steps of so much, since readings from one place err
  /// together.
  double infrared_step_m = 0.03;
  double infrared_step_rad = 0.35;
  /// So many readings of a scan are used, evenly picked.
  std::size_t max_readings = 60;
  /// Where not empty, of a sonar's scan the readings nearest to these bearings from the robot.
  std::vector<double> bearings_rad{};
  /// A laser's ranges count up to there, metres.
  double max_laser_range_m = 10.0;
  localization::LocalizerPreset preset = localization::LocalizerPreset::kDefault;
  /// In place of those of the preset: as many particles as that, resampled below that share of
  /// effective ones; 1 resamples at each update.
  std::optional<std::size_t> particles{};
  std::optional<double> resampling_share{};
  /// When scans contradict the believed place.
  LocalizationMonitorParams monitor;
};

/// Finds and follows a robot that drives in a map that is given: odometry, and a sonar's scans,
/// range scans of one kind of sensor, infra-red rounds or contacts in, beliefs out, one a scan. A
/// robot without scans is looked for in steps of its way, and at each contact. A robot that is
/// lifted may be anywhere from then on. What a log says of the robot's true pose is not looked
/// at.
class RobotLocalizer final : public ObservationSink {
 public:
  /// The robot may be anywhere on the map's floor. Throws std::invalid_argument for invalid
  /// settings.
  RobotLocalizer(mapping::RasterMap map,
                 const sensors::RobotGeometry& robot,
                 const RobotLocalizerParams& params,
                 std::mt19937 random);
  ~RobotLocalizer() override;

  /// The robot is about there, where it stands now or, before the first observation, is then.
  void start_at(const geometry::Pose2& T_map_robot, double stddev_m, double stddev_rad);
  /// The robot may be anywhere from now on: somebody says so.
  void start_anywhere();

  void on_odometry(const sensors::OdometryObservation& observation) override;
  /// Of a scan it updates the belief; between scans it helps to tell places apart at the next one.
  void on_sonar(const sensors::SonarObservation& observation) override;
  /// Counts once a step where the robot has such sensors, if it has a range of each.
  void on_infrared(const sensors::InfraredObservation& observation) override;
  /// A wheel that hangs, or four cliffs at once, mean that the robot was lifted.
  void on_hazards(const sensors::HazardObservation& observation) override;
  /// As a lift: where the robot was put down is what is looked for.
  void on_carried(const sensors::CarriedObservation& observation) override;
  void on_odometry_pose(const sensors::OdometryPoseObservation& observation) override;
  /// Counts where it is of the same kind of sensor, and not stamped before the one before it.
  void on_range_scan(const sensors::RangeScan& scan) override;
  void begin_scan() override;
  /// Updates the belief by the scan's readings, placed by odometry.
  void end_scan() override;

  /// Of the start that was told, once it counts: kMoved where it can be.
  localization::LocalizerOutcome start_outcome() const { return start_outcome_; }
  /// As of the last update; without any, nothing is known.
  const localization::PoseBelief& belief() const { return belief_; }
  /// How well a scan from a goal, seen from the robot, would tell apart the places where it may be:
  /// localization::ViewDifference. 0 where it is localized, or nothing is known.
  double telling(const geometry::Pose2& T_robot_goal) const;
  /// Poses where the robot may be, evenly chosen from the particles of the last update; `count` at
  /// most.
  std::vector<geometry::Pose2> sampled_poses(std::size_t count) const;
  /// The likeliest place at the end of each scan; without a sonar's scans, at each update.
  const std::vector<StampedPose>& trajectory() const { return trajectory_; }
  /// Scans, rounds of infra-red that counted, or contacts.
  std::size_t scans() const { return scans_; }
  /// Updates by scans.
  std::size_t updates() const { return updates_; }
  /// Range scans of another kind of sensor.
  std::size_t unused_scans() const { return unused_scans_; }
  /// Range scans that are left out since time ran backwards.
  std::size_t late_scans() const { return late_scans_; }
  /// How often the robot was lifted.
  std::size_t times_lifted() const { return times_lifted_; }

 private:
  struct Filter;

  void make_filter(const localization::LocalizedRobot& robot);
  void begin_at_told_start();
  bool is_late(const sensors::RangeScan& scan);
  void gather(const sensors::RangeScan& scan);
  void follow(time::RobotTime stamp, const sensors::WheelTravel& travel);
  /// Judges the believed place by a round of infra-red.
  void check_round(const std::vector<localization::RangeReading>& readings);
  void limit_by_rounds();
  bool is_localized_by(localization::LocalizedBy sensor) const;
  void add_contact(const models::ContactReading& contact);
  void lose_pose();
  void add_on_the_way(const localization::RangeReading& reading);
  void update(const std::vector<localization::RangeReading>& readings);
  void note_pose();
  /// By the default preset, which is ours; the papers' filters are as they are.
  bool is_checked() const;
  /// Checks the belief after a scan, and starts the filter again where it follows another place.
  void check_place(const std::vector<localization::RangeReading>& readings);

  sensors::RobotGeometry robot_;
  RobotLocalizerParams params_;
  mapping::RasterMap map_;
  std::mt19937 random_;
  std::unique_ptr<Filter> filter_;  ///< Once the sensor is known.
  sensors::WheelOdometry odometry_;
  geometry::Pose2 T_odom_robot_;
  std::optional<geometry::Pose2> T_odom_updated_;   ///< Empty before the first observation.
  std::optional<geometry::Pose2> T_odom_infrared_;  ///< At the last round that counted.
  std::optional<ToldStart> start_;                  ///< To begin with the first observation.
  localization::LocalizerOutcome start_outcome_ = localization::LocalizerOutcome::kMoved;
  localization::PoseBelief belief_;
  time::RobotTime stamp_;
  std::optional<double> scan_stamp_s_;                  ///< Of the last range scan.
  std::optional<double> scan_beam_width_rad_;           ///< Of the first.
  std::vector<localization::RangeReading> gathered_;    ///< From the odometry's frame.
  std::vector<localization::RangeReading> on_the_way_;  ///< As these, since the last scan.
  bool scan_is_open_ = false;
  bool is_lifted_ = false;
  models::ContactReading contact_;
  localization::RoundFit round_fit_;
  std::vector<StampedPose> trajectory_;
  std::size_t scans_ = 0;
  std::size_t updates_ = 0;
  std::size_t unused_scans_ = 0;
  std::size_t late_scans_ = 0;
  std::size_t times_lifted_ = 0;
};

}  // namespace echomap::pipeline
