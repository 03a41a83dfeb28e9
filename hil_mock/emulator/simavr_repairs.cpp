// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/simavr_repairs.hpp"

#include <cstdint>
#include <set>
#include <sim_interrupts.h>
#include <sim_irq.h>
#include <sim_regbit.h>
#include <span>
#include <string_view>

#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {
namespace {

/// The program counter is pushed in its first cycles, a byte a cycle.
constexpr std::uint32_t kEntryCyclesBesidesPush = 2;

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
  const std::uint32_t cycles = avr.address_size + kEntryCyclesBesidesPush;
  avr.cycle += cycles;
  // The run up to the next cycle timer was measured before the entry.
  avr.run_cycle_count = avr.run_cycle_count > cycles ? avr.run_cycle_count - cycles : 1;
}

/// simavr resets at a timeout with WDIE cleared: right before the second one is soon enough.
void await_second_timeout(avr_irq_t* /*irq*/, std::uint32_t pending, void* param) {
  constexpr std::uint64_t kBeforeTimeout = 16;
  if (pending == 0) {
    return;
  }
  auto& queue = *static_cast<CycleQueue*>(param);
  avr_t& avr = queue.avr();
  queue.at(avr.cycle + find_watchdog(avr).cycle_count - kBeforeTimeout, [&avr] {
    const avr_int_vector_t& interrupt = find_watchdog(avr).watchdog;
    if (interrupt.pending != 0) {
      avr_regbit_clear(&avr, interrupt.enable);
    }
  });
}

}  // namespace

void repair_flag_clearing(avr_t& avr, RegisterHooks& hooks) {
  for (const std::uint16_t address : find_interrupt_registers(avr).flags) {
    hooks.replace_write(address,
                        [&avr, address](std::uint8_t ones) { clear_flags(avr, address, ones); });
  }
}

void repair_late_enable(avr_t& avr, RegisterHooks& hooks) {
  std::set<std::uint16_t> addresses = find_interrupt_registers(avr).enables;
  addresses.insert(find_uart(avr, '0').r_ucsrb);
  for (const std::uint16_t address : addresses) {
    hooks.after_write(address, [&avr, address] { fire_waiting_flags(avr, address); });
  }
}

void repair_interrupt_entry_time(avr_t& avr) {
  for (avr_int_vector_t* vector : vectors_of(avr)) {
    avr_irq_register_notify(vector->irq + AVR_INT_IRQ_RUNNING, &spend_entry_time, &avr);
  }
}

void repair_pin_change(avr_t& avr) {
  constexpr unsigned kGroup = 2;
  if (avr.mmcu != std::string_view("atmega2560")) {
    return;
  }
  const avr_ioport_t& first = find_port(avr, 'B');
  avr_ioport_t& port = find_port(avr, 'K');
  port.r_pcint = static_cast<avr_io_addr_t>(first.r_pcint + kGroup);
  port.pcint.enable = first.pcint.enable;
  port.pcint.enable.bit = kGroup;
  port.pcint.raised = first.pcint.raised;
  port.pcint.raised.bit = kGroup;
  port.pcint.vector = static_cast<std::uint8_t>(first.pcint.vector + kGroup);
  avr_register_vector(&avr, &port.pcint);
}

void repair_watchdog(avr_t& avr, CycleQueue& queue) {
  avr_irq_register_notify(
      find_watchdog(avr).watchdog.irq + AVR_INT_IRQ_PENDING, &await_second_timeout, &queue);
}

}  // namespace echomap::emulator
