// SPDX-License-Identifier: MIT
#include "firmware/control/scan_sweep.hpp"

#include "firmware/hal/clock.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace control {

using protocol::MotionOutcome;
namespace {

/// Where a pan looks, in (-18000, 18000].
int16_t direction(int32_t pan_cdeg) {
  constexpr int32_t kTurnCdeg = 36000;
  constexpr int32_t kOffsetCdeg = kTurnCdeg / 2 - 1;
  static_assert(protocol::kMaxPanCdeg % kTurnCdeg == 0, "whole turns leave the direction as it is");
  const uint32_t from_behind =
      static_cast<uint32_t>(pan_cdeg + protocol::kMaxPanCdeg + kOffsetCdeg) % kTurnCdeg;
  return static_cast<int16_t>(static_cast<int32_t>(from_behind) - kOffsetCdeg);
}

}  // namespace

bool ScanSweep::accepts(const protocol::ConfigureSonar& settings) {
  return settings.max_echo_us != 0 && settings.max_echo_us < protocol::kNoSonar;
}

bool ScanSweep::accepts(const protocol::StartSweep& sweep) const {
  if (!pan_.reaches(sweep.from_cdeg) || !pan_.reaches(sweep.to_cdeg)) {
    return false;
  }
  const int32_t way_cdeg = sweep.to_cdeg - sweep.from_cdeg;
  const bool leads_there =
      way_cdeg == 0 || (sweep.step_cdeg != 0 && (way_cdeg < 0) == (sweep.step_cdeg < 0));
  return leads_there && sweep.settle_ms <= protocol::kMaxSettleMs;
}

void ScanSweep::start(const protocol::StartSweep& sweep) {
  sweep_ = sweep;
  report_ = MotionReport{sweep.command_id, MotionOutcome::kRunning};
  turn_to(sweep.from_cdeg);
}

void ScanSweep::stop(MotionOutcome reason) {
  pan_.rest();
  state_ = State::kIdle;
  if (report_.outcome == MotionOutcome::kRunning) {
    report_.outcome = reason;
  }
}

bool ScanSweep::tick(protocol::Echo& echo) {
  if (since_ping_ms_ != UINT8_MAX) {
    ++since_ping_ms_;
  }
  if (sweeping() && ++silence_ms_ == protocol::kMaxSweepSilenceMs) {
    stop(MotionOutcome::kExpired);
  }
  if (state_ == State::kTurning && pan_.tick() && settling_ms_-- == 0) {
    state_ = State::kAiming;
  }
  if (state_ == State::kAiming && may_ping()) {
    ping();
  } else if (state_ == State::kListening &&
             sonar_.poll(hal::now_us(), settings_.max_echo_us, echo_.flight_us)) {
    echo = echo_;
    go_on();
    return true;
  }
  return false;
}

void ScanSweep::turn_to(int32_t pan_cdeg) {
  pan_cdeg_ = pan_cdeg;
  echo_.pan_cdeg = direction(pan_cdeg);
  pan_.turn_to(pan_cdeg);
  settling_ms_ = sweep_.settle_ms;
  stuck_ms_ = 0;
  state_ = State::kTurning;
}

bool ScanSweep::may_ping() {
  if (since_ping_ms_ < settings_.ping_gap_ms) {
    return false;
  }
  return drivers::Sonar::ready() || ++stuck_ms_ == kStuckMs;
}

void ScanSweep::ping() {
  const drivers::WheelCounts counts = encoders_.counts();
  echo_.stamp_us = hal::now_us();
  echo_.left_ticks = counts.left;
  echo_.right_ticks = counts.right;
  sonar_.ping(echo_.stamp_us);
  since_ping_ms_ = 0;
  state_ = State::kListening;
}

void ScanSweep::go_on() {
  const int32_t step_cdeg = sweep_.step_cdeg;
  const int32_t left_cdeg = sweep_.to_cdeg - pan_cdeg_;
  const bool over = step_cdeg > 0 ? left_cdeg < step_cdeg : left_cdeg > step_cdeg;
  if (over || left_cdeg == 0) {
    stop(MotionOutcome::kReached);
  } else {
    turn_to(pan_cdeg_ + step_cdeg);
  }
}

}  // namespace control
}  // namespace echomap
