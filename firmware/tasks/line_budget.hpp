// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace tasks {

/// Holds telemetry to 70 % of the line and answers that take telemetry's room to 25 %, so that
/// neither starves the other, and says by how much telemetry's periods have to be stretched to fit
/// in.
class LineBudget {
 public:
  /// Periods are never stretched by more than 2 to this power.
  static constexpr uint8_t kMaxRateStep = 5;
  /// What an idle line saves up for a burst.
  static constexpr uint8_t kMaxCreditBytes = 128;
  /// A step is taken back after this many windows in which twice as much would have fitted: 2 s.
  static constexpr uint8_t kQuietWindows = 8;

  /// Once a millisecond; windows are 256 ms long.
  void tick();
  /// Takes a telemetry frame's bytes; false when it has to wait.
  bool take(uint8_t bytes);
  /// Takes the bytes of an answer for which telemetry has to wait; false when there have been too
  /// many of them.
  bool take_answer(uint8_t bytes);
  /// Telemetry was lost because it had to wait too long: the next window begins with a step more.
  void overloaded() { overloaded_ = true; }

  /// Telemetry periods are to be multiplied by 2 to this power.
  uint8_t rate_step() const { return rate_step_; }

 private:
  void end_window(uint16_t share_bytes);
  /// The answers' share of this time, which is no longer than a window, pays for answers.
  void pay_answers(uint16_t ms);

  uint16_t credit_ = 0;    ///< 1/256 bytes.
  uint16_t answered_ = 0;  ///< 1/256 bytes of answers, less those that their share has paid for.
  uint16_t used_bytes_ = 0;
  uint8_t window_ms_ = 0;
  uint8_t paid_ms_ = 0;  ///< Of the window, for answers.
  uint8_t quiet_windows_ = 0;
  uint8_t rate_step_ = 0;
  bool overloaded_ = false;
};

}  // namespace tasks
}  // namespace echomap
