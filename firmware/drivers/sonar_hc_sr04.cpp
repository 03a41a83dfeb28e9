// SPDX-License-Identifier: MIT
#include "firmware/drivers/sonar_hc_sr04.hpp"

#include "firmware/hal/sonar.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace drivers {

bool SonarHcSr04::ready() { return !hal::echo_is_high(); }

void SonarHcSr04::ping(uint32_t now_us) {
  pinged_us_ = now_us;
  state_ = State::kTriggered;
  hal::trigger_sonar();
}

bool SonarHcSr04::poll(uint32_t now_us, uint16_t max_echo_us, uint16_t& flight_us) {
  const State state = state_;
  if (state == State::kIdle) {
    return false;
  }
  flight_us = protocol::kNoEcho;
  if (state == State::kAnswered) {
    const uint32_t flight = (fall_half_us_ - rise_half_us_ + 1) / 2;
    if (flight <= max_echo_us) {
      flight_us = static_cast<uint16_t>(flight);
    }
  } else {
    uint32_t pulse_us = max_echo_us;
    if (state == State::kTriggered) {
      pulse_us = 0;
      flight_us = protocol::kNoSonar;
    }
    if (now_us - pinged_us_ <= kRiseTimeoutUs + pulse_us) {
      return false;
    }
  }
  state_ = State::kIdle;
  return true;
}

void SonarHcSr04::on_echo_edge(bool high, uint32_t stamp_half_us) {
  if (high && state_ == State::kTriggered) {
    rise_half_us_ = stamp_half_us;
    state_ = State::kHigh;
  } else if (!high && state_ == State::kHigh) {
    fall_half_us_ = stamp_half_us;
    state_ = State::kAnswered;
  }
}

}  // namespace drivers
}  // namespace echomap
