// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hil_mock/line_faults/delay_model.hpp"

namespace echomap::line_faults {

/// The host's clock must hold from here on; microseconds of a session.
constexpr std::int64_t kLockedAfterUs = 5'000'000;

/// Errors of stamps at the moment when they arrive.
struct ClockErrors {
  std::vector<double> all_us;
  std::vector<double> first_second_us;  ///< Of the second after `kLockedAfterUs`.
  std::size_t covered = 0;

  void note(std::int64_t now_us, double error_us, double uncertainty_us) {
    all_us.push_back(error_us);
    covered += error_us <= uncertainty_us ? 1 : 0;
    if (now_us < kLockedAfterUs + 1'000'000) {
      first_second_us.push_back(error_us);
    }
  }
};

/// The value below which so much of `values` lies.
double quantile(std::vector<double> values, double share);

/// host/time/clock_sync over a line: odometry at 50 Hz and pings as RobotLink sends them, `seeds`
/// sessions up to `end_us`. The shortest delays of both directions are equal; half of what they
/// differ by on a real line comes on top.
ClockErrors measure_clock(const LineDelays& line,
                          double rate_error_ppm,
                          std::uint32_t seeds = 6,
                          std::int64_t end_us = 900'000'000);

}  // namespace echomap::line_faults
