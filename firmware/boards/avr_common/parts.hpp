// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// The parts of an AVR board that hal::start_board starts, one file each, and what else differs
/// between them; all but the tick is the board's own.
namespace echomap {
namespace boards {

/// Motor PWM, off.
void start_motors();
/// Clock, servo pulses (none yet) and echo capture: `FrameTimer`.
void start_frame_timer();
/// Timer 2: the tick.
void start_tick();
/// Pin change interrupt of the encoders.
void start_encoders();
/// Inputs of the bump contacts.
void start_contacts();

/// Channel of the converter that reads a spare pin which is used as hal::PinUse::kAnalog.
uint8_t converter_channel(uint8_t aux_pin);

}  // namespace boards
}  // namespace echomap
