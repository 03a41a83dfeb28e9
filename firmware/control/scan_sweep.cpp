// SPDX-License-Identifier: MIT
#include "firmware/control/scan_sweep.hpp"

#include "firmware/hal/clock.hpp"
#include "firmware/hal/servo.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace control {

using protocol::MotionOutcome;
namespace {

/// Where a pan looks, in (-18000, 18000].
int16_t direction(int32_t pan_cdeg) {
  constexpr int32_t kTurnCdeg = 36000;
  while (pan_cdeg > kTurnCdeg / 2) {
    pan_cdeg -= kTurnCdeg;
  }
  while (pan_cdeg <= -kTurnCdeg / 2) {
    pan_cdeg += kTurnCdeg;
  }
  return static_cast<int16_t>(pan_cdeg);
}

}  // namespace

bool ScanSweep::accepts(const protocol::ConfigureSonar& settings) {
  return settings.max_echo_us != 0 && settings.max_echo_us < protocol::kNoEcho;
}

bool ScanSweep::accepts(const protocol::StartSweep& sweep) const {
  const bool leads_there = sweep.from_cdeg == sweep.to_cdeg ||
                           (sweep.step_cdeg > 0 && sweep.from_cdeg < sweep.to_cdeg) ||
                           (sweep.step_cdeg < 0 && sweep.from_cdeg > sweep.to_cdeg);
  return leads_there && servo_.reaches(sweep.from_cdeg) && servo_.reaches(sweep.to_cdeg) &&
         sweep.settle_ms <= protocol::kMaxSettleMs;
}

void ScanSweep::start(const protocol::StartSweep& sweep) {
  sweep_ = sweep;
  report_ = MotionReport{sweep.command_id, MotionOutcome::kRunning};
  turn_to(sweep.from_cdeg);
}

void ScanSweep::stop(MotionOutcome reason) {
  if (state_ == State::kTurning) {
    servo_.lose_track();
  }
  state_ = State::kIdle;
  if (report_.outcome == MotionOutcome::kRunning) {
    report_.outcome = reason;
  }
}

bool ScanSweep::tick(protocol::Echo& echo) {
  if (since_ping_ms_ != UINT8_MAX) {
    ++since_ping_ms_;
  }
  if (state_ == State::kTurning && --turning_ms_ == 0) {
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
  const uint32_t wait_ms =
      uint32_t{servo_.turn_to(pan_cdeg)} + sweep_.settle_ms + hal::kServoFrameMs;
  turning_ms_ = wait_ms > UINT16_MAX ? UINT16_MAX : static_cast<uint16_t>(wait_ms);
  stuck_ms_ = 0;
  state_ = State::kTurning;
}

bool ScanSweep::may_ping() {
  if (since_ping_ms_ < settings_.ping_gap_ms) {
    return false;
  }
  return drivers::SonarHcSr04::ready() || ++stuck_ms_ == kStuckMs;
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
  const int32_t next = pan_cdeg_ + sweep_.step_cdeg;
  const bool over = sweep_.step_cdeg > 0 ? next > sweep_.to_cdeg : next < sweep_.to_cdeg;
  if (over || sweep_.from_cdeg == sweep_.to_cdeg) {
    stop(MotionOutcome::kReached);
  } else {
    turn_to(next);
  }
}

}  // namespace control
}  // namespace echomap
