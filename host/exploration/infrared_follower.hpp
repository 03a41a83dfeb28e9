// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

/// For the ring of Mahmood and Ridao 2017, section 4: a beam sees 6 cm far and only what it meets
/// almost at right angles. Values are ours, chosen in simulation.
struct InfraredFollowerParams {
  /// "constant linear and angular velocity".
  double speed_m_per_s = 0.05;
  double spin_rad_per_s = 1.0;
  double tick_s = 0.05;
  /// From the sensor beside the wall to the wall.
  double distance_m = 0.018;
  /// The robot turns away from what is nearer: ahead, and to the right of ahead.
  double ahead_m = 0.020;
  double oblique_m = 0.024;
  /// On its way across a field it has met a wall that is so near beside it.
  double graze_m = 0.020;
  /// Towards the wall, for each metre too far and each metre a second away from it.
  double turn_per_m = 30.0;
  double turn_per_m_per_s = 40.0;
  double max_turn_rad_per_s = 1.0;
  double robot_radius_m = 0.037;
  /// The infra-red sensors, in the order of their readings (robot profile).
  std::vector<geometry::Pose2> T_robot_sensor;
};

/// One round of infra-red readings; empty where nothing is in reach.
using InfraredRanges = std::span<const std::optional<double>>;

/// Goes along a wall on the right by a ring of infra-red sensors of short reach.
class InfraredFollower {
 public:
  /// Throws std::invalid_argument for invalid parameters, and where no sensor looks ahead or none
  /// to the right.
  explicit InfraredFollower(const InfraredFollowerParams& params);

  /// Something is too near in front.
  bool is_blocked(InfraredRanges ranges_m) const;
  /// Something is very near on that side.
  bool grazes_right(InfraredRanges ranges_m) const;
  bool grazes_left(InfraredRanges ranges_m) const;
  /// Away to the left.
  Roll spin() const { return {0.0, params_.spin_rad_per_s, params_.tick_s}; }
  /// What the sensor beside the wall reads.
  std::optional<double> beside_m(InfraredRanges ranges_m) const;
  /// The next piece of way along the wall, given a reading each tick.
  Roll follow(InfraredRanges ranges_m);
  /// A new wall: what was read before counts no more.
  void forget() { last_m_.reset(); }

 private:
  double nearest_m(InfraredRanges ranges_m, const std::vector<std::size_t>& sensors) const;

  InfraredFollowerParams params_;
  std::vector<std::size_t> ahead_;
  std::vector<std::size_t> oblique_;
  std::vector<std::size_t> left_;
  std::size_t beside_ = 0;
  std::optional<double> last_m_;
};

}  // namespace echomap::exploration
