// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_pipeline.hpp"

#include <utility>

namespace echomap::pipeline {

RobotPipeline::RobotPipeline(const sensors::RobotGeometry& robot,
                             const mapping::SonarMapperParams& params)
    : robot_(robot),
      mapper_(params),
      odometry_(robot.track_m),
      grid_(std::make_shared<const mapping::OccupancyGrid>(params.grid)),
      last_scan_(std::make_shared<const mapping::Scan>()) {}

void RobotPipeline::on_odometry(const sensors::OdometryObservation& observation) {
  follow(observation.stamp, observation.travel);
}

void RobotPipeline::on_sonar(const sensors::SonarObservation& observation) {
  const geometry::Pose2 T_odom_robot = follow(observation.stamp, observation.travel);
  const geometry::Pose2 T_odom_sonar = T_odom_robot * robot_.T_robot_sonar(observation.pan_rad);
  const mapping::PlacedReading reading{T_odom_robot, T_odom_sonar, observation.range_m};
  points_.add(on_map(reading));
  if (scan_is_open_) {
    open_scan_.push_back(reading);
  }
}

void RobotPipeline::on_hazards(const sensors::HazardObservation& observation) {
  times_lifted_ += observation.lifted && !hazards_.lifted ? 1 : 0;
  hazards_ = observation;
}

void RobotPipeline::begin_scan() {
  end_scan();
  scan_is_open_ = true;
}

void RobotPipeline::end_scan() {
  if (!scan_is_open_) {
    return;
  }
  mapper_.add(open_scan_);
  const auto grid = std::make_shared<const mapping::OccupancyGrid>(mapper_.grid());
  newly_free_m2_ = mapping::newly_free_area_m2(*grid_, *grid);
  grid_ = grid;
  mapping::Scan scan;
  for (const auto& reading : std::exchange(open_scan_, {})) {
    scan.push_back(on_map(reading));
  }
  last_scan_ = std::make_shared<const mapping::Scan>(std::move(scan));
  if (!trajectory_.empty()) {
    trajectory_.back().T_map_robot = mapper_.T_map_odom() * odometry_.T_odom_robot();
  }
  scan_is_open_ = false;
  ++stops_;
}

Snapshot RobotPipeline::snapshot() const {
  Snapshot snapshot;
  if (!trajectory_.empty()) {
    snapshot.latest = trajectory_.back();
  }
  snapshot.trajectory = std::make_shared<const std::vector<StampedPose>>(trajectory_);
  snapshot.points = std::make_shared<const mapping::PointCloudMap>(points_);
  snapshot.grid = grid_;
  snapshot.last_scan = last_scan_;
  snapshot.stops = stops_;
  snapshot.newly_free_m2 = newly_free_m2_;
  snapshot.hazards = hazards_;
  snapshot.infrared = infrared_;
  snapshot.yaw = yaw_;
  snapshot.battery = battery_;
  snapshot.times_lifted = times_lifted_;
  return snapshot;
}

geometry::Pose2 RobotPipeline::follow(time::RobotTime stamp, const sensors::WheelTravel& travel) {
  geometry::Pose2 T_odom_robot = odometry_.update(travel);
  if (trajectory_.empty() || stamp > trajectory_.back().stamp) {
    trajectory_.push_back({stamp, mapper_.T_map_odom() * T_odom_robot});
  }
  return T_odom_robot;
}

mapping::PlacedReading RobotPipeline::on_map(const mapping::PlacedReading& reading) const {
  return {mapper_.T_map_odom() * reading.T_map_robot,
          mapper_.T_map_odom() * reading.T_map_sonar,
          reading.range_m};
}

}  // namespace echomap::pipeline
