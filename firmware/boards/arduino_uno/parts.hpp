// SPDX-License-Identifier: MIT
#pragma once

/// The parts of the board that hal::start_board starts, one file each.
namespace echomap {
namespace boards {

/// Timer 0: motor PWM, off.
void start_motors();
/// Timer 1: clock, servo pulses (none yet) and echo capture.
void start_timer1();
/// Timer 2: the tick.
void start_tick();
/// Pin change interrupt of the encoders.
void start_encoders();
void start_contacts();

}  // namespace boards
}  // namespace echomap
