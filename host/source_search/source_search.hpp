// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/exploration/explorer.hpp"
#include "host/exploration/frontier.hpp"
#include "host/exploration/navigator.hpp"
#include "host/exploration/scan_plan.hpp"
#include "host/exploration/view_gain.hpp"
#include "host/exploration/viewpoint_choice.hpp"
#include "host/source_search/dwell_choice.hpp"
#include "host/source_search/source_belief.hpp"

namespace echomap::source_search {

/// Values without another source are ours, chosen in simulation.
struct SourceSearchParams {
  /// How unknown floor is explored, and paths are driven.
  exploration::FrontierParams frontier;
  SourceBeliefParams belief;
  DwellChoiceParams choice;
  /// Whether unknown floor is explored, too; otherwise the map counts as complete.
  bool explores = true;
  /// How far floor is expected to continue behind the unknown cells that may hold the source, where
  /// nothing shows that it ends: about half a room.
  double beyond_m = 2.0;
  /// Value of a square metre of unknown floor that a look shows, in nats: about the share of a
  /// source's prior that lies on it.
  double nats_per_unknown_m2 = 0.03;
  /// Period at which the robot decides again, also while it drives.
  double rethink_s = 3.0;
  /// End after this many goals.
  std::size_t max_goals = 2000;
};

/// Strategy `source`: searches a source by what a scalar sensor reads, on a map that may be
/// unfinished, until it is found or there is certainly none. Where the map so far has none, it
/// first explores the rest as strategy `frontier` does. It drives where it expects most information
/// about the source for the time (after Ristic et al. 2010), counts on the way and waits to count
/// more, and where unknown floor promises more it looks there first. Readings of others count as
/// its own, and it does not plan readings that others are about to take.
class SourceSearch final : public exploration::Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SourceSearch(const SourceSearchParams& params);

  /// Sets all readings so far, of all robots, where this robot's map has them now. To be called
  /// before `next` whenever there are more, or the map has moved them.
  void set_readings(std::vector<FieldReading> readings);
  /// Sets what others are about to read, in this robot's map: their `plan()`.
  void set_plans_of_others(std::vector<PlannedDwell> plans) { others_ = std::move(plans); }
  /// Sets the other robots: paths lead round where they stand, and what they have claimed to look
  /// at is left to them while this robot explores the rest. What they have seen is in the
  /// snapshots.
  void set_company(const exploration::Company& company);
  /// Decides again with the next motion, as something is in the robot's way.
  void reconsider();
  bool is_driving() const {
    return explores_rest_ ? rest_.goal().has_value() : phase_ == Phase::kDriving;
  }
  /// Whether it has ended with a verdict.
  bool has_ended() const { return has_ended_; }
  /// What this robot is about to read; empty while there is no plan.
  const std::vector<PlannedDwell>& plan() const { return plan_readings_; }

  exploration::Motion next(const pipeline::Snapshot& snapshot,
                           exploration::MotionResult last) override;
  exploration::Intent intent() const override;

  /// What is known about the source; null before the first map.
  const SourceBelief* belief() const { return belief_ ? &*belief_ : nullptr; }

 private:
  enum class Phase : std::uint8_t { kStarting, kDriving, kDwelling, kSensing, kBackingOff };

  std::optional<exploration::Motion> recover(const pipeline::Snapshot& snapshot,
                                             exploration::MotionResult last);
  void update(const pipeline::Snapshot& snapshot);
  void set_map(const pipeline::Snapshot& snapshot);
  void set_ways(const pipeline::Snapshot& snapshot);
  void take_readings();
  SourceFloor floor_of(const pipeline::Snapshot& snapshot) const;
  exploration::ViewGain view_gain(const pipeline::Snapshot& snapshot) const;
  bool has_become_sure();
  bool has_to_see_more(const pipeline::Snapshot& snapshot) const;
  std::optional<exploration::Viewpoint> choose_confirmation(
      const pipeline::Snapshot& snapshot) const;
  std::optional<double> choose_goal(const pipeline::Snapshot& snapshot,
                                    const std::optional<exploration::Viewpoint>& look);
  exploration::Motion explore_rest(const pipeline::Snapshot& snapshot,
                                   exploration::MotionResult last);
  exploration::Motion end_rest(const pipeline::Snapshot& snapshot);
  bool has_to_think(const pipeline::Snapshot& snapshot) const;
  exploration::Motion decide(const pipeline::Snapshot& snapshot);
  std::optional<exploration::Viewpoint> choose_look(const pipeline::Snapshot& snapshot) const;
  exploration::Motion drive_on(const pipeline::Snapshot& snapshot);
  exploration::Motion begin_sweep(const pipeline::Snapshot& snapshot);

  SourceSearchParams params_;
  exploration::Navigator navigator_;
  DwellChoice choice_;
  Phase phase_ = Phase::kStarting;
  exploration::ScanPlan scan_;
  std::optional<mapping::RasterMap> map_;
  std::optional<DwellLattice> lattice_;
  std::optional<SourceBelief> belief_;
  std::optional<std::size_t> stops_of_map_;
  std::vector<FieldReading> readings_;
  std::size_t known_readings_ = 0;  ///< Of those, in the belief.
  bool are_readings_moved_ = false;
  std::vector<PlannedDwell> others_;
  std::vector<PlannedDwell> plan_readings_;
  std::optional<Eigen::Vector2d> goal_m_;
  double goal_dwell_s_ = 0.0;
  bool is_look_ = false;  ///< The goal is to look from, not to count at.
  time::RobotTime thought_at_;
  std::size_t goals_ = 0;
  exploration::Frontier rest_;
  bool explores_rest_ = false;
  bool is_explored_ = false;  ///< Nothing is left to look at.
  bool has_ended_ = false;
};

}  // namespace echomap::source_search
