// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "host/localization/localizer_preset.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/localizer_feed.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::pipeline {

/// The sonar of a robot that is looked for in a map, and how.
struct RobotLocalizerParams {
  localization::LocalizedRobot sonar;
  /// The robot's motion is followed in steps of so much: of a turn to and fro only both ways tell
  /// how far it may be off.
  double step_m = 0.2;
  double step_rad = 0.5;
  /// So many readings of a scan are used, evenly picked.
  std::size_t max_readings = 60;
  localization::LocalizerPreset preset = localization::LocalizerPreset::kDefault;
};

/// Finds and follows a robot that drives in a map that is given: odometry and the sonar's scans in,
/// beliefs out, one a scan. A robot that is lifted may be anywhere from then on.
class RobotLocalizer final : public ObservationSink {
 public:
  /// The robot may be anywhere on the map's floor. Throws std::invalid_argument for invalid
  /// settings.
  RobotLocalizer(const mapping::RasterMap& map,
                 const sensors::RobotGeometry& robot,
                 const RobotLocalizerParams& params,
                 std::mt19937 random);

  /// The robot is about there, where it stands now or, before the first observation, is then.
  void start_at(const geometry::Pose2& T_map_robot, double stddev_m, double stddev_rad);
  /// The robot may be anywhere from now on: somebody says so.
  void start_anywhere();

  void on_odometry(const sensors::OdometryObservation& observation) override;
  /// Counts where it belongs to a scan and the robot stands.
  void on_sonar(const sensors::SonarObservation& observation) override;
  /// A wheel that hangs, or four cliffs at once, mean that the robot was lifted.
  void on_hazards(const sensors::HazardObservation& observation) override;
  void begin_scan() override;
  /// Updates the belief by the scan's readings, placed by odometry.
  void end_scan() override;

  /// Of the start that was told, once it counts: kMoved where it can be.
  localization::LocalizerOutcome start_outcome() const { return start_outcome_; }
  const localization::PoseBelief& belief() const { return localizer_.belief(); }
  /// Where it was believed to be at the end of each scan.
  const std::vector<StampedPose>& trajectory() const { return trajectory_; }
  std::size_t scans() const { return scans_; }
  /// How often the robot was lifted.
  std::size_t times_lifted() const { return times_lifted_; }

 private:
  void follow(time::RobotTime stamp, const sensors::WheelTravel& travel);
  void add_contact(const models::ContactReading& contact);
  void update(const std::vector<localization::RangeReading>& readings);

  sensors::RobotGeometry robot_;
  RobotLocalizerParams params_;
  std::unique_ptr<localization::ObservationModel> observation_;
  localization::MonteCarloLocalizer localizer_;
  sensors::WheelOdometry odometry_;
  std::optional<geometry::Pose2> T_odom_updated_;  ///< Empty before the first observation.
  std::optional<ToldStart> start_;                 ///< To begin with the first observation.
  localization::LocalizerOutcome start_outcome_ = localization::LocalizerOutcome::kMoved;
  time::RobotTime stamp_;
  std::vector<localization::RangeReading> open_scan_;  ///< From the odometry's frame.
  bool scan_is_open_ = false;
  bool is_lifted_ = false;
  bool touches_ = false;
  std::vector<StampedPose> trajectory_;
  std::size_t scans_ = 0;
  std::size_t times_lifted_ = 0;
};

}  // namespace echomap::pipeline
