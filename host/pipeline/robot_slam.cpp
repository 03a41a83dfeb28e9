// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_slam.hpp"

#include <utility>

#include "host/geometry/angle.hpp"
#include "host/slam/stop_stand.hpp"
#include "host/slam/turn_calibration.hpp"

namespace echomap::pipeline {

namespace {

using geometry::Pose2;

/// A method that changes its correction of odometry by less has estimated nothing anew.
constexpr double kSameM = 1e-3;
constexpr double kSameRad = 1e-3;
/// Anchors that are nearer to a pose by less are as near: those of one stop.
constexpr double kSamePlaceM = 0.05;

slam::StopAlignmentParams alignment_for(double beam_width_rad) {
  slam::StopAlignmentParams params;
  params.surfaces.beam_half_angle_rad = 0.5 * beam_width_rad;
  params.heading.beam_half_angle_rad = 0.5 * beam_width_rad;
  return params;
}

/// Between two poses that are near each other.
Pose2 interpolated(const Pose2& from, const Pose2& to, double share) {
  const Eigen::Vector2d position_m =
      from.position_m() + share * (to.position_m() - from.position_m());
  const double turn_rad = geometry::angle_between(from.heading_rad(), to.heading_rad());
  return {position_m.x(), position_m.y(), from.heading_rad() + share * turn_rad};
}

}  // namespace

RobotSlam::RobotSlam(std::unique_ptr<slam::SlamMethod> method, double beam_width_rad)
    : method_(std::move(method)),
      track_(*method_),
      beam_width_rad_(beam_width_rad),
      alignment_(alignment_for(beam_width_rad)) {}

void RobotSlam::carry(const Pose2& T_odom_robot) {
  const Pose2 T_calibrated_robot = odometry_.carry(T_odom_robot);
  meter_.carry(T_calibrated_robot);
  method_->carry(T_calibrated_robot);
}

void RobotSlam::follow(const Pose2& T_odom_robot) {
  const Pose2 T_calibrated_robot = odometry_.follow(T_odom_robot);
  meter_.follow(T_calibrated_robot);
  if (is_at_stop_) {
    held_T_calibrated_robots_.push_back(T_calibrated_robot);
  } else {
    track_.follow(T_calibrated_robot);
  }
}

void RobotSlam::begin_stop() {
  is_at_stop_ = true;
  odometry_before_ = odometry_;
  meter_before_ = meter_;
}

void RobotSlam::add_ping(const geometry::Pose2& T_odom_robot,
                         const geometry::Pose2& T_robot_sonar,
                         const std::optional<double>& range_m) {
  const std::size_t instants = track_.instants() + held_T_calibrated_robots_.size();
  slam::OdometryMark mark = meter_.mark();
  mark.T_odom_robot = odometry_.T_calibrated_odom() * T_odom_robot;
  pings_.push_back({instants - 1, T_robot_sonar, range_m, mark});
  if (is_at_stop_) {
    ++held_pings_;
  } else {
    count(pings_.back());
  }
}

void RobotSlam::end_stop(bool pings_count) {
  const std::size_t first = pings_.size() - std::exchange(held_pings_, 0);
  if (pings_count && first_pings_.empty()) {
    calibrate_by_stop(first);
  }
  auto ping = pings_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto count_so_far = [&] {
    for (; pings_count && ping != pings_.end() && ping->instant < track_.instants(); ++ping) {
      count(*ping);
    }
  };
  count_so_far();  // Those whose stamps have not risen.
  for (const Pose2& T_calibrated_robot : std::exchange(held_T_calibrated_robots_, {})) {
    track_.follow(T_calibrated_robot);
    count_so_far();
  }
  if (pings_count && first < pings_.size()) {
    align_stops(first);
  }
  is_at_stop_ = false;
}

void RobotSlam::calibrate_by_stop(std::size_t first_ping) {
  const auto share = slam::turn_share(readings_from(first_ping), {});
  if (!share) {
    return;
  }
  odometry_ = odometry_before_;
  odometry_.calibrate({{*share, 0.0, 0.0}});
  meter_ = meter_before_;
  std::size_t instants = track_.instants();
  std::size_t ping = first_ping;
  const auto calibrate_so_far = [&] {
    for (; ping < pings_.size() && pings_[ping].instant < instants; ++ping) {
      const Pose2 T_odom_robot = pings_[ping].mark.T_odom_robot;
      pings_[ping].mark = meter_.mark();
      pings_[ping].mark.T_odom_robot = odometry_.T_calibrated_odom() * T_odom_robot;
    }
  };
  calibrate_so_far();  // Those whose stamps have not risen.
  for (Pose2& T_held_robot : held_T_calibrated_robots_) {
    T_held_robot = odometry_.follow(T_held_robot);
    meter_.follow(T_held_robot);
    ++instants;
    calibrate_so_far();
  }
}

std::vector<slam::StopReading> RobotSlam::readings_from(std::size_t first_ping) const {
  std::vector<slam::StopReading> readings;
  for (std::size_t i = first_ping; i < pings_.size(); ++i) {
    readings.push_back({pings_[i].mark, pings_[i].T_robot_sonar, pings_[i].range_m});
  }
  return readings;
}

void RobotSlam::count(const Ping& ping) {
  add(ping.mark.T_odom_robot,
      {{}, ping.T_robot_sonar, {{0.0, ping.range_m}}, beam_width_rad_, 0.0});
}

void RobotSlam::add(const Pose2& T_calibrated_robot, const sensors::RangeScan& scan) {
  track_.add(T_calibrated_robot, scan);
  if (is_at_stop_ || first_pings_.empty() ||
      slam::is_near(track_.T_map_odom(), T_slam_odom_, kSameM, kSameRad)) {
    return;
  }
  correct_by(nearest_to(track_.T_map_odom() * T_calibrated_robot));
}

void RobotSlam::correct_by(const Anchor& anchor) {
  T_map_slam_ = anchor.T_map_slam();
  T_slam_odom_ = track_.T_map_odom();
}

RobotSlam::Anchor RobotSlam::nearest_to(const Pose2& T_slam_robot) const {
  const std::vector<Anchor> anchors = this->anchors();
  const auto distance_m = [&](const Anchor& anchor) {
    return (anchor.T_slam_robot.position_m() - T_slam_robot.position_m()).norm();
  };
  auto nearest = anchors.rbegin();
  for (auto anchor = anchors.rbegin(); anchor != anchors.rend(); ++anchor) {
    if (distance_m(*anchor) < distance_m(*nearest) - kSamePlaceM) {
      nearest = anchor;
    }
  }
  return *nearest;
}

void RobotSlam::align_stops(std::size_t first_ping) {
  first_pings_.push_back(first_ping);
  alignment_.add_stop(readings_from(first_ping));
  std::vector<std::size_t> pings;
  for (const slam::StopStand& stand : alignment_.stands()) {
    pings.push_back(first_pings_[stand.stop] + stand.first);
  }
  alignment_.align(T_slam_robots(pings));
  correct_by(anchors().back());
}

std::vector<Pose2> RobotSlam::T_slam_robots(const std::vector<std::size_t>& pings) const {
  std::vector<std::size_t> instants;
  for (const std::size_t ping : pings) {
    instants.push_back(pings_[ping].instant);
  }
  std::vector<Pose2> poses = track_.T_map_odom_at(instants);
  for (std::size_t i = 0; i < pings.size(); ++i) {
    poses[i] = poses[i] * pings_[pings[i]].mark.T_odom_robot;
  }
  return poses;
}

std::vector<RobotSlam::Anchor> RobotSlam::anchors() const {
  std::vector<Anchor> anchors;
  std::vector<std::size_t> pings;
  for (std::size_t i = 0; i < alignment_.stands().size(); ++i) {
    const slam::StopStand& stand = alignment_.stands()[i];
    const std::size_t first = first_pings_[stand.stop] + stand.first;
    for (const std::size_t ping : {first, first + stand.resting - 1}) {
      const Pose2 T_first_ping =
          pings_[first].mark.T_odom_robot.inverse() * pings_[ping].mark.T_odom_robot;
      anchors.push_back({pings_[ping].instant, alignment_.T_map_stands()[i] * T_first_ping, {}});
      pings.push_back(ping);
    }
  }
  const std::vector<Pose2> T_slam_pings = T_slam_robots(pings);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    anchors[i].T_slam_robot = T_slam_pings[i];
  }
  return anchors;
}

std::vector<Pose2> RobotSlam::trajectory() const {
  std::vector<Pose2> poses = track_.trajectory();
  const std::vector<Anchor> anchors = this->anchors();
  if (anchors.empty()) {
    return poses;
  }
  auto after = anchors.begin();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    while (after != anchors.end() && after->instant < i) {
      ++after;
    }
    if (after == anchors.begin() || after == anchors.end()) {
      poses[i] = (after == anchors.end() ? T_map_slam_ : after->T_map_slam()) * poses[i];
      continue;
    }
    const Anchor& before = *(after - 1);
    const double share = static_cast<double>(i - before.instant) /
                         static_cast<double>(after->instant - before.instant);
    poses[i] = interpolated(before.T_map_slam() * poses[i], after->T_map_slam() * poses[i], share);
  }
  return poses;
}

mapping::PointCloudMap RobotSlam::points(const std::vector<geometry::Pose2>& trajectory) const {
  mapping::PointCloudMap points;
  for (const Ping& ping : pings_) {
    const geometry::Pose2& T_map_robot = trajectory[ping.instant];
    points.add({T_map_robot, T_map_robot * ping.T_robot_sonar, ping.range_m});
  }
  return points;
}

}  // namespace echomap::pipeline
