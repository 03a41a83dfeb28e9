// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/point_cloud_map.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/observations.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::pipeline {

/// Observations in, snapshots out: the same object live and in replay, a function of its input
/// alone. Feed observations in the order of their stamps. Between stops the pose is odometry; at
/// the end of a scan it is moved to where the scan agrees with those before it.
class RobotPipeline final : public ObservationSink {
 public:
  explicit RobotPipeline(const sensors::RobotGeometry& robot,
                         const mapping::SonarMapperParams& params = {});

  void on_odometry(const sensors::OdometryObservation& observation) override;
  /// Places the reading by its own wheel travel. Its echo is a point of the map at once; the grid
  /// only takes readings of a scan.
  void on_sonar(const sensors::SonarObservation& observation) override;

  /// The last of each stands in the snapshot; a wheel that begins to hang counts as a lift.
  void on_hazards(const sensors::HazardObservation& observation) override;
  void on_infrared(const sensors::InfraredObservation& observation) override {
    infrared_ = observation;
  }
  void on_yaw(const sensors::YawObservation& observation) override { yaw_ = observation; }
  void on_battery(const sensors::BatteryObservation& observation) override {
    battery_ = observation;
  }

  void begin_scan() override;
  /// Puts the scan's readings into the grid together.
  void end_scan() override;

  Snapshot snapshot() const;

 private:
  /// The pose by odometry alone, after the wheels' travel so far.
  geometry::Pose2 follow(time::RobotTime stamp, const sensors::WheelTravel& travel);
  /// Moves a reading that odometry has placed to where it is on the map.
  mapping::PlacedReading on_map(const mapping::PlacedReading& reading) const;

  sensors::RobotGeometry robot_;
  mapping::SonarMapper mapper_;
  sensors::WheelOdometry odometry_;
  std::vector<StampedPose> trajectory_;
  mapping::PointCloudMap points_;
  std::shared_ptr<const mapping::OccupancyGrid> grid_;
  std::shared_ptr<const mapping::Scan> last_scan_;
  mapping::Scan open_scan_;
  bool scan_is_open_ = false;
  std::size_t stops_ = 0;
  double newly_free_m2_ = 0.0;
  sensors::HazardObservation hazards_;
  sensors::InfraredObservation infrared_;
  std::optional<sensors::YawObservation> yaw_;
  std::optional<sensors::BatteryObservation> battery_;
  std::size_t times_lifted_ = 0;
};

}  // namespace echomap::pipeline
