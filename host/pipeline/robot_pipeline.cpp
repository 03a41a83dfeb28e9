// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_pipeline.hpp"

#include <utility>

namespace echomap::pipeline {
namespace {

/// What may be written: a copy of its own where a snapshot still holds the one there is.
template <class Part>
Part& own(std::shared_ptr<Part>& part) {
  if (part.use_count() > 1) {
    part = std::make_shared<Part>(*part);
  }
  return *part;
}

}  // namespace

RobotPipeline::RobotPipeline(const sensors::RobotGeometry& robot,
                             const mapping::SonarMapperParams& params,
                             const mapping::NearMapperParams& near,
                             std::unique_ptr<slam::SlamMethod> slam)
    : robot_(robot),
      mapper_(params),
      near_(near, params.grid),
      odometry_(robot.track_m),
      far_grid_(std::make_shared<const mapping::OccupancyGrid>(params.grid)),
      grid_(far_grid_),
      scans_(std::make_shared<const std::vector<mapping::Scan>>()),
      last_scan_(std::make_shared<const mapping::Scan>()) {
  if (slam) {
    slam_.emplace(std::move(slam), 2.0 * params.surfaces.beam_half_angle_rad);
  }
}

void RobotPipeline::on_odometry(const sensors::OdometryObservation& observation) {
  follow(observation.stamp, observation.travel);
  if (times_lifted_ == 0) {
    near_.pass_over(T_map_robot());
  }
}

void RobotPipeline::on_sonar(const sensors::SonarObservation& observation) {
  const geometry::Pose2 T_odom_robot = follow(observation.stamp, observation.travel);
  const geometry::Pose2 T_odom_sonar = T_odom_robot * robot_.T_robot_sonar(observation.pan_rad);
  if (slam_) {
    slam_->hear(T_odom_robot, robot_.T_robot_sonar(observation.pan_rad), observation.range_m);
  }
  const mapping::PlacedReading reading{T_odom_robot, T_odom_sonar, observation.range_m};
  own(points_).add(on_map(reading));
  if (scan_is_open_) {
    open_scan_.push_back(reading);
  }
}

void RobotPipeline::on_infrared(const sensors::InfraredObservation& observation) {
  follow(observation.stamp, observation.travel);
  if (times_lifted_ == 0) {
    near_.see(T_map_robot(), observation.range_m);
  }
  infrared_ = observation;
}

void RobotPipeline::on_hazards(const sensors::HazardObservation& observation) {
  times_lifted_ += observation.is_in_the_air() && !hazards_.is_in_the_air() ? 1 : 0;
  if (times_lifted_ == 0) {
    near_.bump(T_map_robot(),
               observation.bump_left && !hazards_.bump_left,
               observation.bump_right && !hazards_.bump_right);
  }
  hazards_ = observation;
}

void RobotPipeline::on_carried(const sensors::CarriedObservation& observation) {
  end_scan();
  carried_to_.push_back(trajectory_->size());
  odometry_.move_to(T_map_odom().inverse() * observation.T_map_robot, observation.travel);
  if (slam_) {
    slam_->carry(odometry_.T_odom_robot());
  }
  follow(observation.stamp, observation.travel);
  hazards_ = {};
  times_lifted_ = 0;
}

void RobotPipeline::begin_scan() {
  end_scan();
  scan_is_open_ = true;
  if (slam_) {
    slam_->begin_stop();
  }
}

void RobotPipeline::end_scan() {
  if (!scan_is_open_) {
    return;
  }
  last_scan_fault_ = mapping::fault_of(on_map(open_scan_), *far_grid_);
  newly_free_m2_ = 0.0;
  const bool counts = last_scan_fault_ == mapping::ScanFault::kNone;
  if (slam_) {
    slam_->end_stop(counts);
  }
  if (counts) {
    map_scan();
  }
  if (slam_) {
    move_past();
  }
  last_scan_ = std::make_shared<const mapping::Scan>(on_map(std::exchange(open_scan_, {})));
  if (!trajectory_->empty()) {
    own(trajectory_).back().T_map_robot = T_map_robot();
  }
  scan_is_open_ = false;
  ++stops_;
}

void RobotPipeline::map_scan() {
  if (slam_) {
    placed_scans_ = slam_->stops();
    mapper_.take(placed_scans_);
  } else {
    placed_scans_.push_back(open_scan_);
    mapper_.add(open_scan_);
  }
  const auto grid = std::make_shared<const mapping::OccupancyGrid>(mapper_.grid());
  newly_free_m2_ = mapping::newly_free_area_m2(*far_grid_, *grid);
  far_grid_ = grid;
  grid_ = nullptr;
  std::vector<mapping::Scan> scans;
  for (std::size_t i = 0; i < placed_scans_.size(); ++i) {
    scans.push_back(mapping::moved(placed_scans_[i], mapper_.T_map_placed()[i]));
  }
  scans_ = std::make_shared<const std::vector<mapping::Scan>>(std::move(scans));
}

void RobotPipeline::move_past() {
  const std::vector<geometry::Pose2> T_map_robots = slam_->trajectory();
  auto& trajectory = own(trajectory_);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    trajectory[i].T_map_robot = T_map_robots[i];
  }
  points_ = std::make_shared<mapping::PointCloudMap>(slam_->points(T_map_robots));
}

void RobotPipeline::on_pose_fix(const sensors::PoseFixObservation& observation) {
  T_map_mapped_ = observation.T_map_robot * (T_map_mapped_.inverse() * T_map_robot()).inverse();
  if (!trajectory_->empty()) {
    own(trajectory_).back().T_map_robot = observation.T_map_robot;
  }
}

Snapshot RobotPipeline::snapshot() const {
  Snapshot snapshot;
  if (!trajectory_->empty()) {
    snapshot.latest = trajectory_->back();
  }
  snapshot.T_odom_robot = odometry_.T_odom_robot();
  snapshot.trajectory = trajectory_;
  snapshot.carried_to = carried_to_;
  snapshot.points = points_;
  snapshot.grid = grid();
  snapshot.scans = scans_;
  snapshot.last_scan = last_scan_;
  snapshot.last_scan_fault = last_scan_fault_;
  snapshot.stops = stops_;
  snapshot.newly_free_m2 = newly_free_m2_;
  snapshot.hazards = hazards_;
  snapshot.infrared = infrared_;
  snapshot.yaw = yaw_;
  snapshot.battery = battery_;
  snapshot.times_lifted = times_lifted_;
  return snapshot;
}

std::shared_ptr<const mapping::OccupancyGrid> RobotPipeline::grid() const {
  if (grid_ == nullptr || near_in_grid_ != near_.grid().revision()) {
    grid_ = std::make_shared<const mapping::OccupancyGrid>(
        mapping::with_near_evidence(*far_grid_, near_.grid()));
    near_in_grid_ = near_.grid().revision();
  }
  return grid_;
}

geometry::Pose2 RobotPipeline::follow(time::RobotTime stamp, const sensors::WheelTravel& travel) {
  geometry::Pose2 T_odom_robot = odometry_.update(travel);
  if (trajectory_->empty() || stamp > trajectory_->back().stamp) {
    if (slam_) {
      slam_->follow(T_odom_robot);
    }
    own(trajectory_).push_back({stamp, T_map_robot()});
  }
  return T_odom_robot;
}

geometry::Pose2 RobotPipeline::T_map_odom() const {
  const auto& T_map_scans = mapper_.T_map_placed();
  const geometry::Pose2 T_map_placed =
      T_map_scans.empty() ? T_map_mapped_ : T_map_mapped_ * T_map_scans.back();
  return slam_ ? T_map_placed * slam_->T_map_odom() : T_map_placed;
}

}  // namespace echomap::pipeline
