// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_slam.hpp"

#include <utility>

namespace echomap::pipeline {

RobotSlam::RobotSlam(std::unique_ptr<slam::SlamMethod> method, double beam_width_rad)
    : method_(std::move(method)), track_(*method_), beam_width_rad_(beam_width_rad) {}

void RobotSlam::follow(const geometry::Pose2& T_odom_robot) {
  if (is_at_stop_) {
    held_T_odom_robots_.push_back(T_odom_robot);
  } else {
    track_.follow(T_odom_robot);
  }
}

void RobotSlam::add_ping(const geometry::Pose2& T_odom_robot,
                         const geometry::Pose2& T_robot_sonar,
                         const std::optional<double>& range_m) {
  const std::size_t instants = track_.instants() + held_T_odom_robots_.size();
  pings_.push_back({instants - 1, T_odom_robot, T_robot_sonar, range_m});
  if (is_at_stop_) {
    ++held_pings_;
  } else {
    count(pings_.back());
  }
}

void RobotSlam::end_stop(bool pings_count) {
  const std::size_t first = pings_.size() - std::exchange(held_pings_, 0);
  auto ping = pings_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto count_so_far = [&] {
    for (; pings_count && ping != pings_.end() && ping->instant < track_.instants(); ++ping) {
      count(*ping);
    }
  };
  count_so_far();  // Those whose stamps have not risen.
  for (const geometry::Pose2& T_odom_robot : std::exchange(held_T_odom_robots_, {})) {
    track_.follow(T_odom_robot);
    count_so_far();
  }
  if (pings_count) {
    stops_.push_back({first, pings_.size()});
  }
  is_at_stop_ = false;
}

void RobotSlam::count(const Ping& ping) {
  track_.add(ping.T_odom_robot,
             {{}, ping.T_robot_sonar, {{0.0, ping.range_m}}, beam_width_rad_, 0.0});
}

std::vector<mapping::Scan> RobotSlam::stops() const {
  std::vector<std::size_t> instants;
  for (const Stop& stop : stops_) {
    for (std::size_t i = stop.first; i < stop.last; ++i) {
      instants.push_back(pings_[i].instant);
    }
  }
  const std::vector<geometry::Pose2> T_map_odom = track_.T_map_odom_at(instants);
  auto correction = T_map_odom.begin();
  std::vector<mapping::Scan> scans;
  for (const Stop& stop : stops_) {
    scans.emplace_back();
    for (std::size_t i = stop.first; i < stop.last; ++i) {
      const geometry::Pose2 T_map_robot = *correction++ * pings_[i].T_odom_robot;
      scans.back().push_back(
          {T_map_robot, T_map_robot * pings_[i].T_robot_sonar, pings_[i].range_m});
    }
  }
  return scans;
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
