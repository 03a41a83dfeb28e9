// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/exploration/corner_watch.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/hand.hpp"
#include "host/exploration/traversal_watch.hpp"
#include "host/exploration/wall_walk.hpp"

namespace echomap::exploration {

/// When the walk along the walls ends.
enum class TraversalRule : std::uint8_t {
  /// Back at the first contact with a full turn made, and then past a corner for a second time, so
  /// that the odometry's error shows; a round room has none.
  kBackAtFirstContact,
  /// When the angle covered about the start is a full turn: Mukherjee et al., section IV.
  kAngleAboutStart,
};

/// Values are those of Mukherjee et al., section IV, where they give one; the others are ours,
/// chosen in simulation.
struct CoastalParams {
  Hand hand = Hand::kRight;
  TraversalRule rule = TraversalRule::kBackAtFirstContact;
  /// "an experimentally optimum pause time (70 ms)".
  double tick_s = 0.07;
  /// "speed = 60", in the mm/s of the Create.
  double speed_m_per_s = 0.06;
  /// "deg = 25".
  double spin_rad = 0.4363323129985824;
  double spin_rad_per_s = 1.0;
  /// The right turn in search of the wall is an arc about a place so far to the right.
  double arc_radius_m = 0.20;
  /// From the middle of the axle to the hull (robot profile).
  double robot_radius_m = 0.165;
  /// Nearer to the wall the robot bears away from it: a hull that slides along a wall presses no
  /// bumper and leads the odometry astray. 0 takes the paper at its word.
  double min_gap_m = 0.01;
  /// The wall sensor's place and its index among the infra-red readings (robot profile).
  geometry::Pose2 T_robot_sensor{0.13, -0.10, -1.3089969389957472};
  std::size_t sensor_index = 0;
  /// d~ = a d + b of a tick's way, equations 4 and 5.
  localization::DistanceCorrection correction;
  CornerWatchParams corners;
  TraversalParams traversal;
  /// Behind the first contact the walk goes on past the first corner with so much of wall before it
  /// and so much behind it, but no farther than `max_overlap_m`: what is seen twice tells how far
  /// the odometry went astray.
  double wall_m = 0.5;
  double max_overlap_m = 4.0;
  /// Give up after so long a walk, or where more than so many walls were round something that
  /// stands in the room: the robot leaves it for another wall.
  double max_distance_m = 100.0;
  std::size_t max_islands = 5;
};

/// Strategy `coastal`, the wall following of Mukherjee et al., section IV.
class Coastal final : public Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit Coastal(const CoastalParams& params);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;
  StrategyProducts products() const override;

  /// Of the walk so far, seen as if the right hand were on the wall.
  const std::vector<WallStep>& steps() const { return walk_.steps(); }
  const std::vector<CornerMark>& corners() const { return corners_.marks(); }
  const TraversalWatch& traversal() const { return traversal_; }

 private:
  WallContact contact_of(const pipeline::Snapshot& snapshot) const;
  void begin_walk();
  Roll follow_wall(const WallContact& contact);
  std::optional<FinishReason> reason_to_finish(const WallContact& contact);
  bool is_round(const WallStep& step) const;
  /// The first corner with enough of a wall before it; null for none, as in a round room.
  const CornerMark* corner_behind_a_wall() const;
  /// That corner, felt again after a full round; null before.
  const CornerMark* passed_again(const CornerMark& known) const;

  CoastalParams params_;
  double min_range_m_;
  WallWalk walk_;
  CornerWatch corners_;
  TraversalWatch traversal_;
  bool found_ = false;
  std::size_t islands_ = 0;
};

}  // namespace echomap::exploration
