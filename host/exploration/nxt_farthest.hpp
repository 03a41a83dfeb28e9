// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/explorer.hpp"
#include "host/exploration/round_sweep.hpp"

namespace echomap::exploration {

/// Values are those of Singh and Bedi 2013, section 3, where they give one; the others are ours,
/// chosen in simulation.
struct NxtFarthestParams {
  /// 720 degrees a stop, so that every bearing is read twice; the paper's motor pans all round.
  RoundSweepParams sweep{.scan_rad = 12.566370614359172};
  /// One of this many farthest readings is chosen at random.
  std::size_t candidates = 4;
  /// Readings less than this apart are one candidate: about a beam's width, as a wide beam reads
  /// the same thing many times. 0 takes the paper at its word.
  double candidate_spread_rad = 0.5236;
  /// A place nearer than this to one already read from is taken only where no other is left. 0
  /// takes the paper at its word, which keeps no memory, and may go to and fro for long.
  double stop_spacing_m = 0.5;
  /// Share of the way to the chosen echo that is driven.
  double drive_share = 0.5;
  /// From the middle of the axle to the farthest part of the hull (robot profile).
  double robot_radius_m = 0.09;
  /// Floor to be left between the hull and any echo: two to three sigma of the range noise.
  double clearance_m = 0.08;
  /// A shorter drive is not worth a stop.
  double min_drive_m = 0.10;
  /// Distance to back off after a bump.
  double back_off_m = 0.05;
  /// A scan of the room ends after this many stops at the latest.
  std::size_t max_stops = 20;
  /// A stop that shows less floor than this has shown no new ground.
  double new_ground_m2 = 0.10;
  /// A scan of the room ends after this many such stops in a row.
  std::size_t stops_without_new_ground = 2;
  /// So many scans of the room (section 5.1: "scan the room continuously till a highly detailed map
  /// is constructed"). Each behind the first makes as many stops as that has made, apart from each
  /// other, but not from those before.
  std::size_t scans = 1;
};

/// Strategy `nxt-farthest`, the exploration of Singh and Bedi 2013, section 3: read all around,
/// pick one of the farthest echoes at random, turn to it, go half the way, and again. Of earlier
/// stops it knows only where they were and whether the last ones showed new ground.
class NxtFarthest final : public Explorer {
 public:
  /// Keeps a reference to `random`. Throws std::invalid_argument for invalid parameters.
  NxtFarthest(const NxtFarthestParams& params, std::mt19937& random);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

 private:
  enum class Phase : std::uint8_t { kSensing, kMoving, kBackingOff };

  void note(MotionResult last);
  void plan_sensing(const pipeline::Snapshot& snapshot);
  void plan_moving(const pipeline::Snapshot& snapshot);
  std::optional<FinishReason> reason_to_finish(const pipeline::Snapshot& snapshot);
  /// Why the scan of the room that is under way has come to its end; empty where it has not.
  std::optional<FinishReason> end_of_scan(const pipeline::Snapshot& snapshot);
  std::optional<Eigen::Vector2d> choose_offset_m(const pipeline::Snapshot& snapshot);
  double drivable_m(const Eigen::Vector2d& offset_m, const pipeline::Snapshot& snapshot) const;

  NxtFarthestParams params_;
  std::mt19937& random_;
  Phase phase_ = Phase::kMoving;
  std::deque<Motion> plan_;
  std::size_t poor_stops_ = 0;
  std::size_t scans_done_ = 0;  ///< Of the room.
  std::size_t first_stop_ = 0;  ///< Of this scan of the room.
  std::size_t first_pose_ = 0;  ///< The same among the poses of the map.
  std::size_t stops_of_first_scan_ = 0;
  FinishReason end_of_first_scan_ = FinishReason::kNoNewGround;
  bool sweeping_ = false;        ///< The last motion was a sweep.
  std::size_t sweeps_done_ = 0;  ///< At this stop.
};

}  // namespace echomap::exploration
