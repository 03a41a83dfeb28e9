// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/simavr_repairs.hpp"

#include <cstdint>
#include <sim_interrupts.h>
#include <sim_irq.h>
#include <sim_regbit.h>
#include <span>

#include "hil_mock/emulator/atmega328p.hpp"

namespace echomap::emulator {
namespace {

constexpr std::uint16_t kFlagRegisters[] = {atmega328p::kTifr0,
                                            atmega328p::kTifr1,
                                            atmega328p::kTifr2,
                                            atmega328p::kPcifr,
                                            atmega328p::kEifr};
constexpr std::uint16_t kEnableRegisters[] = {atmega328p::kTimsk0,
                                              atmega328p::kTimsk1,
                                              atmega328p::kTimsk2,
                                              atmega328p::kPcicr,
                                              atmega328p::kEimsk,
                                              atmega328p::kUcsr0b};
constexpr std::uint32_t kInterruptEntryCycles = 4;

std::span<avr_int_vector_t* const> vectors_of(const avr_t& avr) {
  return {avr.interrupts.vector, avr.interrupts.vector_count};
}

void clear_flags(avr_t& avr, std::uint16_t address, std::uint8_t ones) {
  for (avr_int_vector_t* vector : vectors_of(avr)) {
    if (vector->raised.reg == address && ((ones >> vector->raised.bit) & 1) != 0) {
      avr_clear_interrupt(&avr, vector);
    }
  }
  avr.data[address] = static_cast<std::uint8_t>(avr.data[address] & ~ones);
}

void fire_waiting_flags(avr_t& avr, std::uint16_t address) {
  for (avr_int_vector_t* vector : vectors_of(avr)) {
    if (vector->enable.reg == address && vector->pending == 0 &&
        avr_regbit_get(&avr, vector->enable) != 0 && avr_regbit_get(&avr, vector->raised) != 0) {
      avr_raise_interrupt(&avr, vector);
    }
  }
}

void spend_entry_time(avr_irq_t* /*irq*/, std::uint32_t entered, void* param) {
  if (entered == 0) {
    return;
  }
  auto& avr = *static_cast<avr_t*>(param);
  avr.cycle += kInterruptEntryCycles;
  // The run up to the next cycle timer was measured before the entry.
  avr.run_cycle_count =
      avr.run_cycle_count > kInterruptEntryCycles ? avr.run_cycle_count - kInterruptEntryCycles : 1;
}

}  // namespace

void repair_flag_clearing(avr_t& avr, RegisterHooks& hooks) {
  for (const std::uint16_t address : kFlagRegisters) {
    hooks.replace_write(address,
                        [&avr, address](std::uint8_t ones) { clear_flags(avr, address, ones); });
  }
}

void repair_late_enable(avr_t& avr, RegisterHooks& hooks) {
  for (const std::uint16_t address : kEnableRegisters) {
    hooks.after_write(address, [&avr, address] { fire_waiting_flags(avr, address); });
  }
}

void repair_interrupt_entry_time(avr_t& avr) {
  for (avr_int_vector_t* vector : vectors_of(avr)) {
    avr_irq_register_notify(vector->irq + AVR_INT_IRQ_RUNNING, &spend_entry_time, &avr);
  }
}

}  // namespace echomap::emulator
