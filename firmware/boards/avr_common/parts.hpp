// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// The parts of an AVR board that hal::start_board starts, one file each, and what else differs
/// between them; all but the tick is the board's own.
namespace echomap {
namespace boards {

/// Motor PWM, off.
void start_motors();
/// Both motors off at once, whatever else goes on.
void cut_motors();
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

/// The pins of the two-wire bus while TWI has not taken them: inputs, but for an SCL that is held,
/// which is low.
bool sda_is_low();
void hold_scl();
void release_scl();

}  // namespace boards
}  // namespace echomap
