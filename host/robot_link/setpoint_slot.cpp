// SPDX-License-Identifier: MIT
#include "host/robot_link/setpoint_slot.hpp"

#include <chrono>
#include <utility>

#include "protocol/limits.hpp"

namespace echomap::robot_link {
namespace {

/// As the robot reads it: 0 stands for the default.
std::chrono::milliseconds time_to_live(const protocol::DriveSetpoint& setpoint) {
  return std::chrono::milliseconds(setpoint.time_to_live_ms == 0 ? protocol::kDefaultTimeToLiveMs
                                                                 : setpoint.time_to_live_ms);
}

}  // namespace

void SetpointSlot::put(const protocol::DriveSetpoint& setpoint, time::HostTime now) {
  dropped_ += waiting_ ? 1 : 0;
  waiting_ = {setpoint, now};
}

void SetpointSlot::drop_expired(time::HostTime now) {
  if (waiting_ && now - waiting_->since > time_to_live(waiting_->setpoint)) {
    ++dropped_;
    waiting_.reset();
  }
}

std::optional<protocol::DriveSetpoint> SetpointSlot::take() {
  const auto waiting = std::exchange(waiting_, std::nullopt);
  return waiting ? std::optional(waiting->setpoint) : std::nullopt;
}

}  // namespace echomap::robot_link
