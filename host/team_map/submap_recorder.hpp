// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/robot_status.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "host/slam/odometry_meter.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::team_map {

/// Builds a submap of every stop of one robot from its odometry, beside the pipeline that builds
/// its map (pipeline::ObservationFork). Pings between stops are in no submap.
class SubmapRecorder final : public pipeline::AnyObservationSink {
 public:
  /// Throws std::invalid_argument for a geometry without sizes.
  explicit SubmapRecorder(const sensors::RobotGeometry& robot);

  void on(const sensors::Observation& observation) override;

  /// Robot pose in the odometry frame of its submaps.
  const geometry::Pose2& T_odom_robot() const { return odometry_.T_odom_robot(); }
  /// One for each stop that has ended with at least one answer of the sonar.
  const std::vector<Submap>& submaps() const { return submaps_; }
  /// Discards the last submap, where the map has discarded its stop, too
  /// (pipeline::Snapshot::last_scan_fault): its path and contacts go to the next one. Does nothing
  /// without a submap.
  void drop_last();

 private:
  void follow(time::RobotTime stamp, const sensors::WheelTravel& travel);
  void move_on(time::RobotTime stamp);
  void add(const sensors::SonarObservation& observation);
  void add(const sensors::HazardObservation& observation);
  void carry(const sensors::CarriedObservation& observation);
  void finish_submap();

  sensors::RobotGeometry robot_;
  sensors::WheelOdometry odometry_;
  slam::OdometryMeter meter_;
  pipeline::RobotStatus status_;
  std::optional<time::RobotTime> last_stamp_;
  bool is_at_stop_ = false;
  Submap open_;
  std::vector<Submap> submaps_;
};

/// Robot poses on its map at the first reading of each submap, as its pipeline has them now. The
/// recorder must have dropped the stops that the pipeline has discarded.
std::vector<geometry::Pose2> T_map_submaps(const pipeline::Snapshot& snapshot);

}  // namespace echomap::team_map
