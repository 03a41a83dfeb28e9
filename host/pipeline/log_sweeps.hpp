// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/datasets/log_record.hpp"
#include "host/sensors/beam_width.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {

/// The sweeps of a log: what a turning sonar has heard from one place, in one go, bearings rising
/// or falling throughout. Pings that the log has one by one are of one sweep until the robot moves
/// or the sonar turns back. Lasers have no cone, and are left out.
class LogSweeps {
 public:
  void add(const datasets::LogRecord& record);
  /// Call after the last record.
  void finish() { end_sweep(); }

  /// Those of three readings or more.
  const std::vector<std::vector<sensors::Beam>>& sweeps() const { return sweeps_; }
  /// Scans of a laser, which say nothing here.
  std::size_t laser_scans() const { return laser_scans_; }

 private:
  void add_scan(const sensors::RangeScan& scan);
  void add_reading(const sensors::Beam& reading);
  void end_sweep();

  geometry::Pose2 T_odom_last_;
  std::vector<sensors::Beam> open_;
  std::vector<std::vector<sensors::Beam>> sweeps_;
  std::size_t laser_scans_ = 0;
};

}  // namespace echomap::pipeline
