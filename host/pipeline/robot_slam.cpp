// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_slam.hpp"

#include <utility>

namespace echomap::pipeline {

RobotSlam::RobotSlam(std::unique_ptr<slam::SlamMethod> method, double beam_opening_rad)
    : method_(std::move(method)), track_(*method_), beam_opening_rad_(beam_opening_rad) {}

void RobotSlam::follow(const geometry::Pose2& T_odom_robot) {
  if (is_at_stop_) {
    held_T_odom_robots_.push_back(T_odom_robot);
  } else {
    track_.follow(T_odom_robot);
  }
}

void RobotSlam::hear(const geometry::Pose2& T_odom_robot,
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
  const std::size_t middle = track_.instants() + held_T_odom_robots_.size() / 2;
  auto ping = pings_.end() - static_cast<std::ptrdiff_t>(std::exchange(held_pings_, 0));
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
    stops_.push_back(middle);
  }
  is_at_stop_ = false;
}

void RobotSlam::count(const Ping& ping) {
  track_.add(ping.T_odom_robot,
             {ping.T_robot_sonar, {{0.0, ping.range_m}}, beam_opening_rad_, 0.0});
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
