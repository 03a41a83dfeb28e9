// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hil_mock/runner/simulated_board.hpp"
#include "hil_mock/world/motor_driver.hpp"

namespace echomap::tests {

/// Watches, write for write, for how long a board's pins have a motor driven. Takes the board's
/// hook `on_duty`.
class DriveTrace {
 public:
  /// A driven motor does not move in less: pins of two ports cannot change at once.
  static constexpr std::int64_t kGlitchNs = 1'000;

  /// Both outlive the trace; it begins with what the pins are now.
  DriveTrace(runner::SimulatedBoard& board, world::MotorDriver driver);
  ~DriveTrace() { board_.on_duty = nullptr; }
  DriveTrace(const DriveTrace&) = delete;
  DriveTrace& operator=(const DriveTrace&) = delete;

  /// Longest time that a motor has been driven without a pause since the last call, or is now.
  std::int64_t take_longest_ns();

 private:
  static constexpr std::int64_t kNotDriven = -1;

  void note();

  runner::SimulatedBoard& board_;
  world::MotorDriver driver_;
  std::array<std::int64_t, 2> since_ns_{kNotDriven, kNotDriven};
  std::int64_t longest_ns_ = 0;
};

}  // namespace echomap::tests
