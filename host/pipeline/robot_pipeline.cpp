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
  const geometry::Pose2 T_map_robot = follow(observation.stamp, observation.travel);
  const geometry::Pose2 T_map_sonar = T_map_robot * robot_.T_robot_sonar(observation.pan_rad);
  const mapping::PlacedReading reading{T_map_robot, T_map_sonar, observation.range_m};
  points_.add(reading);
  if (scan_is_open_) {
    open_scan_.push_back(reading);
  }
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
  last_scan_ = std::make_shared<const mapping::Scan>(std::exchange(open_scan_, {}));
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
  return snapshot;
}

geometry::Pose2 RobotPipeline::follow(time::RobotTime stamp, const sensors::WheelTravel& travel) {
  geometry::Pose2 T_map_robot = odometry_.update(travel);
  if (trajectory_.empty() || stamp > trajectory_.back().stamp) {
    trajectory_.push_back({stamp, T_map_robot});
  }
  return T_map_robot;
}

}  // namespace echomap::pipeline
