// SPDX-License-Identifier: MIT
#include "firmware/boards/native/native_board.hpp"
#include "firmware/hal/adc.hpp"
#include "firmware/hal/aux_pins.hpp"
#include "firmware/hal/boot.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/motors.hpp"
#include "firmware/hal/pulses.hpp"
#include "firmware/hal/range_sensor.hpp"
#include "firmware/hal/servo.hpp"
#include "firmware/hal/sonar.hpp"
#include "firmware/hal/stack.hpp"
#include "firmware/hal/twi.hpp"
#include "firmware/hal/uart.hpp"
#include "firmware/hal/watchdog.hpp"
#include "firmware/hal/yaw_gyro.hpp"
#include "protocol/handshake_messages.hpp"

/// firmware/hal on the native board: events come one after the other, so nothing needs a lock.
namespace echomap {
namespace hal {
namespace {

native::NativeBoard& board() { return native::NativeBoard::instance(); }

}  // namespace

uint32_t now_us() { return static_cast<uint32_t>(board().program_ns() / 1000); }

uint8_t lock_interrupts() { return 0; }
void restore_interrupts(uint8_t /*state*/) {}

bool can_bridge(BridgeKind kind) { return kind <= BridgeKind::kServo; }
uint16_t bridge_aux_pins(BridgeKind kind) { return kind == BridgeKind::kIn1In2Pwm ? 0x3 : 0; }
void use_bridge(BridgeKind kind, bool slow_pwm) { board().use_bridge(kind, slow_pwm); }
void set_motor(Motor motor, bool forward, uint8_t duty) {
  board().set_motor(motor, static_cast<int16_t>(forward ? duty : -duty), false);
}
void stop_motor(Motor motor, bool brake) { board().set_motor(motor, 0, brake); }

void set_servo_pulse_us(uint16_t pulse_us) { board().set_pan_pulse_us(pulse_us); }

void trigger_sonar() { board().trigger_sonar(); }
bool echo_is_high() { return board().echo_is_high(); }

bool has_range_sensor() { return board().range_sensor.has_value(); }
RangeReading read_range() { return board().range_sensor.value_or(RangeReading{}); }

bool has_yaw_gyro() { return board().has_yaw_gyro; }
bool read_yaw_deg(int16_t& degrees) {
  degrees = board().yaw_deg.value_or(0);
  return board().yaw_deg.has_value();
}

uint8_t closed_contacts() { return board().closed_contacts(); }

uint8_t aux_pin_count() { return native::NativeBoard::kAuxPins; }
bool aux_pin_can(uint8_t pin, PinUse /*use*/) { return pin < native::NativeBoard::kAuxPins; }
bool aux_pin_is_twi(uint8_t pin) { return (board().twi_aux_pins >> pin & 1U) != 0; }
void use_aux_pin(uint8_t pin, PinUse use) { board().use_aux_pin(pin, use); }
uint16_t aux_levels() { return board().aux_levels(); }
void set_aux_output(uint8_t pin, bool high) { board().set_aux_output(pin, high); }

void start_conversion(uint8_t aux_pin) { board().start_conversion(aux_pin); }
bool conversion_done(uint16_t& value) { return board().conversion_done(value); }

uint8_t counted_pulses() { return board().counted_pulses(); }

bool has_twi() { return true; }
void start_twi_write(uint8_t address, uint8_t device_register, uint8_t value) {
  board().two_wire.start_write(board().now_ns(), address, device_register, value);
}
void start_twi_read(uint8_t address, uint8_t device_register) {
  board().two_wire.start_read(board().now_ns(), address, device_register);
}
TwiState twi_state(int16_t& value) { return board().two_wire.state(board().now_ns(), value); }
void stop_twi() { board().two_wire.stop(); }

void request_send() { board().request_send(); }
uint16_t line_bytes_per_s() { return 1000000000 / native::NativeBoard::kByteNs; }

void start_watchdog() {}
void kick_watchdog() { board().kick_watchdog(); }

uint8_t reset_cause() {
  return board().starts() == 1 ? protocol::kResetPowerOn : protocol::kResetExternal;
}
uint16_t boot_id() { return board().starts(); }

/// The stack of this computer is nobody's worry.
uint16_t min_free_stack_bytes() { return UINT16_MAX; }

}  // namespace hal
}  // namespace echomap
