// SPDX-License-Identifier: MIT
#pragma once

/// The parts of an AVR board that hal::start_board starts, one file each; all but the tick are the
/// board's own.
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

}  // namespace boards
}  // namespace echomap
