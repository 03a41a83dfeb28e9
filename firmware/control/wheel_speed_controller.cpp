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

/// Ticks/s of a wheel that has turned by so many in the periods over which speed is taken.
int32_t speed_of(int16_t turned_sum) {
  return (int32_t{turned_sum} * kControlHz) >> WheelSpeedController::kSpeedPeriodsLog2;
}

int32_t magnitude(int32_t value) { return value < 0 ? -value : value; }

}  // namespace

void WheelSpeedController::arrive_within(uint8_t ticks) { arrived_ = int32_t{ticks} * kOneTick; }

void WheelSpeedController::reset() {
  const int32_t arrived = arrived_;
  *this = WheelSpeedController();
  arrived_ = arrived;
}

void WheelSpeedController::prepare(const protocol::ConfigureDrive& gains, int32_t reference_step) {
  measure();
  lag_ += reference_step;
  reference_moves_ = reference_step != 0;
  push_off();
  const int16_t reference = ticks_per_second(reference_step);
  const int16_t expected_sum =
      static_cast<int16_t>(turned_sum_ + newest_turned_ - turned_[oldest_]);
  const int32_t expected_lag = lag_ - int32_t{newest_turned_} * kOneTick;
  prepared_drive_ = term(gains.feed_forward, reference) +
                    term(gains.proportional, reference - speed_of(expected_sum)) +
                    term(gains.integral, rounded_shift(expected_lag, 12)) + push_;
  const int32_t per_tick = speed_of(1) * gains.proportional + gains.integral;
  drive_per_tick_ = static_cast<int16_t>(clamped(per_tick, INT16_MAX));
}

int16_t WheelSpeedController::update(int16_t turned) {
  const int16_t unexpected = static_cast<int16_t>(turned - newest_turned_);
  newest_turned_ = turned;
  lag_ -= int32_t{turned} * kOneTick;
  if (!reference_moves_ && near()) {
    push_ = 0;
    return 0;  // Without friction, control would hunt round the last tick for ever.
  }
  const int32_t drive = prepared_drive_ - int32_t{unexpected} * drive_per_tick_;
  return static_cast<int16_t>(rounded_shift(clamped(drive, kFullDrive), 8));
}

bool WheelSpeedController::arrived() const { return still_periods_ == kStillPeriods && near(); }

bool WheelSpeedController::near() const { return magnitude(lag_) <= arrived_; }

bool WheelSpeedController::stalled(const protocol::ConfigureDrive& limits) const {
  constexpr int32_t kMinBoundTicks = 64;
  const int32_t bound_ticks = kMinBoundTicks + limits.max_ticks_per_s / 4;
  return magnitude(lag_) > bound_ticks * kOneTick || magnitude(push_) >= kFullDrive;
}

void WheelSpeedController::measure() {
  turned_sum_ = static_cast<int16_t>(turned_sum_ + newest_turned_ - turned_[oldest_]);
  turned_[oldest_] = newest_turned_;
  oldest_ = static_cast<uint8_t>((oldest_ + 1) & (kSpeedPeriods - 1));
  if (newest_turned_ != 0) {
    still_periods_ = 0;
  } else if (still_periods_ != kStillPeriods) {
    ++still_periods_;
  }
}

void WheelSpeedController::push_off() {
  const bool behind = lag_ > 0;
  if (reference_moves_ || (push_ > 0) != behind) {
    push_ = 0;
  }
  if (!reference_moves_ && turned_sum_ == 0 && !near()) {
    push_ += behind ? kPushStep : -kPushStep;
  }
}

}  // namespace control
}  // namespace echomap
