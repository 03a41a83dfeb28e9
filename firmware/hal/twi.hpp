// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// How the last transfer on the two-wire bus (I2C, 400 kbit/s) stands.
enum class TwiState : uint8_t { kIdle, kBusy, kDone, kFailed };

/// True where the board has a two-wire bus. It takes its pins while transfers are started and gives
/// them back with `stop_twi`.
bool has_twi();
/// Writes `value` into a device's register; nothing waits. Only while no transfer is under way.
void start_twi_write(uint8_t address, uint8_t device_register, uint8_t value);
/// Reads two bytes from a device's register on, the high one first.
void start_twi_read(uint8_t address, uint8_t device_register);
/// State of the transfer; kDone and kFailed stand until the next one is started. `value` is what a
/// finished read brought.
TwiState twi_state(int16_t& value);
/// Gives up whatever is under way: a device that holds the bus must not hold the robot.
void stop_twi();

}  // namespace hal
}  // namespace echomap
