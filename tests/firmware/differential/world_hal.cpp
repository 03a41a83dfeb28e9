// SPDX-License-Identifier: MIT
/// The hardware layer of every target of the differential test: the world's, the same on all.
#include "firmware/hal/adc.hpp"
#include "firmware/hal/aux_pins.hpp"
#include "firmware/hal/boot.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/encoders.hpp"
#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/motors.hpp"
#include "firmware/hal/range_sensor.hpp"
#include "firmware/hal/servo.hpp"
#include "firmware/hal/sonar.hpp"
#include "firmware/hal/stack.hpp"
#include "firmware/hal/uart.hpp"
#include "firmware/hal/watchdog.hpp"
#include "firmware/hal/yaw_gyro.hpp"
#include "tests/firmware/differential/world.hpp"

namespace echomap {
namespace hal {

using differential::Output;
using differential::world;

uint32_t now_us() { return world.now_us(); }

// Nothing interrupts.
uint8_t lock_interrupts() { return 0; }
void restore_interrupts(uint8_t /*state*/) {}
void start_watchdog() {}
void kick_watchdog() {}

uint8_t reset_cause() { return 1; }
uint16_t boot_id() { return 4711; }
uint16_t min_free_stack_bytes() { return 800; }

EncoderReading read_encoders() { return world.encoders(); }
uint32_t encoders_read_at_us() { return world.now_us(); }
LostSteps lost_encoder_steps() { return world.lost_steps(); }
bool encoders_tell_lost_steps() { return true; }
uint8_t closed_contacts() { return world.contacts(); }

bool can_bridge(BridgeKind kind) { return kind <= BridgeKind::kServo; }
uint16_t bridge_aux_pins(BridgeKind kind) { return kind == BridgeKind::kIn1In2Pwm ? 0x3 : 0; }
void use_bridge(BridgeKind kind, bool slow_pwm) {
  world.output(Output::kBridge,
               static_cast<uint16_t>((static_cast<uint16_t>(kind) << 1) | (slow_pwm ? 1U : 0U)));
}
void stop_motor(Motor motor, bool brake) { world.stop_motor(motor, brake); }
void set_motor(Motor motor, bool forward, uint8_t duty) { world.set_motor(motor, forward, duty); }
void set_servo_pulse_us(uint16_t pulse_us) { world.output(Output::kServo, pulse_us); }
void trigger_sonar() { world.trigger_sonar(); }
bool echo_is_high() { return world.echo_is_high(); }

bool has_range_sensor() { return false; }
RangeReading read_range() { return RangeReading{RangeReading::State::kAbsent, 0, 0}; }
bool has_yaw_gyro() { return false; }
bool read_yaw_deg(int16_t& /*degrees*/) { return false; }

void request_send() {}
uint16_t line_bytes_per_s() { return world.line_bytes_per_s(); }

uint8_t aux_pin_count() { return 16; }
bool aux_pin_can(uint8_t pin, PinUse use) { return pin >= 4 || use != PinUse::kAnalog; }
bool aux_pin_is_twi(uint8_t pin) { return pin == 14 || pin == 15; }
void use_aux_pin(uint8_t pin, PinUse use) {
  world.output(Output::kPinUse, static_cast<uint16_t>((uint16_t{pin} << 8) | uint8_t(use)));
}
uint16_t aux_levels() { return world.aux_levels(); }
void set_aux_output(uint8_t pin, bool high) {
  world.output(Output::kPinLevel, static_cast<uint16_t>((uint16_t{pin} << 8) | (high ? 1U : 0U)));
}

void start_conversion(uint8_t aux_pin) { world.output(Output::kConversion, aux_pin); }
bool conversion_done(uint16_t& value) {
  value = world.conversion();
  return true;
}

uint8_t counted_pulses() { return world.pulses(); }

bool has_twi() { return true; }
void start_twi_write(uint8_t address, uint8_t device_register, uint8_t value) {
  world.output(Output::kTwoWire, static_cast<uint16_t>((uint16_t{address} << 8) | device_register));
  world.output(Output::kTwoWire, value);
  world.start_two_wire();
}
void start_twi_read(uint8_t address, uint8_t device_register) {
  world.output(Output::kTwoWire, static_cast<uint16_t>((uint16_t{address} << 8) | device_register));
  world.start_two_wire();
}
TwiState twi_state(int16_t& value) { return world.two_wire_state(value); }
void stop_twi() { world.stop_two_wire(); }

}  // namespace hal
}  // namespace echomap
