// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/chip_modules.hpp"

#include <avr_extint.h>
#include <sim_io.h>
#include <stdexcept>
#include <string>
#include <string_view>

namespace echomap::emulator {
namespace {

/// Each module of simavr begins with its avr_io_t.
template <class Module, class Visit>
void for_each(const avr_t& avr, std::string_view kind, Visit visit) {
  for (avr_io_t* io = avr.io_port; io != nullptr; io = io->next) {
    if (io->kind == kind) {
      visit(*reinterpret_cast<Module*>(io));
    }
  }
}

template <class Module>
Module& find(const avr_t& avr, std::string_view kind, char name) {
  Module* found = nullptr;
  for_each<Module>(
      avr, kind, [&](Module& module) { found = module.name == name ? &module : found; });
  if (found == nullptr) {
    throw std::runtime_error("simavr's " + std::string(avr.mmcu) + " has no " + std::string(kind) +
                             ' ' + name);
  }
  return *found;
}

template <class Module>
Module& find_only(const avr_t& avr, std::string_view kind) {
  Module* found = nullptr;
  for_each<Module>(avr, kind, [&](Module& module) { found = &module; });
  if (found == nullptr) {
    throw std::runtime_error("simavr's " + std::string(avr.mmcu) + " has no " + std::string(kind));
  }
  return *found;
}

void add(const avr_int_vector_t& vector, InterruptRegisters& registers) {
  if (vector.raised.reg != 0) {
    registers.flags.insert(vector.raised.reg);
    registers.enables.insert(vector.enable.reg);
  }
}

}  // namespace

avr_ioport_t& find_port(const avr_t& avr, char letter) {
  return find<avr_ioport_t>(avr, "port", letter);
}

avr_timer_t& find_timer(const avr_t& avr, char number) {
  return find<avr_timer_t>(avr, "timer", number);
}

avr_uart_t& find_uart(const avr_t& avr, char number) {
  return find<avr_uart_t>(avr, "uart", number);
}

avr_twi_t& find_two_wire(const avr_t& avr) { return find_only<avr_twi_t>(avr, "twi"); }

avr_adc_t& find_converter(const avr_t& avr) { return find_only<avr_adc_t>(avr, "adc"); }

avr_watchdog_t& find_watchdog(const avr_t& avr) {
  return find_only<avr_watchdog_t>(avr, "watchdog");
}

InterruptRegisters find_interrupt_registers(const avr_t& avr) {
  InterruptRegisters registers;
  for_each<avr_timer_t>(
      avr, "timer", [&](const avr_timer_t& timer) { add(timer.overflow, registers); });
  for_each<avr_ioport_t>(
      avr, "port", [&](const avr_ioport_t& port) { add(port.pcint, registers); });
  for_each<avr_extint_t>(avr, "extint", [&](const avr_extint_t& external) {
    for (const auto& interrupt : external.eint) {
      add(interrupt.vector, registers);
    }
  });
  return registers;
}

}  // namespace echomap::emulator
