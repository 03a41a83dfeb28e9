// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/active_loop_closing.hpp"
#include "host/exploration/company.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/navigator.hpp"
#include "host/exploration/opening_search.hpp"
#include "host/exploration/possible_doors.hpp"
#include "host/exploration/round_sweep.hpp"
#include "host/exploration/scan_plan.hpp"
#include "host/exploration/view_gain.hpp"
#include "host/exploration/viewpoint_choice.hpp"

namespace echomap::exploration {

/// Values without another source are ours, chosen in simulation.
struct FrontierParams {
  NavigatorParams navigator;
  ViewGainParams gain;
  ViewpointParams viewpoints;
  OpeningParams openings;
  PossibleDoorParams doors;
  ActiveLoopClosingParams loops;
  /// All round once, in steps of 4 degrees: a beam of 26 degrees then hears a wall seven times. A
  /// sweep of a sector is as dense.
  RoundSweepParams sweep{6.283185307179586, 0.06981317007977318, 1.5707963267948966, 0.03};
  /// Where no look promises viewpoints.min_gain_m2 and no opening is left, looks that promise less
  /// count as long as the map has less than this share of what the robot can reach.
  double enough_share = 0.97;
  /// They have to promise at least so much, however much is missing: a door promises little.
  double fine_gain_m2 = 0.03;
  /// An opening so near to one that was chosen before, or to a bump, is the same one.
  double openings_apart_m = 0.3;
  /// One that the robot was stopped on the way to is chosen so often.
  std::size_t opening_tries = 3;
  /// End after this many stops.
  std::size_t max_stops = 40;
  /// A look that somebody else has promised is left to them, unless this robot has one within
  /// `contest_m` of it that promises so many times as much for its time.
  double contest_m = 0.8;
  double outbid = 1.2;
};

/// Strategy `frontier`, ours: goes to where a sweep shows most unknown floor for the time that it
/// takes, and where no reachable place promises more, steps into what openings are left and looks
/// at walls that may be doors. The room is complete without any of these (after Yamauchi 1997 and
/// Gonzalez-Banos and Latombe 2002).
class Frontier final : public Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit Frontier(const FrontierParams& params);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;
  Intent intent() const override;

  /// What others know and do from now on: it decides by what all have seen, leaves to others what
  /// they have promised to look at, and goes round them.
  void set_company(Company company);
  /// Where it is about to look; empty while it is not on the way.
  std::optional<Viewpoint> goal() const;
  /// Decides again at the next call, where it is on the way to a goal or has finished.
  void reconsider();

 private:
  enum class Phase : std::uint8_t { kStarting, kDriving, kSensing, kBackingOff, kDeciding };
  /// An opening that the robot was on the way to.
  struct TriedOpening {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    std::size_t bumps = 0;  ///< On the way there.
    bool is_reached = false;
  };

  std::optional<Motion> recover(const pipeline::Snapshot& snapshot, MotionResult last);
  std::optional<FinishReason> reason_to_finish(const pipeline::Snapshot& snapshot);
  std::optional<Viewpoint> choose_goal(const mapping::RasterMap& map,
                                       const pipeline::Snapshot& known,
                                       const pipeline::Snapshot& own);
  Motion decide(const pipeline::Snapshot& snapshot);
  std::optional<Viewpoint> choose_look(const mapping::RasterMap& map,
                                       const pipeline::Snapshot& snapshot,
                                       double min_gain_m2);
  std::vector<Viewpoint> weigh(const mapping::RasterMap& map,
                               const pipeline::Snapshot& snapshot,
                               const ViewGain& gain,
                               double min_gain_m2) const;
  void end_try_of_door();
  bool is_beside_goal(const geometry::Pose2& T_map_robot) const;
  bool is_left_to_others(const Eigen::Vector2d& opening_m) const;
  bool has_enough(const pipeline::Snapshot& snapshot) const;
  std::optional<Viewpoint> choose_door(const mapping::RasterMap& map,
                                       const pipeline::Snapshot& snapshot);
  std::optional<Viewpoint> choose_opening(const mapping::RasterMap& map,
                                          const pipeline::Snapshot& snapshot);
  TriedOpening& opening_at(const Eigen::Vector2d& opening_m);
  bool was_tried(const Eigen::Vector2d& opening_m, const mapping::RasterMap& map) const;
  Motion drive_on(const pipeline::Snapshot& snapshot);
  Motion begin_sweep(const pipeline::Snapshot& snapshot, const BestView& view);
  std::deque<Motion> sector_sweep(double heading_rad, const BestView& view) const;

  FrontierParams params_;
  Company company_;
  Navigator navigator_;
  Phase phase_ = Phase::kStarting;
  ActiveLoopClosing loops_;
  ScanPlan plan_;
  std::optional<Viewpoint> goal_;
  IntentKind goal_kind_ = IntentKind::kSweep;
  std::vector<WeighedPlace> weighed_;  ///< With the goal.
  std::vector<TriedOpening> openings_;
  /// Where it has looked, and heard what contradicts the map: another place tells whether it is
  /// lost, the same one would say the same again.
  std::vector<Eigen::Vector2d> refused_m_;
  std::optional<Eigen::Vector2d> door_m_;  ///< That it drives to, to look at it.
  std::vector<Eigen::Vector2d> tried_doors_m_;
};

}  // namespace echomap::exploration
