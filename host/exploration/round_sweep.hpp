// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>

#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

/// How a robot reads all round it.
struct RoundSweepParams {
  /// Pan range read: whole full turns, so that every bearing is read as often.
  double scan_rad = 6.283185307179586;
  /// Angle between two readings: 6 degrees.
  double step_rad = 0.10471975511965977;
  /// The sonar pans from minus this to plus this; what it lacks to all round is made up for by
  /// turns of the body.
  double pan_limit_rad = 1.5707963267948966;
  /// Wait after each step of the pan, until it stands and old echoes have died away.
  double settle_s = 0.03;
};

/// Whether an angle is a whole turn or more, up to what is lost in rounding.
bool is_full_turn(double angle_rad);

/// Whether a robot can do that.
bool is_possible(const RoundSweepParams& params);

/// BeginScan, the sweeps and EndScan. Each sector is swept to and fro until all rounds are read;
/// where the pan does not go all the way round, the body turns from sector to sector: clockwise
/// where `turned_left`.
std::deque<Motion> round_sweep(const RoundSweepParams& params, bool turned_left);

/// The sweep of a robot whose map has so many stops. At the first one a step is a quarter: that
/// stop's heading is the map's own, and where a wall begins to answer is known to half a step. And
/// where the body turns, it goes on all round to the first sector, which is swept again: what is
/// heard there twice tells how far the body turns where odometry says once round.
std::deque<Motion> stop_sweep(RoundSweepParams params, std::size_t stops, bool turned_left);

}  // namespace echomap::exploration
