// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "host/exploration/explorer.hpp"
#include "host/exploration/navigator.hpp"
#include "host/exploration/round_sweep.hpp"

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
  /// Nearer to an earlier stop a place is worth less, in proportion.
  double new_view_m = 0.75;
  /// What any place is worth beside what it tells, which is 1 at most.
  double least_worth = 0.05;
  /// Time of a stop's sweeps, and the speed of the ways there, for their time.
  double stop_s = 15.0;
  double speed_m_per_s = 0.25;
  /// Give up after more motions that failed than this since the last stop.
  std::size_t max_failures = 8;
};

/// Goes from stop to stop to tell the places apart where the robot may be (active localization,
/// Fox, Burgard and Thrun 1998): of the places within reach to the one that tells most for the time
/// that it takes. A map that has a stop already it goes on with; it ends only where no place is
/// within reach.
class ActiveLocalization final : public Explorer {
 public:
  /// What a scan from a goal tells, seen from the robot, within [0, 1].
  using Telling = std::function<double(const geometry::Pose2& T_robot_goal)>;

  /// Throws std::invalid_argument for invalid parameters.
  explicit ActiveLocalization(const ActiveLocalizationParams& params);

  /// For the choices that follow; where nothing is told, all places tell as much.
  void prefer(Telling telling) { telling_ = std::move(telling); }

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

 private:
  enum class Phase : std::uint8_t { kStarting, kDriving, kSensing, kBackingOff };
  struct Place {
    Eigen::Vector2d at_m;
    double cost_m;
  };

  std::optional<Motion> recover(const pipeline::Snapshot& snapshot, MotionResult last);
  Motion decide(const pipeline::Snapshot& snapshot);
  std::optional<Place> choose_place(const pipeline::Snapshot& snapshot) const;
  double worth_per_s(const Place& place, const pipeline::Snapshot& snapshot) const;
  Motion drive_on(const pipeline::Snapshot& snapshot);
  void plan_sweep(const pipeline::Snapshot& snapshot);
  Motion take_planned();

  ActiveLocalizationParams params_;
  Navigator navigator_;
  Telling telling_;
  Phase phase_ = Phase::kStarting;
  std::deque<Motion> plan_;
  std::size_t failures_ = 0;     ///< Since the last stop.
  bool sweeping_ = false;        ///< The last motion was a sweep.
  std::size_t sweeps_done_ = 0;  ///< At this stop.
};

}  // namespace echomap::exploration
