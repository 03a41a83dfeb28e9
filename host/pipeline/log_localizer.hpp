// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/localization/localizer_preset.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/pipeline/localizer_feed.hpp"
#include "host/pipeline/log_poses.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

/// How a log is followed in a map.
struct LogLocalizerParams {
  /// Ranges are gathered until the robot has moved by so much, since those from one place err
  /// together.
  double step_m = 0.1;
  double step_rad = 0.1745;
  /// So many of them are used, evenly picked.
  std::size_t max_readings = 60;
  /// A laser's ranges count up to there, metres.
  double max_laser_range_m = 10.0;
  localization::LocalizerPreset preset = localization::LocalizerPreset::kDefault;
};

/// Finds and follows the robot of a log in a map that is given, record by record, by its odometry
/// and the ranges of one kind of sensor, that of the first scan. What the log itself says of the
/// robot's true pose is not looked at.
class LogLocalizer {
 public:
  /// Throws std::invalid_argument for invalid settings.
  LogLocalizer(mapping::RasterMap map, const LogLocalizerParams& params, std::mt19937 random);
  ~LogLocalizer();

  /// The robot starts about there. Before the first record.
  void start_at(const geometry::Pose2& T_map_robot, double stddev_m, double stddev_rad);

  void add(const datasets::LogRecord& record);

  /// As of the last update; without any, nothing is known.
  const localization::PoseBelief& belief() const { return belief_; }
  /// Of the start that was given; kMoved where none was, or while there was no scan.
  localization::LocalizerOutcome start_outcome() const { return start_outcome_; }
  /// Where it was believed to be at each update that has a stamp and a hypothesis.
  const std::vector<StampedPose>& trajectory() const { return trajectory_; }
  std::size_t updates() const { return updates_; }
  std::size_t scans() const { return scans_; }
  /// Scans of another kind of sensor.
  std::size_t unused_scans() const { return unused_scans_; }
  /// Scans that are left out since time ran backwards: stamped before the one that came before.
  std::size_t late_scans() const { return late_scans_; }

 private:
  struct Sensor;

  void gather(const sensors::RangeScan& scan);
  bool is_late(const sensors::RangeScan& scan);
  void update();

  mapping::RasterMap map_;
  LogLocalizerParams params_;
  std::mt19937 random_;
  LogPoses poses_{PoseSource::kOdometry};
  std::unique_ptr<Sensor> sensor_;  ///< Since the first scan.
  std::optional<ToldStart> start_;
  std::vector<localization::RangeReading> gathered_;  ///< From the odometry's frame.
  std::optional<geometry::Pose2> T_odom_updated_;
  std::optional<double> stamp_s_;
  std::optional<double> scan_stamp_s_;
  localization::PoseBelief belief_;
  localization::LocalizerOutcome start_outcome_ = localization::LocalizerOutcome::kMoved;
  std::vector<StampedPose> trajectory_;
  std::size_t updates_ = 0;
  std::size_t scans_ = 0;
  std::size_t unused_scans_ = 0;
  std::size_t late_scans_ = 0;
};

}  // namespace echomap::pipeline
