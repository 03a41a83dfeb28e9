// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/path_follower.hpp"
#include "host/exploration/round_sweep.hpp"
#include "host/exploration/scan_plan.hpp"

namespace echomap::exploration {

/// A place of a tour, in the map frame: the robot's start pose is the origin.
struct TourPlace {
  std::string name;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  bool sweeps = true;  ///< The robot stops there and reads all round; otherwise it passes through.
};

/// Values without another source are ours, chosen in simulation.
struct StopTourParams {
  CostGridParams costs;
  PathFollowerParams follower;
  /// All round once, in steps of 4 degrees, as a sweep of `frontier`.
  RoundSweepParams sweep{6.283185307179586, 0.06981317007977318, 1.5707963267948966, 0.03};
  /// Distance to back off after a bump.
  double back_off_m = 0.1;
};

/// Strategy `stops`: drives to the places of a list, in order and straight from one to the next by
/// the estimated pose, and reads all round at each. A place that it does not get to is missed, and
/// it drives on to the next one.
class StopTour final : public Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters and without a place.
  StopTour(const StopTourParams& params, std::vector<TourPlace> places);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

  /// How many places there are, and how many were reached.
  StrategyProducts products() const override;

 private:
  enum class Phase : std::uint8_t { kSettingOff, kDriving, kSensing };

  std::optional<Motion> recover(const pipeline::Snapshot& snapshot, MotionResult last);
  Motion drive_on(const pipeline::Snapshot& snapshot);
  void set_off(const pipeline::Snapshot& snapshot);
  void leave_place(bool was_reached);

  StopTourParams params_;
  std::vector<TourPlace> places_;
  PathFollower follower_;
  std::optional<CostGrid> costs_;
  Phase phase_ = Phase::kSettingOff;
  ScanPlan plan_;
  std::size_t current_ = 0;  ///< The place that it is heading for.
  std::size_t reached_ = 0;
  std::size_t motions_left_ = 0;  ///< That the way to the place may still take.
};

}  // namespace echomap::exploration
