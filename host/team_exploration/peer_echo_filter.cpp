// SPDX-License-Identifier: MIT
#include "host/team_exploration/peer_echo_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::team_exploration {

using geometry::Pose2;

bool is_of_peer(const Pose2& T_map_sonar,
                double range_m,
                const Peer& peer,
                const PeerEchoParams& params) {
  const Eigen::Vector2d peer_m = T_map_sonar.inverse() * peer.T_map_robot.position_m();
  const double distance_m = peer_m.norm();
  const double slack_m = params.near_m + params.stddevs * peer.position_stddev_m;
  if (std::abs(range_m - (distance_m - peer.radius_m)) > slack_m) {
    return false;
  }
  const double off_axis_rad = std::abs(std::atan2(peer_m.y(), peer_m.x()));
  const double half_width_rad =
      std::asin(std::min(1.0, (peer.radius_m + slack_m) / std::max(distance_m, 1e-6)));
  return off_axis_rad <= params.beam_half_angle_rad + half_width_rad;
}

PeerEchoFilter::PeerEchoFilter(pipeline::ObservationSink& sink,
                               const sensors::RobotGeometry& robot,
                               OwnPose T_map_robot,
                               PeersAt peers_at,
                               const PeerEchoParams& params)
    : sink_(sink),
      robot_(robot),
      T_map_robot_(std::move(T_map_robot)),
      peers_at_(std::move(peers_at)),
      params_(params) {
  geometry::ParameterValidator("peer echo filter")
      .within("beam_half_angle_rad", params.beam_half_angle_rad, 0.0, 1.5)
      .at_least("near_m", params.near_m, 0.0)
      .at_least("stddevs", params.stddevs, 0.0)
      .at_least("touch_m", params.touch_m, 0.0)
      .positive("robot_radius_m", params.robot_radius_m);
}

void PeerEchoFilter::on(const sensors::Observation& observation) {
  if (const auto* sonar = std::get_if<sensors::SonarObservation>(&observation)) {
    sink_.on_sonar(filtered(*sonar));
  } else if (const auto* hazards = std::get_if<sensors::HazardObservation>(&observation)) {
    sink_.on_hazards(filtered(*hazards));
  } else {
    pipeline::hand_on(observation, sink_);
  }
}

/// What lies behind the peer is unknown: the reading becomes one without information.
sensors::SonarObservation PeerEchoFilter::filtered(sensors::SonarObservation observation) {
  if (!observation.range_m) {
    return observation;
  }
  const Pose2 T_map_sonar = T_map_robot_() * robot_.T_robot_sonar(observation.pan_rad);
  const auto peers = peers_at_(observation.stamp);
  const bool is_peer = std::any_of(peers.begin(), peers.end(), [&](const Peer& peer) {
    return is_of_peer(T_map_sonar, *observation.range_m, peer, params_);
  });
  if (is_peer) {
    ++echoes_;
    observation.range_m.reset();
    observation.has_answered = false;
  }
  return observation;
}

sensors::HazardObservation PeerEchoFilter::filtered(sensors::HazardObservation observation) {
  if (!observation.is_touching()) {
    return observation;
  }
  const Eigen::Vector2d here_m = T_map_robot_().position_m();
  const auto peers = peers_at_(observation.stamp);
  const bool is_peer = std::any_of(peers.begin(), peers.end(), [&](const Peer& peer) {
    const double apart_m = (peer.T_map_robot.position_m() - here_m).norm();
    return apart_m <= params_.robot_radius_m + peer.radius_m + params_.touch_m +
                          params_.stddevs * peer.position_stddev_m;
  });
  if (is_peer) {
    ++contacts_;
    observation.bump_left = false;
    observation.bump_right = false;
  }
  return observation;
}

}  // namespace echomap::team_exploration
