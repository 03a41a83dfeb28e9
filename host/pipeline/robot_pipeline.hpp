// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/mapping/sonar_grid_update.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::pipeline {

struct RobotPipelineParams {
  mapping::OccupancyGridParams grid;
  mapping::SonarGridParams sonar;
};

/// Observations in, snapshots out: the same object live and in replay, a function of its input
/// alone. Feed observations in the order of their stamps.
class RobotPipeline {
 public:
  explicit RobotPipeline(const sensors::RobotGeometry& robot,
                         const RobotPipelineParams& params = {});

  void on_odometry(const sensors::OdometryObservation& observation);
  /// Places the reading by its own wheel travel. Within a scan it joins that scan; outside, it is
  /// a scan of its own that counts as no stop.
  void on_sonar(const sensors::SonarObservation& observation);

  /// Readings from here to `end_scan` are one scan, whatever turns of the body lie between them. A
  /// scan that was left open is ended first.
  void begin_scan();
  /// Puts the scan's readings into the grid together; does nothing where no scan is open.
  void end_scan();

  Snapshot snapshot() const;

 private:
  geometry::Pose2 follow(time::RobotTime stamp, const sensors::WheelTravel& travel);
  /// On a copy: the grid before may be part of a snapshot.
  void put_into_grid(const mapping::Scan& scan);

  sensors::RobotGeometry robot_;
  mapping::SonarGridUpdate sonar_grid_update_;
  sensors::WheelOdometry odometry_;
  std::vector<StampedPose> trajectory_;
  mapping::PointCloudMap points_;
  std::shared_ptr<const mapping::OccupancyGrid> grid_;
  std::shared_ptr<const mapping::Scan> last_scan_;
  mapping::Scan open_scan_;
  bool scan_is_open_ = false;
  std::size_t stops_ = 0;
  double newly_free_m2_ = 0.0;
};

}  // namespace echomap::pipeline
