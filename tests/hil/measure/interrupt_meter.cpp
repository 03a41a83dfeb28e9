// SPDX-License-Identifier: MIT
#include "tests/hil/measure/interrupt_meter.hpp"

#include <algorithm>
#include <sim_interrupts.h>
#include <sim_irq.h>

#include "tests/hil/measure/cycles.hpp"

namespace echomap::tests {
namespace {

constexpr std::int64_t kTickCycles = emulator::kClockHz / 1000;

/// simavr's callback for sleep carries nothing of ours.
std::uint64_t slept_cycles = 0;

void count_sleep(avr_t* /*avr*/, avr_cycle_count_t cycles) { slept_cycles += cycles + 1; }

void sleep_uncounted(avr_t* /*avr*/, avr_cycle_count_t /*cycles*/) {}

/// Of an entry as of a return. simavr, with our repairs, tells of an entry after its cycles and of
/// a return before them.
std::uint32_t transfer_cycles(const avr_t& avr) { return avr.address_size + 2U; }

avr_irq_t* running_irq(avr_t& avr) { return avr.interrupts.irq + AVR_INT_IRQ_RUNNING; }

}  // namespace

InterruptMeter::InterruptMeter(emulator::AvrMachine& machine, int tick_vector)
    : machine_(machine), tick_vector_(tick_vector) {
  machine_.core().sleep = &count_sleep;
  avr_irq_register_notify(running_irq(machine_.core()), &InterruptMeter::on_irq, this);
  restart();
}

InterruptMeter::~InterruptMeter() {
  machine_.core().sleep = &sleep_uncounted;
  avr_irq_unregister_notify(running_irq(machine_.core()), &InterruptMeter::on_irq, this);
}

void InterruptMeter::on_irq(avr_irq_t* /*irq*/, std::uint32_t vector, void* meter) {
  auto& self = *static_cast<InterruptMeter*>(meter);
  if (vector != 0) {
    self.entered(static_cast<int>(vector));
  } else {
    self.left();
  }
}

void InterruptMeter::restart() {
  costs_.clear();
  running_ = 0;
  interrupt_cycles_ = 0;
  slept_cycles = 0;
  start_cycle_ = machine_.cycle();
  first_tick_cycle_ = 0;
  earliest_tick_ = 0;
  latest_tick_ = 0;
}

double InterruptMeter::interrupt_share() const {
  return double(interrupt_cycles_) / passed_cycles();
}

double InterruptMeter::program_share() const {
  return 1.0 - interrupt_share() - double(slept_cycles) / passed_cycles();
}

double InterruptMeter::tick_jitter_us() const {
  return double(latest_tick_ - earliest_tick_) / kCyclesPerUs;
}

void InterruptMeter::entered(int vector) {
  running_ = vector;
  entry_cycle_ = machine_.cycle() - transfer_cycles(machine_.core());
  if (vector == tick_vector_) {
    note_tick();
  }
}

void InterruptMeter::note_tick() {
  if (first_tick_cycle_ == 0) {
    first_tick_cycle_ = entry_cycle_;
  }
  const auto since = static_cast<std::int64_t>(entry_cycle_ - first_tick_cycle_);
  const std::int64_t ticks = (since + kTickCycles / 2) / kTickCycles;
  earliest_tick_ = std::min(earliest_tick_, since - ticks * kTickCycles);
  latest_tick_ = std::max(latest_tick_, since - ticks * kTickCycles);
}

/// A handler that was entered before `restart` is none of ours.
void InterruptMeter::left() {
  if (running_ == 0) {
    return;
  }
  const auto took = static_cast<std::uint32_t>(machine_.cycle() - entry_cycle_) +
                    transfer_cycles(machine_.core());
  InterruptCost& cost = costs_[running_];
  ++cost.calls;
  cost.cycles += took;
  cost.least = std::min(cost.least, took);
  cost.most = std::max(cost.most, took);
  interrupt_cycles_ += took;
  running_ = 0;
}

}  // namespace echomap::tests
