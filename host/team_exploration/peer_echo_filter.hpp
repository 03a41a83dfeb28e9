// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "host/pipeline/observation_sink.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// Values are ours, chosen in simulation.
struct PeerEchoParams {
  double beam_half_angle_rad = 0.2269;  ///< Of the sonar (robot profile).
  /// An echo is attributed to a hull within this distance, plus this many standard deviations of
  /// the peer's position.
  double near_m = 0.08;
  double stddevs = 2.0;
  /// A contact is attributed to a peer whose hull is this near to the robot's, plus as many
  /// standard deviations.
  double touch_m = 0.06;
  double robot_radius_m = 0.09;
};

/// Whether an echo at `range_m` may come from the hull of a peer: within the beam and at that
/// distance.
bool is_of_peer(const geometry::Pose2& T_map_sonar,
                double range_m,
                const Peer& peer,
                const PeerEchoParams& params);

/// Keeps other robots out of a map: forwards a robot's observations, but turns echoes of other
/// robots' hulls into readings without information, and removes contacts with them.
class PeerEchoFilter final : public pipeline::AnyObservationSink {
 public:
  /// Return the robot's pose on its map, and where the others were at a time.
  using OwnPose = std::function<geometry::Pose2()>;
  using PeersAt = std::function<std::vector<Peer>(time::RobotTime)>;

  /// `sink` outlives this. Throws std::invalid_argument for invalid parameters.
  PeerEchoFilter(pipeline::ObservationSink& sink,
                 const sensors::RobotGeometry& robot,
                 OwnPose T_map_robot,
                 PeersAt peers_at,
                 const PeerEchoParams& params);

  void on(const sensors::Observation& observation) override;

  /// Numbers of echoes and contacts that were attributed to other robots.
  std::size_t echoes_of_peers() const { return echoes_; }
  std::size_t contacts_with_peers() const { return contacts_; }

 private:
  sensors::SonarObservation filtered(sensors::SonarObservation observation);
  sensors::HazardObservation filtered(sensors::HazardObservation observation);

  pipeline::ObservationSink& sink_;
  sensors::RobotGeometry robot_;
  OwnPose T_map_robot_;
  PeersAt peers_at_;
  PeerEchoParams params_;
  std::size_t echoes_ = 0;
  std::size_t contacts_ = 0;
};

}  // namespace echomap::team_exploration
