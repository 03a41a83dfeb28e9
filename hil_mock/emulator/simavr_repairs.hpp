// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sim_avr.h>

#include "hil_mock/emulator/cycle_queue.hpp"
#include "hil_mock/emulator/register_hooks.hpp"

/// Where simavr differs from an ATmega in a way that this firmware would notice, each repaired
/// from outside through simavr's public structures. Each function is called once, before the
/// program runs; tests/hil/emulated_chip_test.cpp shows what each one mends.
namespace echomap::emulator {

/// Any write to TIFRn clears every flag of that timer: makes it clear only the bits written as one.
/// (Done upstream in simavr 1.8.) The same for PCIFR and EIFR, where a write would set flags.
void repair_flag_clearing(avr_t& avr, RegisterHooks& hooks);

/// A flag that rose while its interrupt was disabled never fires: makes it fire when enabled.
void repair_late_enable(avr_t& avr, RegisterHooks& hooks);

/// Entering an interrupt costs no time: makes it 4 cycles, or 5 with 3 bytes of program
/// counter (Microchip DS40002061B section 7.7.1 and Atmel-2549Q section 7.8.1, "Interrupt Response
/// Time").
void repair_interrupt_entry_time(avr_t& avr);

/// Only port B of an ATmega2560 has pin change interrupts: gives port K those that it has (PCINT16
/// to PCINT23, Atmel-2549Q sections 14.1 and 15.2.6 on). First of all, for the others look at each
/// interrupt.
void repair_pin_change(avr_t& avr);

/// A watchdog in interrupt and reset mode whose interrupt cannot be served, because interrupts are
/// locked, raises it for ever: makes the second timeout reset the chip (Microchip DS40002061B
/// section 11.9.2, "WDIE"). `queue` outlives `avr`'s last run.
void repair_watchdog(avr_t& avr, CycleQueue& queue);

}  // namespace echomap::emulator
