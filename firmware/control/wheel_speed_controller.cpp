// SPDX-License-Identifier: MIT
#include "firmware/control/wheel_speed_controller.hpp"

#include "firmware/control/fixed_point.hpp"
#include "firmware/drivers/motor_bridge.hpp"

namespace echomap {
namespace control {
namespace {

/// Gains and their products are in duty x 256.
constexpr int32_t kFullDrive = int32_t{drivers::kFullDuty} * 256;
/// Growth of the push against static friction, per period: full duty in a second.
constexpr int32_t kPushStep = 256;
constexpr int32_t kArrived = int32_t{WheelSpeedController::kArrivedTicks} * kOneTick;

int32_t clamped(int32_t value, int32_t limit) {
  if (value > limit) {
    return limit;
  }
  return value < -limit ? -limit : value;
}

/// Shifts stand for divisions, which take avr-gcc 40 us each. The lag's 4096 for 4000 is 2 % less
/// of a gain that was tuned, not calculated.
int32_t rounded_shift(int32_t value, uint8_t bits) {
  return (value + (int32_t{1} << (bits - 1))) >> bits;
}

/// A term may be four times the full drive, so that terms can cancel and their sum cannot overflow.
int32_t term(uint16_t gain, int32_t value) {
  const int16_t bounded = static_cast<int16_t>(clamped(value, INT16_MAX));
  return clamped(int32_t{static_cast<int16_t>(gain)} * bounded, 4 * kFullDrive);
}

int32_t magnitude(int32_t value) { return value < 0 ? -value : value; }

}  // namespace

void WheelSpeedController::reset() { *this = WheelSpeedController(); }

int16_t WheelSpeedController::update(const protocol::ConfigureDrive& gains,
                                     int32_t reference_step,
                                     int16_t turned) {
  lag_ += reference_step - int32_t{turned} * kOneTick;
  measure(turned);
  const bool reference_moves = reference_step != 0;
  if (!reference_moves && near()) {
    push_ = 0;
    return 0;  // Without friction, control would hunt round the last tick for ever.
  }
  push_off(reference_moves);
  const int32_t speed = (int32_t{turned_sum_} * kControlHz) >> kSpeedPeriodsLog2;
  const int32_t reference = ticks_per_second(reference_step);
  const int32_t drive = term(gains.feed_forward, reference) +
                        term(gains.proportional, reference - speed) +
                        term(gains.integral, rounded_shift(lag_, 12)) + push_;
  return static_cast<int16_t>(rounded_shift(clamped(drive, kFullDrive), 8));
}

bool WheelSpeedController::arrived() const { return still_periods_ == kStillPeriods && near(); }

bool WheelSpeedController::near() const { return magnitude(lag_) <= kArrived; }

bool WheelSpeedController::stalled(const protocol::ConfigureDrive& limits) const {
  constexpr int32_t kLeastBoundTicks = 64;
  const int32_t bound_ticks = kLeastBoundTicks + limits.max_ticks_per_s / 4;
  return magnitude(lag_) > bound_ticks * kOneTick || magnitude(push_) >= kFullDrive;
}

void WheelSpeedController::measure(int16_t turned) {
  turned_sum_ = static_cast<int16_t>(turned_sum_ + turned - turned_[oldest_]);
  turned_[oldest_] = turned;
  oldest_ = static_cast<uint8_t>((oldest_ + 1) & (kSpeedPeriods - 1));
  if (turned != 0) {
    still_periods_ = 0;
  } else if (still_periods_ != kStillPeriods) {
    ++still_periods_;
  }
}

void WheelSpeedController::push_off(bool reference_moves) {
  const bool behind = lag_ > 0;
  if (reference_moves || (push_ > 0) != behind) {
    push_ = 0;
  }
  if (!reference_moves && turned_sum_ == 0) {
    push_ += behind ? kPushStep : -kPushStep;
  }
}

}  // namespace control
}  // namespace echomap
