// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/exploration/explorer.hpp"
#include "host/geometry/pose2.hpp"
#include "host/team_exploration/team_view.hpp"

namespace echomap::team_exploration {

/// Values are ours, chosen in simulation.
struct PeerGuardParams {
  /// From the middle of the axle to the farthest part of the hull (robot profile).
  double robot_radius_m = 0.09;
  /// Floor to be left between two hulls.
  double margin_m = 0.06;
  /// Additional distance, in standard deviations of the peer's position.
  double stddevs = 1.0;
  /// Braking distance: 0.25 m/s, braked by 0.6 m/s^2.
  double braking_m = 0.06;
  /// Time after its last published pose for which a peer that drives is expected to continue.
  double ahead_s = 0.8;
};

/// Checks motions against other robots: where they are, and where they will be.
class PeerGuard {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit PeerGuard(const PeerGuardParams& params);

  /// Distance to keep between this robot's middle and the peer's, metres.
  double keep_off_m(const Peer& peer) const;
  /// The nearest peer that the motion would come too near to; null for none. A motion that leads
  /// away from a peer is always allowed.
  const Peer* in_the_way(const exploration::Motion& motion,
                         const geometry::Pose2& T_map_robot,
                         const std::vector<Peer>& peers) const;
  /// Distance from a point to where a peer is and will be, metres.
  double distance_m(const Eigen::Vector2d& point_m, const Peer& peer) const;

 private:
  PeerGuardParams params_;
};

}  // namespace echomap::team_exploration
