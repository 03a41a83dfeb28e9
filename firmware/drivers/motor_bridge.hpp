// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/hal/motors.hpp"
#include "protocol/command_messages.hpp"

namespace echomap {
namespace drivers {

/// Largest duty either way.
constexpr int16_t kFullDuty = 255;

/// True when this board can drive bridges of this wiring, and they have these options.
bool can_drive(const protocol::ConfigureWiring& wiring);
/// True where the wheels turn on servos.
inline bool has_servos(const protocol::ConfigureWiring& wiring) {
  return wiring.bridge == static_cast<uint8_t>(protocol::MotorBridgeKind::kServo);
}
/// The spare pins, a bit each, that these bridges take; of wiring that `can_drive` has granted.
uint16_t pins_of_bridges(const protocol::ConfigureWiring& wiring);
/// Switches both motors off, and drives such bridges from here on.
void use_bridges(const protocol::ConfigureWiring& wiring);

/// One motor behind its bridge. A reversal spends one call without current, so that the old duty
/// never drives the new direction.
class MotorBridge {
 public:
  constexpr explicit MotorBridge(hal::Motor motor) : motor_(motor) {}

  /// Swaps the motor's directions; switches it off.
  void invert(bool inverted);
  /// Whether a duty of 0 brakes; switches the motor off.
  void brake_at_zero(bool brakes);
  /// Duty -255 .. 255, forward positive.
  void set(int16_t duty);
  /// No current, and no brake.
  void release();

 private:
  hal::Motor motor_;
  bool inverted_ = false;
  bool brakes_ = false;
  bool pin_forward_ = true;
  bool running_ = false;
};

}  // namespace drivers
}  // namespace echomap
