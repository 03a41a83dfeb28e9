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
  /// So many standard deviations of where the peer is are kept off as well.
  double stddevs = 1.0;
  /// What a robot still rolls when it has been told to stop: 0.25 m/s, braked by 0.6 m/s^2.
  double braking_m = 0.06;
  /// A peer that drives is expected on its way for so long after it told its pose.
  double ahead_s = 0.8;
};

/// Checks motions against other robots: where they are, and where they will be.
class PeerGuard {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit PeerGuard(const PeerGuardParams& params);

  /// How far this robot's middle keeps from the peer's, metres.
  double keep_off_m(const Peer& peer) const;
  /// The nearest peer that the motion would come too near to; null for none. A motion that leads
  /// away from a peer may always be made.
  const Peer* in_the_way(const exploration::Motion& motion,
                         const geometry::Pose2& T_map_robot,
                         const std::vector<Peer>& peers) const;
  /// Distance from a point to where a peer is and will be, metres.
  double distance_m(const Eigen::Vector2d& point_m, const Peer& peer) const;

 private:
  PeerGuardParams params_;
};

}  // namespace echomap::team_exploration
