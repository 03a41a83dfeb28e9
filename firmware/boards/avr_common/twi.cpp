// SPDX-License-Identifier: MIT
#include "firmware/hal/twi.hpp"

namespace echomap {
namespace hal {

bool has_twi() { return false; }
void start_twi_write(uint8_t, uint8_t, uint8_t) {}
void start_twi_read(uint8_t, uint8_t) {}
TwiState twi_state(int16_t&) { return TwiState::kIdle; }
void stop_twi() {}

}  // namespace hal
}  // namespace echomap
