// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::tests {

/// A wheel's encoder: makes the quadrature edges of a motion and knows the true count.
class TurningWheel {
 public:
  TurningWheel(runner::SimulatedBoard& board, runner::Wheel wheel) : board_(board), wheel_(wheel) {}

  /// Turns at `ticks_per_s` (four edges a period, forward positive) for the next `for_ns`.
  void turn(double ticks_per_s, std::int64_t for_ns) {
    const std::int64_t start_ns = board_.now_ns();
    const double before = position_ticks_;
    position_ticks_ += ticks_per_s * static_cast<double>(for_ns) * 1e-9;
    const auto target = static_cast<std::int64_t>(std::floor(position_ticks_));
    while (count_ != target) {
      const bool forward = target > count_;
      const double crossed_ticks = static_cast<double>(forward ? count_ + 1 : count_);
      const double share = (crossed_ticks - before) / (position_ticks_ - before);
      count_ += forward ? 1 : -1;
      const auto at_ns = static_cast<std::int64_t>(share * static_cast<double>(for_ns));
      edge(start_ns + at_ns);
    }
  }

  std::int64_t count() const { return count_; }

 private:
  void edge(std::int64_t at_ns) {
    const auto phase = static_cast<unsigned>(count_) & 3U;  // A leads B forwards
    board_.schedule_encoder_edge(wheel_, at_ns, phase == 1 || phase == 2, phase >= 2);
  }

  runner::SimulatedBoard& board_;
  runner::Wheel wheel_;
  double position_ticks_ = 0.0;
  std::int64_t count_ = 0;
};

/// A wheel with its motor: first-order speed towards duty times the no-load speed. Without duty its
/// gear holds it once it is slow, so that no edge comes out of an endless coasting.
class DrivenWheel {
 public:
  DrivenWheel(runner::SimulatedBoard& board,
              runner::Wheel wheel,
              world::MotorDriver driver = world::MotorDriver())
      : board_(board), wheel_(wheel), driver_(driver), turning_(board, wheel) {}

  /// One millisecond of motion from the duty that the board now gives.
  void step_ms() {
    constexpr double kNoLoadTicksPerS = 3300.0;
    constexpr double kTimeConstantMs = 80.0;
    constexpr double kHeldTicksPerS = 1.0;
    const runner::MotorDuty duty = board_.motor_duty(driver_);
    const double wanted =
        kNoLoadTicksPerS * (wheel_ == runner::Wheel::kLeft ? duty.left : duty.right);
    ticks_per_s_ += (wanted - ticks_per_s_) / kTimeConstantMs;
    if (wanted == 0.0 && std::abs(ticks_per_s_) < kHeldTicksPerS) {
      ticks_per_s_ = 0.0;
    }
    turning_.turn(ticks_per_s_, 1'000'000);
  }

  std::int64_t count() const { return turning_.count(); }
  double ticks_per_s() const { return ticks_per_s_; }

 private:
  runner::SimulatedBoard& board_;
  runner::Wheel wheel_;
  world::MotorDriver driver_;
  TurningWheel turning_;
  double ticks_per_s_ = 0.0;
};

}  // namespace echomap::tests
