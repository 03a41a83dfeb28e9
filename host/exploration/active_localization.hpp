// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "host/exploration/explorer.hpp"
#include "host/exploration/navigator.hpp"
#include "host/exploration/round_sweep.hpp"
#include "host/exploration/scan_plan.hpp"

namespace echomap::exploration {

/// Values without another source are ours, chosen in simulation.
struct ActiveLocalizationParams {
  NavigatorParams navigator;
  /// 720 degrees a stop, so that every bearing is read twice.
  RoundSweepParams sweep{.scan_rad = 12.566370614359172};
  /// Places that are tried lie so far apart, and are those nearest to the robot, so many in all.
  double lattice_m = 0.25;
  std::size_t max_places = 200;
  /// A shorter way is not worth a stop.
  double min_drive_m = 0.1;
  /// Nearer to an earlier stop a place has less utility, in proportion.
  double new_view_m = 0.75;
  /// That of any place, added to its own, which is 1 at most.
  double min_utility = 0.05;
  /// Time of a stop's sweeps, and the speed of the ways there, for their time.
  double stop_s = 15.0;
  double speed_m_per_s = 0.25;
};

/// Goes from stop to stop to tell the places apart where the robot may be (active localization,
/// Fox, Burgard and Thrun 1998): of the places within reach to the one of the most utility for the
/// time that it takes. A map that has a stop already it goes on with; it ends only where no place
/// is within reach.
class ActiveLocalization final : public Explorer {
 public:
  /// How much a scan from a goal, seen from the robot, helps to tell the places apart where it may
  /// be, within [0, 1]; where it is 0 for all, any goal does.
  using GoalUtility = std::function<double(const geometry::Pose2& T_robot_goal)>;

  /// Throws std::invalid_argument for invalid parameters.
  ActiveLocalization(const ActiveLocalizationParams& params, GoalUtility utility);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;
  Intent intent() const override;

 private:
  enum class Phase : std::uint8_t { kStarting, kDriving, kSensing, kBackingOff };
  struct Place {
    Eigen::Vector2d at_m;
    double cost_m;
  };

  std::optional<Motion> recover(const pipeline::Snapshot& snapshot, MotionResult last);
  Motion decide(const pipeline::Snapshot& snapshot);
  std::optional<Place> choose_place(const pipeline::Snapshot& snapshot) const;
  double utility_per_s(const Place& place, const pipeline::Snapshot& snapshot) const;
  Motion drive_on(const pipeline::Snapshot& snapshot);
  Motion begin_sweep(const pipeline::Snapshot& snapshot);

  ActiveLocalizationParams params_;
  Navigator navigator_;
  GoalUtility utility_;
  Phase phase_ = Phase::kStarting;
  ScanPlan plan_;
  WeighedPlace goal_;  ///< While it drives.
};

}  // namespace echomap::exploration
