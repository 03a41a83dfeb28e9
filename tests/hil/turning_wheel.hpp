// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::tests {

/// How unevenly an encoder's edges come: each is displaced by a uniform random part of its period,
/// up to `share` of it to either side. Below 0.5 none passes another.
struct EdgeJitter {
  double share = 0.0;
  std::uint32_t seed = 1;
};

/// A wheel's encoder: makes the quadrature edges of a motion and knows the true count.
class TurningWheel {
 public:
  TurningWheel(runner::SimulatedBoard& board, runner::Wheel wheel, EdgeJitter jitter = {})
      : board_(board), wheel_(wheel), jitter_(jitter), random_(jitter.seed) {}

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
      const double at_ns =
          share * static_cast<double>(for_ns) + displacement_ns(std::abs(ticks_per_s));
      edge(start_ns + std::clamp(static_cast<std::int64_t>(at_ns), std::int64_t{0}, for_ns));
    }
  }

  std::int64_t count() const { return count_; }

 private:
  double displacement_ns(double ticks_per_s) {
    if (jitter_.share == 0.0) {
      return 0.0;
    }
    constexpr double kMaxRandom = std::mt19937::max();
    return jitter_.share * 1e9 / ticks_per_s * (2.0 * double(random_()) / kMaxRandom - 1.0);
  }

  void edge(std::int64_t at_ns) {
    const auto phase = static_cast<unsigned>(count_) & 3U;  // A leads B forwards
    board_.schedule_encoder_edge(wheel_, at_ns, phase == 1 || phase == 2, phase >= 2);
  }

  runner::SimulatedBoard& board_;
  runner::Wheel wheel_;
  EdgeJitter jitter_;
  std::mt19937 random_;
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
