// SPDX-License-Identifier: MIT
#include "firmware/hal/adc.hpp"
#include "firmware/hal/aux_pins.hpp"
#include "firmware/hal/pulses.hpp"
#include "firmware/hal/sonar.hpp"
#include "firmware/hal/twi.hpp"

/// The brick has ports in place of pins: no spare ones, no echo pin, no bus.
namespace echomap {
namespace hal {

uint8_t aux_pin_count() { return 0; }
bool aux_pin_can(uint8_t /*pin*/, PinUse /*use*/) { return false; }
bool aux_pin_is_twi(uint8_t /*pin*/) { return false; }
void use_aux_pin(uint8_t /*pin*/, PinUse /*use*/) {}
uint16_t aux_levels() { return 0; }
void set_aux_output(uint8_t /*pin*/, bool /*high*/) {}

void start_conversion(uint8_t /*aux_pin*/) {}
bool conversion_done(uint16_t& value) {
  value = 0;
  return true;
}

uint8_t counted_pulses() { return 0; }

void trigger_sonar() {}
bool echo_is_high() { return false; }

bool has_twi() { return false; }
void start_twi_write(uint8_t /*address*/, uint8_t /*device_register*/, uint8_t /*value*/) {}
void start_twi_read(uint8_t /*address*/, uint8_t /*device_register*/) {}
TwiState twi_state(int16_t& value) {
  value = 0;
  return TwiState::kIdle;
}
void stop_twi() {}

}  // namespace hal
}  // namespace echomap
