// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// What a board tells the portable code. The board calls these from its interrupts, never one
/// inside another; the program (firmware/app) defines them.

/// One period of kTickHz is over.
void on_tick();

/// The echo pin went high or low at `stamp_half_us`, half microseconds on the clock of `now_us`.
void on_echo_edge(bool high, uint32_t stamp_half_us);

/// The serial port received a byte.
void on_byte_received(uint8_t byte);

/// The serial port itself lost a byte because nobody took it in time.
void on_receive_overrun();

/// The serial port can send: fills `byte`, or answers false, and then asks no more until
/// `request_send`.
bool next_byte_to_send(uint8_t& byte);

}  // namespace hal
}  // namespace echomap
