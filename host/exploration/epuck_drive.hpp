// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "host/exploration/covered_ground.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/infrared_follower.hpp"
#include "host/exploration/traversal_watch.hpp"
#include "host/exploration/wall_walk.hpp"

namespace echomap::exploration {

/// Ours: Mahmood and Ridao 2017 only say that the robot "was made to move beside the obstacles in
/// the free space around the field" and covered all of it.
struct EpuckDriveParams {
  InfraredFollowerParams follower;
  TraversalParams traversal{0.03, 0.005, 0.7};
  /// The ring sees all walls so near to the middle of the robot.
  double reach_m = 0.07;
  double cell_m = 0.02;
  /// So near to a way along a known wall the robot is at that wall again.
  double known_wall_m = 0.025;
  /// On its way round an unknown wall it has come to a known one after so much way along that.
  double astray_m = 0.3;
  /// So near to where it should leave a wall it leaves it.
  double leave_m = 0.025;
  /// Turn towards the goal for each radian that it is off; a robot farther off turns on the spot.
  double turn_per_rad = 2.0;
  double max_off_rad = 0.35;
  /// A goal that so many walls came before is given up.
  std::size_t max_walls = 4;
  /// Give up after so long.
  double max_s = 1800.0;
};

/// Strategy `epuck`, the drive of Mahmood and Ridao 2017, section 4: along the walls of the field
/// and round its obstacles, then across to what was not within reach of the infra-red sensors yet,
/// until nothing is left. Known walls on the way are followed to where they are nearest to the goal
/// (the Bug1 of Lumelsky and Stepanov 1987).
class EpuckDrive final : public Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit EpuckDrive(const EpuckDriveParams& params);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

  const CoveredGround& ground() const { return ground_; }

 private:
  enum class Phase : std::uint8_t { kFirstWall, kRound, kAlong, kAcross };

  void look(InfraredRanges ranges_m);
  void look_for_wall(InfraredRanges ranges_m);
  void meet_wall();
  void come_round();
  bool is_at_known_wall() const;
  /// False where nothing is left.
  bool choose_goal();
  double off_goal_rad() const;
  bool turns_on_the_spot() const;
  Roll go_to_goal() const;

  EpuckDriveParams params_;
  InfraredFollower follower_;
  CoveredGround ground_;
  WallWalk walk_{{}};
  TraversalWatch traversal_;
  Phase phase_ = Phase::kFirstWall;
  bool faces_left_ = false;  ///< It turns to a wall that it has met on its left.
  std::optional<Eigen::Vector2d> goal_m_;
  Eigen::Vector2d leave_at_m_ = Eigen::Vector2d::Zero();
  std::size_t walls_met_ = 0;     ///< On the way to the goal.
  double unknown_until_m_ = 0.0;  ///< The way along the wall to where it last was an unknown one.
  std::optional<time::RobotTime> begin_;
};

}  // namespace echomap::exploration
