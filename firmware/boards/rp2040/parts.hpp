// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// The parts of the board that hal::start_board starts, one file each.
namespace echomap {
namespace boards {

/// 125 MHz for the core, its peripherals and the serial port, 48 MHz for USB and the converter,
/// microseconds for timer and watchdog; all other parts out of their reset. First of all.
void start_clock();
/// Makes parts of the chip, by their bits in RESETS, as they are after power-on.
void reset_parts(uint32_t parts);

/// PWM slices 5 and 6: motor PWM or servo pulses, off.
void start_motors();
/// Both motors off at once, whatever else goes on.
void cut_motors();
/// Resets the chip now, as the watchdog does.
void reset_chip();
/// Gives this start a boot id of its own; once, before hal::boot_id.
void number_this_boot();
/// Alarm 0 of the timer: the tick.
void start_tick();
/// PWM slice 3: length of the echo. After start_tick.
void start_echo();
/// PWM slice 4: servo pulses, none yet.
void start_servo();
/// PIO0: counts of both wheels.
void start_encoders();
void start_contacts();
/// Spare pins: all unused.
void start_aux_pins();
/// Channel of the converter that reads a spare pin which is used as hal::PinUse::kAnalog.
uint8_t converter_channel(uint8_t aux_pin);
void start_converter();
/// From now on this pin's pulses are counted, and no other's; or no more, if it was the one.
void count_pulses_of(uint8_t pin);
void count_no_pulses_of(uint8_t pin);
/// From the interrupt of the pins: counts a pulse if there was one.
void take_pulse();
/// UART0 with ECHOMAP_BAUD, 8N1, driven by interrupts.
void start_uart();
/// The USB device, which shows itself to a host from now on.
void start_usb();

}  // namespace boards
}  // namespace echomap
