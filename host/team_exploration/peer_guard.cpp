// SPDX-License-Identifier: MIT
#include "host/team_exploration/peer_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::team_exploration {
namespace {

using geometry::Pose2;

/// Where the middle of the robot comes, in steps, until it has stopped behind the motion.
std::vector<Eigen::Vector2d> places_of(const exploration::Motion& motion,
                                       const Pose2& T_map_robot,
                                       double braking_m) {
  constexpr int kSteps = 4;
  double distance_m = 0.0;
  double turn_rad = 0.0;
  if (const auto* drive = std::get_if<exploration::Drive>(&motion)) {
    distance_m = drive->distance_m;
  } else if (const auto* roll = std::get_if<exploration::Roll>(&motion)) {
    distance_m = roll->forward_m_per_s * roll->for_s;
    turn_rad = roll->turn_rad_per_s * roll->for_s;
  }
  std::vector<Eigen::Vector2d> places_m;
  if (distance_m == 0.0) {
    return places_m;
  }
  Pose2 T_map_there = T_map_robot;
  for (int i = 0; i < kSteps; ++i) {
    T_map_there = T_map_there * Pose2(distance_m / kSteps, 0.0, turn_rad / kSteps);
    places_m.push_back(T_map_there.position_m());
  }
  const Eigen::Vector2d stop_m(std::copysign(braking_m, distance_m), 0.0);
  places_m.emplace_back(T_map_there * stop_m);
  return places_m;
}

}  // namespace

PeerGuard::PeerGuard(const PeerGuardParams& params) : params_(params) {
  geometry::ParameterValidator("peer guard")
      .positive("robot_radius_m", params.robot_radius_m)
      .at_least("margin_m", params.margin_m, 0.0)
      .at_least("stddevs", params.stddevs, 0.0)
      .at_least("braking_m", params.braking_m, 0.0)
      .at_least("ahead_s", params.ahead_s, 0.0);
}

double PeerGuard::keep_off_m(const Peer& peer) const {
  return params_.robot_radius_m + peer.radius_m + params_.margin_m +
         params_.stddevs * peer.position_stddev_m;
}

double PeerGuard::distance_m(const Eigen::Vector2d& point_m, const Peer& peer) const {
  const Eigen::Vector2d at_m = peer.T_map_robot.position_m();
  const double ahead_m = peer.speed_m_per_s * (peer.age_s + params_.ahead_s);
  const Eigen::Vector2d ahead = ahead_m * geometry::unit_vector(peer.T_map_robot.heading_rad());
  const geometry::Segment way{at_m, at_m + ahead};
  return (geometry::nearest_point(way, point_m) - point_m).norm();
}

const Peer* PeerGuard::in_the_way(const exploration::Motion& motion,
                                  const Pose2& T_map_robot,
                                  const std::vector<Peer>& peers) const {
  constexpr double kAwayM = 1e-4;
  const auto places_m = places_of(motion, T_map_robot, params_.braking_m);
  const Peer* nearest = nullptr;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Peer& peer : peers) {
    const double now_m = distance_m(T_map_robot.position_m(), peer);
    for (const Eigen::Vector2d& place_m : places_m) {
      const double then_m = distance_m(place_m, peer);
      if (then_m < keep_off_m(peer) && then_m < now_m + kAwayM && then_m < nearest_m) {
        nearest = &peer;
        nearest_m = then_m;
      }
    }
  }
  return nearest;
}

}  // namespace echomap::team_exploration
