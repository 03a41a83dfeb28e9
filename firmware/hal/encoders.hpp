// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// What the encoders of both wheels have counted since the start, by whatever counts them: a pin
/// interrupt, a timer, a state machine or an operating system.
struct EncoderReading {
  int16_t left;   ///< Counts, four a period of the pins and modulo 2^16; a wheel turns forward when
  int16_t right;  ///< A leads B.
};
EncoderReading read_encoders();
/// When the counts that were read last were so, on the clock of `now_us`. Apart from them, for the
/// control loop has no use for it and an AVR needs 4 us to tell the time.
uint32_t encoders_read_at_us();

/// How often both pins of a wheel had changed at once since the start, modulo 2^16: counts that are
/// lost.
struct LostSteps {
  uint16_t left;
  uint16_t right;
};
/// Zeros where the counter cannot see it: not `encoders_tell_lost_steps`.
LostSteps lost_encoder_steps();
bool encoders_tell_lost_steps();

}  // namespace hal
}  // namespace echomap
