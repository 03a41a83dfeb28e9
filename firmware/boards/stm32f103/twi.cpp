// SPDX-License-Identifier: MIT
#include "firmware/hal/twi.hpp"

/// This board has no driver for its I2C units yet, and says so.
namespace echomap {
namespace hal {

bool has_twi() { return false; }

void start_twi_write(uint8_t /*address*/, uint8_t /*device_register*/, uint8_t /*value*/) {}

void start_twi_read(uint8_t /*address*/, uint8_t /*device_register*/) {}

TwiState twi_state(int16_t& /*value*/) { return TwiState::kFailed; }

void stop_twi() {}

}  // namespace hal
}  // namespace echomap
