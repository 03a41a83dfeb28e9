// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <avr_adc.h>
#include <avr_ioport.h>
#include <avr_timer.h>
#include <avr_twi.h>
#include <avr_uart.h>
#include <avr_watchdog.h>
#include <cstdint>
#include <set>
#include <sim_avr.h>

/// The peripherals of a chip as simavr describes them: with their registers' addresses in the data
/// space, so that no table of ours repeats the data sheet's.
namespace echomap::emulator {

/// By letter or number, as in PORTB, TCCR1A and UDR0. Each throws std::runtime_error where the chip
/// has no such peripheral.
avr_ioport_t& find_port(const avr_t& avr, char letter);
avr_timer_t& find_timer(const avr_t& avr, char number);
avr_uart_t& find_uart(const avr_t& avr, char number);
/// There is one of each in a chip.
avr_twi_t& find_two_wire(const avr_t& avr);
avr_adc_t& find_converter(const avr_t& avr);

/// Throws std::runtime_error where the chip has none.
avr_watchdog_t& find_watchdog(const avr_t& avr);

/// Registers of timers, external and pin change interrupts: TIFRn, EIFR, PCIFR and TIMSKn, EIMSK,
/// PCICR.
struct InterruptRegisters {
  std::set<std::uint16_t> flags;
  std::set<std::uint16_t> enables;
};
InterruptRegisters find_interrupt_registers(const avr_t& avr);

}  // namespace echomap::emulator
