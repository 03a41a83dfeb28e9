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
  /// A sonar's echo is of a hull where it lies so near to it, and so many standard deviations of
  /// where the peer is.
  double near_m = 0.08;
  double stddevs = 2.0;
  /// A contact is a peer's where its hull is so near to this robot's, and so many standard
  /// deviations.
  double touch_m = 0.06;
  double robot_radius_m = 0.09;
};

/// Whether an echo at `range_m` may come from the hull of a peer: in the beam, and as far off.
bool is_of_peer(const geometry::Pose2& T_map_sonar,
                double range_m,
                const Peer& peer,
                const PeerEchoParams& params);

/// Keeps other robots out of a map: hands on what a robot senses, but for echoes of other robots'
/// hulls, which become readings that say nothing, and contacts with them, which become none.
class PeerEchoFilter final : public pipeline::AnyObservationSink {
 public:
  /// Where the robot is by its map, and where the others were at a time.
  using OwnPose = std::function<geometry::Pose2()>;
  using PeersAt = std::function<std::vector<Peer>(time::RobotTime)>;

  /// `sink` outlives this. Throws std::invalid_argument for invalid parameters.
  PeerEchoFilter(pipeline::ObservationSink& sink,
                 const sensors::RobotGeometry& robot,
                 OwnPose T_map_robot,
                 PeersAt peers_at,
                 const PeerEchoParams& params);

  void on(const sensors::Observation& observation) override;

  /// Echoes and contacts that were of other robots.
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
