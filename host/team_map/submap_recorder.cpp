// SPDX-License-Identifier: MIT
#include "host/team_map/submap_recorder.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include "host/time/robot_seconds.hpp"

namespace echomap::team_map {

namespace {

constexpr double kWayStepM = 0.1;
/// Poses farther than this from the stop are left out of a submap, whose message has a limit
/// (fleet_messages/messages.hpp).
constexpr double kMaxReachM = 29.0;

template <class Things>
void append(Things& to, const Things& things) {
  to.insert(to.end(), things.begin(), things.end());
}

}  // namespace

SubmapRecorder::SubmapRecorder(const sensors::RobotGeometry& robot)
    : robot_(robot), odometry_(robot.track_m) {
  robot.validate();
}

void SubmapRecorder::on(const sensors::Observation& observation) {
  if (const auto* odometry = std::get_if<sensors::OdometryObservation>(&observation)) {
    follow(odometry->stamp, odometry->travel);
  } else if (const auto* sonar = std::get_if<sensors::SonarObservation>(&observation)) {
    add(*sonar);
  } else if (const auto* infrared = std::get_if<sensors::InfraredObservation>(&observation)) {
    follow(infrared->stamp, infrared->travel);
  } else if (const auto* hazards = std::get_if<sensors::HazardObservation>(&observation)) {
    add(*hazards);
  } else if (const auto* carried = std::get_if<sensors::CarriedObservation>(&observation)) {
    carry(*carried);
  } else if (std::holds_alternative<sensors::BeginScan>(observation)) {
    finish_submap();
    is_at_stop_ = true;
  } else if (std::holds_alternative<sensors::EndScan>(observation)) {
    finish_submap();
  }
}

void SubmapRecorder::follow(time::RobotTime stamp, const sensors::WheelTravel& travel) {
  odometry_.update(travel);
  if (!last_stamp_ || stamp > *last_stamp_) {
    meter_.follow(odometry_.T_odom_robot());
  }
  move_on(stamp);
}

void SubmapRecorder::move_on(time::RobotTime stamp) {
  if (!last_stamp_) {
    open_.begin_s = time::robot_seconds(stamp);
  }
  last_stamp_ = std::max(stamp, last_stamp_.value_or(stamp));
  const geometry::Pose2& T_odom_robot = odometry_.T_odom_robot();
  std::vector<geometry::Pose2>& way = open_.T_odom_way;
  if (!status_.has_void_pose() &&
      (way.empty() || (T_odom_robot.position_m() - way.back().position_m()).norm() >= kWayStepM)) {
    way.push_back(T_odom_robot);
  }
}

void SubmapRecorder::add(const sensors::SonarObservation& observation) {
  follow(observation.stamp, observation.travel);
  if (!is_at_stop_ || !observation.has_answered) {
    return;
  }
  slam::OdometryMark mark = meter_.mark();
  mark.T_odom_robot = odometry_.T_odom_robot();
  open_.readings.push_back({mark, robot_.T_robot_sonar(observation.pan_rad), observation.range_m});
}

void SubmapRecorder::add(const sensors::HazardObservation& observation) {
  const pipeline::NewBumps bumps = status_.on_hazards(observation);
  if (!status_.has_void_pose() && (bumps.left || bumps.right)) {
    open_.contacts.push_back({odometry_.T_odom_robot(), bumps.left, bumps.right});
  }
}

void SubmapRecorder::carry(const sensors::CarriedObservation& observation) {
  finish_submap();
  odometry_.move_to(observation.T_map_robot, observation.travel);
  meter_.carry(odometry_.T_odom_robot());
  status_.on_carried();
  move_on(observation.stamp);
}

void SubmapRecorder::finish_submap() {
  is_at_stop_ = false;
  if (open_.readings.empty()) {
    return;
  }
  Submap ended = std::exchange(open_, {});
  ended.index = static_cast<std::uint32_t>(submaps_.size());
  ended.end_s = time::robot_seconds(*last_stamp_);
  open_.begin_s = ended.end_s;
  const Eigen::Vector2d middle_m = ended.readings.front().mark.T_odom_robot.position_m();
  const auto is_far = [&](const geometry::Pose2& T_odom_robot) {
    return (T_odom_robot.position_m() - middle_m).norm() > kMaxReachM;
  };
  std::erase_if(ended.T_odom_way, is_far);
  std::erase_if(ended.contacts, [&](const auto& contact) { return is_far(contact.T_odom_robot); });
  submaps_.push_back(std::move(ended));
}

void SubmapRecorder::drop_last() {
  if (submaps_.empty()) {
    return;
  }
  Submap dropped = std::move(submaps_.back());
  submaps_.pop_back();
  append(dropped.T_odom_way, open_.T_odom_way);
  append(dropped.contacts, open_.contacts);
  open_.T_odom_way = std::move(dropped.T_odom_way);
  open_.contacts = std::move(dropped.contacts);
  open_.begin_s = dropped.begin_s;
}

std::vector<geometry::Pose2> T_map_submaps(const pipeline::Snapshot& snapshot) {
  std::vector<geometry::Pose2> poses;
  for (const mapping::Scan& scan : *snapshot.scans) {
    if (!scan.empty()) {
      poses.push_back(scan.front().T_map_robot);
    }
  }
  return poses;
}

}  // namespace echomap::team_map
