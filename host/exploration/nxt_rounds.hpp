// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "host/exploration/explorer.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::exploration {

/// Singh and Bedi 2013, section 4.5 and Algorithm 1.
struct NxtRoundsParams {
  std::size_t rounds = 10;
  double first_bearing_rad = geometry::radians(30.0);
  double bearing_step_rad = geometry::radians(45.0);
  double turn_rad = geometry::radians(20.0);
  double drive_m = 0.06;
  /// The sonar pans from minus this to plus this; the body turns for the rest.
  double pan_limit_rad = 3.141592653589793;
  double settle_s = 0.03;
};

/// The drive under which Singh and Bedi 2013 localize (Algorithm 1): eight readings 45 degrees
/// apart, 20 degrees to the left, 6 cm ahead, ten times.
class NxtRounds final : public Explorer {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit NxtRounds(const NxtRoundsParams& params);

  Motion next(const pipeline::Snapshot& snapshot, MotionResult last) override;

 private:
  void begin_round();

  NxtRoundsParams params_;
  std::size_t rounds_ = 0;
  std::deque<Motion> motions_;
};

/// The bearings of a round's readings from the robot, radians counter-clockwise from straight
/// ahead.
std::vector<double> round_bearings_rad(const NxtRoundsParams& params);

}  // namespace echomap::exploration
