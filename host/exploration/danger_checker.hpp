// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <random>

#include <Eigen/Core>

#include "host/exploration/explorer.hpp"
#include "host/exploration/return_path.hpp"
#include "host/exploration/same_view.hpp"

namespace echomap::exploration {

/// When a robot is in danger; ours unless a profile says so.
struct DangerCheckerParams {
  /// From the middle of the axle to the farthest part of the hull (robot profile).
  double robot_radius_m = 0.09;
  /// Whether drives are shortened at all: not where a strategy has a check of the way of its own,
  /// which knows more or less than the map does.
  bool shortens_drives = true;
  /// A straight drive ends with so much floor between hull and what the map holds occupied.
  double min_clearance_m = 0.02;
  /// A drive that this leaves shorter is not begun.
  double min_drive_m = 0.02;
  /// After so many motions that were stopped short, and none that got it on by `moved_m`, the robot
  /// is stuck.
  std::size_t max_failures = 20;
  /// After so many drives of `moved_m` or more after which it heard what it had heard before, too:
  /// the wheels turn and the world does not.
  std::size_t max_same_views = 2;
  double moved_m = 0.2;
  SameViewParams same_view;
  /// The battery's voltage, the mean over some reports, below which the robot goes back to where it
  /// started, and below which it stops where it is; empty without a battery that is measured.
  std::optional<double> return_below_v;
  std::optional<double> stop_below_v;
  CostGridParams costs;
  PathFollowerParams follower;
};

/// Watches over any strategy: shortens drives that would end in what the map holds occupied, and
/// ends the exploration where the robot is stuck, off the floor, or short of power, for which it
/// first leads it home (after the danger checker of Hennessey et al., section II.A).
class DangerChecker final : public Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  DangerChecker(std::unique_ptr<Explorer> strategy, const DangerCheckerParams& params);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;
  StrategyProducts products() const override { return strategy_->products(); }
  Intent intent() const override { return strategy_->intent(); }

 private:
  void note(const pipeline::Snapshot& snapshot, MotionResult last);
  void compare_views(const pipeline::Snapshot& snapshot);
  std::optional<FinishReason> danger(const pipeline::Snapshot& snapshot) const;
  Motion ask_strategy(const pipeline::Snapshot& snapshot, MotionResult last);
  double clear_distance_m(const pipeline::Snapshot& snapshot) const;

  std::unique_ptr<Explorer> strategy_;
  DangerCheckerParams params_;
  std::optional<ReturnPath> way_home_;  ///< While the robot goes home.
  std::optional<double> battery_v_;     ///< Smoothed.
  std::optional<time::RobotTime> battery_stamp_;
  std::size_t failures_ = 0;  ///< Since it got on.
  Eigen::Vector2d got_to_m_ = Eigen::Vector2d::Zero();
  std::size_t same_views_ = 0;  ///< Consecutive count.
  std::size_t stops_ = 0;
  Eigen::Vector2d last_stop_m_ = Eigen::Vector2d::Zero();
  std::shared_ptr<const mapping::Scan> last_scan_;
};

}  // namespace echomap::exploration
