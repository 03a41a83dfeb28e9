// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_pipeline.hpp"

#include <stdexcept>
#include <utility>

#include "host/slam/factor_graph.hpp"

namespace echomap::pipeline {

RobotPipeline::RobotPipeline(const sensors::RobotGeometry& robot,
                             const mapping::SonarMapperParams& params,
                             const mapping::ContactMapperParams& near,
                             std::unique_ptr<slam::SlamMethod> slam,
                             const ScanMapParams& scans)
    : robot_(robot),
      track_(robot.track_m, std::move(slam), 2.0 * params.surfaces.beam_half_angle_rad),
      map_(params, near),
      scan_params_(scans),
      scan_map_(scans) {}

void RobotPipeline::on_odometry(const sensors::OdometryObservation& observation) {
  track_.follow(observation.stamp, observation.travel);
  pass_over_floor();
}

void RobotPipeline::pass_over_floor() {
  if (!status_.has_void_pose()) {
    map_.contacts().pass_over(track_.T_map_robot());
  }
}

void RobotPipeline::on_sonar(const sensors::SonarObservation& observation) {
  const geometry::Pose2 T_odom_robot = track_.follow(observation.stamp, observation.travel);
  const geometry::Pose2 T_robot_sonar = robot_.T_robot_sonar(observation.pan_rad);
  RobotSlam* slam = track_.slam();
  if (slam != nullptr && observation.has_answered) {
    slam->add_ping(T_odom_robot, T_robot_sonar, observation.range_m);
  }
  const mapping::PlacedReading reading{
      T_odom_robot, T_odom_robot * T_robot_sonar, observation.range_m, observation.has_answered};
  map_.add_echo(track_.on_map(reading));
  if (open_scan_) {
    open_scan_->push_back(mapping::moved(reading, T_calibrated_odom()));
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
    map_.contacts().bump(
        track_.T_map_robot(), bumps.left, bumps.right, observation.bumper_radius_m);
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

void RobotPipeline::on_odometry_pose(const sensors::OdometryPoseObservation& observation) {
  track_.follow(observation.stamp, observation.T_odom_robot);
  pass_over_floor();
}

void RobotPipeline::on_range_scan(const sensors::RangeScan& scan) {
  if (RobotSlam* slam = track_.slam()) {
    slam->add_scan(track_.T_odom_robot(), scan);
  }
  add_sighting(scan);
}

void RobotPipeline::on_landmark(const sensors::LandmarkObservation& observation) {
  add_sighting(observation);
}

template <class Seen>
void RobotPipeline::add_sighting(const Seen& seen) {
  if (track_.poses() == 0) {
    track_.follow({}, geometry::Pose2());
  }
  if (track_.slam() != nullptr) {
    sightings_.push_back({track_.poses() - 1, seen});
  } else {
    scan_map_.add(track_.latest(), seen);
  }
}

geometry::Pose2 RobotPipeline::T_calibrated_odom() const {
  const RobotSlam* slam = track_.slam();
  return slam == nullptr ? geometry::Pose2() : slam->T_calibrated_odom();
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
  const mapping::Scan calibrated = std::move(*std::exchange(open_scan_, std::nullopt));
  const mapping::Scan scan = mapping::moved(calibrated, T_calibrated_odom().inverse());
  const mapping::Scan answered = mapping::answered(scan);
  const mapping::ScanFault fault = map_.fault_of(track_.on_map(answered));
  const bool is_dead = answered.empty() && !scan.empty();
  const bool counts = fault == mapping::ScanFault::kNone && !is_dead;
  if (RobotSlam* slam = track_.slam()) {
    slam->end_stop(counts);
    map_.replace_points(slam->points(track_.apply_corrected_trajectory()));
    if (counts) {
      map_.replace_stops(slam->stops(), track_.positions_m());
    }
  } else if (counts) {
    map_.add_stop(track_.on_map(answered), track_.positions_m());
  }
  map_.end_stop(track_.on_map(scan), fault);
  track_.update_last_pose();
}

Snapshot RobotPipeline::snapshot() const {
  Snapshot snapshot;
  track_.describe(snapshot);
  map_.describe(snapshot);
  describe_scans(snapshot);
  status_.describe(snapshot);
  return snapshot;
}

void RobotPipeline::describe_scans(Snapshot& snapshot) const {
  if (sightings_.empty()) {
    if (!scan_map_.is_empty() || scan_params_.map == MapKind::kPoints) {
      scan_map_.describe(snapshot);
    }
    return;
  }
  const std::vector<StampedPose> trajectory = track_.corrected_trajectory();
  ScanMap map(scan_params_);
  for (const auto& [pose_index, seen] : sightings_) {
    std::visit([&map, &robot = trajectory[pose_index]](const auto& kind) { map.add(robot, kind); },
               seen);
  }
  map.describe(snapshot);
  snapshot.latest = trajectory.back();
  snapshot.trajectory = std::make_shared<const std::vector<StampedPose>>(trajectory);
}

slam::FactorGraph RobotPipeline::factor_graph() const {
  if (slam() == nullptr) {
    throw std::logic_error("no SLAM runs, which would have a factor graph");
  }
  return slam::in_frame_a(track_.T_map_slam(), slam()->factor_graph());
}

}  // namespace echomap::pipeline
