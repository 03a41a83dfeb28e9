// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// What the encoders of both wheels have counted since the start, by whatever counts them: a pin
/// interrupt, a timer, a state machine or an operating system.
struct EncoderReading {
  uint32_t at_us;      ///< When the counts were so, on the clock of `now_us`.
  int16_t left;        ///< Counts, four a period of the pins and modulo 2^16; a wheel turns
  int16_t right;       ///< forward when A leads B.
  uint16_t left_lost;  ///< How often both pins of a wheel had changed at once, modulo 2^16; 0 where
  uint16_t right_lost;  ///< not `encoders_tell_lost_steps`.
};

/// The counts now. Callable with interrupts locked.
EncoderReading read_encoders();

/// False for a counter that cannot see that it has lost a count.
bool encoders_tell_lost_steps();

}  // namespace hal
}  // namespace echomap
