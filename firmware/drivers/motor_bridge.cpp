// SPDX-License-Identifier: MIT
#include "firmware/drivers/motor_bridge.hpp"

namespace echomap {
namespace drivers {
namespace {

using hal::BridgeKind;
using protocol::MotorBridgeKind;

constexpr bool is_same(BridgeKind of_board, MotorBridgeKind on_wire) {
  return static_cast<uint8_t>(of_board) == static_cast<uint8_t>(on_wire);
}
static_assert(is_same(BridgeKind::kPhaseEnable, MotorBridgeKind::kPhaseEnable) &&
                  is_same(BridgeKind::kIn1In2Pwm, MotorBridgeKind::kIn1In2Pwm) &&
                  is_same(BridgeKind::kTwoPwm, MotorBridgeKind::kTwoPwm) &&
                  is_same(BridgeKind::kServo, MotorBridgeKind::kServo),
              "the kinds are numbered on the wire as on the board");

BridgeKind kind_of(const protocol::ConfigureWiring& wiring) {
  return static_cast<BridgeKind>(wiring.bridge);
}

/// What happens at duty 0 is up to a phase/enable bridge, and servos have no PWM.
uint8_t options_of(BridgeKind kind) {
  constexpr uint8_t kAll = protocol::kBrakeAtZero | protocol::kSlowPwm;
  if (kind == BridgeKind::kPhaseEnable) {
    return protocol::kSlowPwm;
  }
  return kind == BridgeKind::kServo ? uint8_t{protocol::kBrakeAtZero} : kAll;
}

}  // namespace

bool can_drive(const protocol::ConfigureWiring& wiring) {
  const BridgeKind kind = kind_of(wiring);
  return kind <= BridgeKind::kServo && hal::can_bridge(kind) &&
         (wiring.bridge_options | options_of(kind)) == options_of(kind);
}

uint16_t pins_of_bridges(const protocol::ConfigureWiring& wiring) {
  return hal::bridge_aux_pins(kind_of(wiring));
}

void use_bridges(const protocol::ConfigureWiring& wiring) {
  hal::use_bridge(kind_of(wiring), (wiring.bridge_options & protocol::kSlowPwm) != 0);
}

void MotorBridge::invert(bool inverted) {
  release();
  inverted_ = inverted;
}

void MotorBridge::brake_at_zero(bool brakes) {
  release();
  brakes_ = brakes;
}

void MotorBridge::set(int16_t duty) {
  const bool forward = (duty > 0) != inverted_;
  const bool reversing = running_ && duty != 0 && forward != pin_forward_;
  running_ = duty != 0 && !reversing;
  if (!running_) {
    hal::stop_motor(motor_, brakes_ && !reversing);
    return;
  }
  pin_forward_ = forward;
  hal::set_motor(motor_, forward, static_cast<uint8_t>(duty < 0 ? -duty : duty));
}

void MotorBridge::release() {
  running_ = false;
  hal::stop_motor(motor_, false);
}

}  // namespace drivers
}  // namespace echomap
