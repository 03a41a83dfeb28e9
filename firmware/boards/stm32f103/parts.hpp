// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

/// The parts of the board that hal::start_board starts, one file each.
namespace echomap {
namespace boards {

/// 72 MHz from the crystal, or else 8 MHz; the clock of every part below. First of all.
void start_clock();
/// Frequency of core and timers.
uint32_t clock_hz();
/// Whether that is 72 MHz, and 36 MHz of the slower bus.
bool runs_by_crystal();
/// A round of timer 1: 20 ms.
constexpr uint32_t kFrameHalfUs = 40000;
/// What a timer's prescaler is loaded with to make it count half microseconds.
uint32_t half_us_prescaler();

/// TIM3: motor PWM or servo pulses, off.
void start_motors();
/// Both motors off at once, whatever else goes on.
void cut_motors();
/// Gives this start a boot id of its own; once, before hal::boot_id.
void number_this_boot();
/// SysTick: clock and tick.
void start_tick();
/// Half microseconds on the clock of hal::now_us, modulo 2^32.
uint32_t now_half_us();
/// TIM1: echo capture, and the rounds of a servo frame. After start_tick.
void start_echo();
/// TIM1, too: servo pulses, none yet. After start_echo.
void start_servo();
/// TIM2 and TIM4: counts of the wheels.
void start_encoders();
void start_contacts();
/// Spare pins: all unused.
void start_aux_pins();
/// Channel of the converter that reads a spare pin which is used as hal::PinUse::kAnalog.
uint8_t converter_channel(uint8_t aux_pin);
/// ADC1, calibrated.
void start_converter();
/// USART1 with ECHOMAP_BAUD, 8N1, driven by interrupts.
void start_uart();

/// Adds one to the number of power-ups, which is kept in the flash, and returns it.
uint16_t count_power_up();

}  // namespace boards
}  // namespace echomap
