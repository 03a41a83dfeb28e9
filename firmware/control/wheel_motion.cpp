// SPDX-License-Identifier: MIT
#include "firmware/control/wheel_motion.hpp"

#include "firmware/control/fixed_point.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace control {
namespace {

using protocol::MotionOutcome;

/// With nobody at the wheel it takes 32 control periods, 0.128 s, from the fastest speed to rest,
/// whatever acceleration is set; at 0.45 m/s that is 3.5 m/s2, which a tyre still holds.
constexpr int32_t kBrakingPeriods = 32;

int32_t magnitude(int32_t value) { return value < 0 ? -value : value; }

bool in_range(int32_t ticks) {
  constexpr uint32_t kMax = protocol::kMaxMoveTicks;
  return static_cast<uint32_t>(ticks) + kMax <= 2 * kMax;
}

int32_t with_sign_of(int32_t sign, int32_t value) { return sign < 0 ? -value : value; }

bool has(uint8_t inversions, protocol::DriveInversions bit) { return (inversions & bit) != 0; }

}  // namespace

bool WheelMotion::accepts(const protocol::ConfigureDrive& settings) {
  using protocol::kMaxGain;
  return settings.max_ticks_per_s != 0 && settings.max_ticks_per_s <= protocol::kMaxTicksPerS &&
         settings.max_ticks_per_s2 != 0 && settings.feed_forward <= kMaxGain &&
         settings.proportional <= kMaxGain && settings.integral <= kMaxGain &&
         settings.odometry_period_ms != 0;
}

void WheelMotion::configure(const protocol::ConfigureDrive& settings) {
  settings_ = settings;
  left_.invert_motor(has(settings.inversions, protocol::kInvertLeftMotor));
  right_.invert_motor(has(settings.inversions, protocol::kInvertRightMotor));
  encoders_.invert(has(settings.inversions, protocol::kInvertLeftEncoder),
                   has(settings.inversions, protocol::kInvertRightEncoder));
}

bool WheelMotion::accepts(const protocol::ConfigureWiring& wiring) {
  return drivers::can_drive(wiring);
}

void WheelMotion::configure(const protocol::ConfigureWiring& wiring) {
  const bool brakes = (wiring.bridge_options & protocol::kBrakeAtZero) != 0;
  left_.brake_at_zero(brakes);
  right_.brake_at_zero(brakes);
  const uint8_t arrived_ticks = drivers::has_servos(wiring)
                                    ? WheelSpeedController::kServoArrivedTicks
                                    : WheelSpeedController::kArrivedTicks;
  left_.arrive_within(arrived_ticks);
  right_.arrive_within(arrived_ticks);
  drivers::use_bridges(wiring);
}

bool WheelMotion::accepts(const protocol::MoveTicks& move) const {
  return in_range(move.left_ticks) && in_range(move.right_ticks) && move.ticks_per_s != 0 &&
         move.ticks_per_s <= settings_.max_ticks_per_s;
}

void WheelMotion::start_move(const protocol::MoveTicks& move) {
  begin(Mode::kMove);
  report_ = MotionReport{move.command_id, MotionOutcome::kRunning};
  move_ticks_ = Steps{move.left_ticks, move.right_ticks};
  set_course(move.left_ticks, move.right_ticks);
  const int32_t left = magnitude(move.left_ticks);
  const int32_t right = magnitude(move.right_ticks);
  const int32_t longer = left > right ? left : right;
  const int32_t shorter = left > right ? right : left;
  shorter_.start(shorter, longer == 0 ? 1 : longer);
  way_.start(longer * kOneTick,
             per_period(static_cast<int16_t>(move.ticks_per_s)),
             change_per_period(settings_.max_ticks_per_s2));
}

void WheelMotion::drive(int16_t left_ticks_per_s, int16_t right_ticks_per_s) {
  if (setpoint_stalled() && (left_ticks_per_s | right_ticks_per_s) != 0) {
    return;
  }
  if (report_.outcome == MotionOutcome::kRunning) {
    report_.outcome = MotionOutcome::kStopped;
  }
  if (mode_ != Mode::kDrive || expired_) {
    take_over();
  }
  set_course(left_ticks_per_s, right_ticks_per_s);
  left_ramp_.set_target(clipped_target(left_ticks_per_s));
  right_ramp_.set_target(clipped_target(right_ticks_per_s));
}

/// From whatever moves now.
void WheelMotion::take_over() {
  if (report_.id == 0) {
    report_.outcome = MotionOutcome::kNone;
  }
  if (moving()) {
    mode_ = Mode::kDrive;
    expired_ = false;
  } else {
    begin(Mode::kDrive);
  }
  left_ramp_.start(last_steps_.left, change_per_period(settings_.max_ticks_per_s2));
  right_ramp_.start(last_steps_.right, change_per_period(settings_.max_ticks_per_s2));
}

void WheelMotion::stop(MotionOutcome reason) {
  if (mode_ == Mode::kDrive || setpoint_stalled()) {
    report_ = MotionReport{0, reason};
  }
  release();
  end(reason);
  if (reason == MotionOutcome::kLifted) {
    report_.outcome = reason;
  }
}

void WheelMotion::expire() {
  static_assert(per_period(2) == kBrakingPeriods, "the division becomes a shift");
  const int32_t change = int32_t{1} + settings_.max_ticks_per_s / 2;
  expired_ = moving();
  if (!expired_) {
    release();
  } else if (mode_ == Mode::kMove) {
    way_.brake(change);
    report_.outcome = MotionOutcome::kExpired;
  } else {
    report_ = MotionReport{0, MotionOutcome::kExpired};
    left_ramp_.brake(change);
    right_ramp_.brake(change);
  }
}

bool WheelMotion::step() {
  if (!moving()) {
    return true;
  }
  last_steps_ = next_steps();
  left_.prepare(settings_, last_steps_.left);
  right_.prepare(settings_, last_steps_.right);
  left_.follow(encoders_.left_count());  // A reading each: its duty comes right after it.
  right_.follow(encoders_.right_count());
  const MotionOutcome left_fault = left_.classify(settings_, limits_);
  const MotionOutcome right_fault = right_.classify(settings_, limits_);
  const MotionOutcome fault = left_fault > right_fault ? left_fault : right_fault;
  if (fault != MotionOutcome::kNone) {
    stop(fault);
  } else if (reference_stands() && expired_) {
    release();
    end(MotionOutcome::kReached);
  } else if (reference_stands() && left_.arrived() && right_.arrived()) {
    left_.rest();
    right_.rest();
    end(MotionOutcome::kReached);
  }
  return fault < MotionOutcome::kRunaway;
}

bool WheelMotion::setpoint_stalled() const {
  return report_.id == 0 && report_.outcome == MotionOutcome::kStalled;
}

bool WheelMotion::goes_forward() const {
  return told_forward_ || last_steps_.left + last_steps_.right > 0;
}

bool WheelMotion::only_backs_off() const {
  return told_to_back_off_ && last_steps_.left <= 0 && last_steps_.right <= 0;
}

void WheelMotion::set_course(int32_t left, int32_t right) {
  told_forward_ = left + right > 0;
  told_to_back_off_ = left <= 0 && right <= 0;
}

void WheelMotion::begin(Mode mode) {
  const drivers::WheelCounts counts = encoders_.counts();
  left_.begin(counts.left);
  right_.begin(counts.right);
  last_steps_ = Steps{0, 0};
  expired_ = false;
  mode_ = mode;
}

void WheelMotion::release() {
  left_.release();
  right_.release();
}

/// Of what moves, as far as reports go.
void WheelMotion::end(MotionOutcome outcome) {
  mode_ = Mode::kIdle;
  if (report_.outcome == MotionOutcome::kRunning) {
    report_.outcome = outcome;
  }
}

WheelMotion::Steps WheelMotion::next_steps() {
  if (mode_ == Mode::kDrive) {
    return Steps{left_ramp_.advance(), right_ramp_.advance()};
  }
  const int32_t longer = way_.advance();
  const int32_t shorter = shorter_.scale(longer);
  const bool left_is_longer = magnitude(move_ticks_.left) > magnitude(move_ticks_.right);
  return Steps{with_sign_of(move_ticks_.left, left_is_longer ? longer : shorter),
               with_sign_of(move_ticks_.right, left_is_longer ? shorter : longer)};
}

int32_t WheelMotion::clipped_target(int16_t ticks_per_s) const {
  const int16_t limit = static_cast<int16_t>(settings_.max_ticks_per_s);
  const int16_t upper = ticks_per_s > limit ? limit : ticks_per_s;
  return per_period(upper < -limit ? static_cast<int16_t>(-limit) : upper);
}

bool WheelMotion::reference_stands() const {
  return mode_ == Mode::kMove ? way_.finished() : left_ramp_.at_rest() && right_ramp_.at_rest();
}

}  // namespace control
}  // namespace echomap
