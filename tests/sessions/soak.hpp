// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::tests {

/// What hours of driving, sweeping and line faults have shown.
struct SoakResult {
  double hours = 0.0;          ///< Of simulated time.
  std::uint64_t rounds = 0;    ///< A move, a sweep, set-points and rests.
  std::uint64_t cuts = 0;      ///< Rounds in which the line was dead for a while.
  std::uint64_t expired = 0;   ///< Moves that the robot ended since it heard nothing.
  std::uint64_t failures = 0;  ///< Motions that did not end as they had to.
  std::uint64_t edges = 0;     ///< Of both wheels.
  std::uint64_t echoes = 0;
  std::int64_t worst_drift_ticks = 0;  ///< Between a wheel's count and the host's, both at rest.
  double worst_echo_error_us = 0.0;
  double worst_lateness_us = 0.0;     ///< Of an odometry stamp, against its period from the first.
  double worst_clock_error_us = 0.0;  ///< Of the host's clock for the robot, at rests.
  std::uint64_t frames_lost = 0;      ///< On their way to the host.
  std::uint64_t resets = 0;
  std::uint32_t encoder_errors = 0;
  std::uint32_t receive_overruns = 0;
  std::uint16_t min_stack_bytes = UINT16_MAX;
  double grown_mb = 0.0;  ///< Memory of this program since a tenth of the time.

  /// Nothing has happened that never must; lost frames must, for the line loses them.
  bool holds() const;
};

/// Lets the host's link and a board work for so many simulated hours, over a line that harms one
/// byte in 20,000, loses one frame in 500 and is dead for up to 3 s in every twentieth round.
/// `progress` is told after every tenth.
SoakResult soak(std::unique_ptr<runner::SimulatedBoard> board,
                double hours,
                std::uint32_t seed,
                const std::function<void(const SoakResult&)>& progress = {});

}  // namespace echomap::tests
