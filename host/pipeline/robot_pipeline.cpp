// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_pipeline.hpp"

#include <utility>

namespace echomap::pipeline {

RobotPipeline::RobotPipeline(const sensors::RobotGeometry& robot,
                             const mapping::SonarMapperParams& params,
                             const mapping::ContactMapperParams& near,
                             std::unique_ptr<slam::SlamMethod> slam)
    : robot_(robot),
      track_(robot.track_m, std::move(slam), 2.0 * params.surfaces.beam_half_angle_rad),
      map_(params, near) {}

void RobotPipeline::on_odometry(const sensors::OdometryObservation& observation) {
  track_.follow(observation.stamp, observation.travel);
  if (!status_.has_void_pose()) {
    map_.contacts().pass_over(track_.T_map_robot());
  }
}

void RobotPipeline::on_sonar(const sensors::SonarObservation& observation) {
  const geometry::Pose2 T_odom_robot = track_.follow(observation.stamp, observation.travel);
  const geometry::Pose2 T_robot_sonar = robot_.T_robot_sonar(observation.pan_rad);
  if (RobotSlam* slam = track_.slam()) {
    slam->add_ping(T_odom_robot, T_robot_sonar, observation.range_m);
  }
  const mapping::PlacedReading reading{
      T_odom_robot, T_odom_robot * T_robot_sonar, observation.range_m};
  map_.add_echo(track_.on_map(reading));
  if (open_scan_) {
    open_scan_->push_back(reading);
  }
}

void RobotPipeline::on_infrared(const sensors::InfraredObservation& observation) {
  track_.follow(observation.stamp, observation.travel);
  if (!status_.has_void_pose()) {
    map_.contacts().add_ranges(track_.T_map_robot(), observation.range_m);
  }
  status_.on_infrared(observation);
}

void RobotPipeline::on_hazards(const sensors::HazardObservation& observation) {
  const NewBumps bumps = status_.on_hazards(observation);
  if (!status_.has_void_pose()) {
    map_.contacts().bump(track_.T_map_robot(), bumps.left, bumps.right);
  }
}

void RobotPipeline::on_carried(const sensors::CarriedObservation& observation) {
  end_scan();
  track_.carry(observation);
  status_.on_carried();
}

void RobotPipeline::on_pose_fix(const sensors::PoseFixObservation& observation) {
  track_.fix(observation.T_map_robot);
}

void RobotPipeline::begin_scan() {
  end_scan();
  open_scan_.emplace();
  if (RobotSlam* slam = track_.slam()) {
    slam->begin_stop();
  }
}

void RobotPipeline::end_scan() {
  if (!open_scan_) {
    return;
  }
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): checked above
  const mapping::Scan scan = std::move(*std::exchange(open_scan_, std::nullopt));
  const mapping::ScanFault fault = map_.fault_of(track_.on_map(scan));
  const bool counts = fault == mapping::ScanFault::kNone;
  if (RobotSlam* slam = track_.slam()) {
    slam->end_stop(counts);
    if (counts) {
      track_.correct(map_.replace_stops(slam->stops()));
    }
    map_.replace_points(slam->points(track_.apply_corrected_trajectory()));
  } else if (counts) {
    track_.correct(map_.add_stop(scan));
  }
  map_.end_stop(track_.on_map(scan), fault);
  track_.update_last_pose();
}

Snapshot RobotPipeline::snapshot() const {
  Snapshot snapshot;
  track_.describe(snapshot);
  map_.describe(snapshot);
  status_.describe(snapshot);
  return snapshot;
}

}  // namespace echomap::pipeline
