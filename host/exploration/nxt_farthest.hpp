// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>

#include <Eigen/Core>

#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

/// Values are those of Singh and Bedi 2013, section 3, where they give one; the others are ours,
/// chosen in simulation.
struct NxtFarthestParams {
  /// Pan range read per stop: 720 degrees, so that every bearing is read twice.
  double scan_rad = 12.566370614359172;
  /// Angle between two readings: 6 degrees.
  double step_rad = 0.10471975511965977;
  /// The sonar pans from minus this to plus this: 90 degrees for a hobby servo, 360 for the
  /// paper's motor. What it lacks to all round is made up for by turns of the body.
  double pan_limit_rad = 1.5707963267948966;
  /// Wait after each step of the pan, until the servo stands and old echoes have died away.
  double settle_s = 0.03;
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
  double least_drive_m = 0.10;
  /// How far to back off from what was bumped into.
  double back_off_m = 0.05;
  /// End after this many stops.
  std::size_t most_stops = 20;
  /// A stop that shows less floor than this has shown no new ground.
  double new_ground_m2 = 0.10;
  /// End after this many such stops in a row.
  std::size_t stops_without_new_ground = 2;
};

/// Strategy `nxt-farthest`, the exploration of Singh and Bedi 2013, section 3: read all around,
/// pick one of the farthest echoes at random, turn to it, go half the way, and again. Knows nothing
/// of earlier stops but whether the last ones showed new ground.
class NxtFarthest final : public Explorer {
 public:
  /// Keeps a reference to `random`. Throws std::invalid_argument for parameters without sense.
  NxtFarthest(const NxtFarthestParams& params, std::mt19937& random);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

 private:
  enum class Phase : std::uint8_t { kSensing, kMoving, kBackingOff };

  void note(MotionResult last);
  void plan_sensing(const pipeline::Snapshot& snapshot);
  void plan_moving(const pipeline::Snapshot& snapshot);
  std::optional<FinishReason> reason_to_finish(const pipeline::Snapshot& snapshot);
  std::optional<Eigen::Vector2d> choose_way_m(const pipeline::Snapshot& snapshot);
  double drivable_m(const Eigen::Vector2d& way_m, const pipeline::Snapshot& snapshot) const;

  NxtFarthestParams params_;
  std::mt19937& random_;
  Phase phase_ = Phase::kMoving;
  std::deque<Motion> plan_;
  std::size_t poor_stops_ = 0;
  bool sweeping_ = false;        ///< The last motion was a sweep.
  std::size_t sweeps_done_ = 0;  ///< At this stop.
};

}  // namespace echomap::exploration
