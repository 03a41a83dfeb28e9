// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <sim_irq.h>

#include "hil_mock/emulator/avr_machine.hpp"

namespace echomap::tests {

/// What calls of one interrupt have cost, in cycles from leaving the program to being back in it:
/// entry, the vector's jump, the handler and its return.
struct InterruptCost {
  std::uint64_t calls = 0;
  std::uint64_t cycles = 0;
  std::uint32_t least = UINT32_MAX;
  std::uint32_t most = 0;

  double mean() const { return calls == 0 ? 0.0 : double(cycles) / double(calls); }
};

/// Counts what interrupts cost, how late the tick is entered, and how long the chip sleeps.
class InterruptMeter {
 public:
  /// `machine` outlives the meter, `tick_vector` is the number of its millisecond's interrupt. One
  /// meter at a time.
  InterruptMeter(emulator::AvrMachine& machine, int tick_vector);
  ~InterruptMeter();
  InterruptMeter(const InterruptMeter&) = delete;
  InterruptMeter& operator=(const InterruptMeter&) = delete;

  /// Starts again.
  void restart();

  /// By vector number.
  const std::map<int, InterruptCost>& costs() const { return costs_; }
  /// Share of all cycles that interrupts took.
  double interrupt_share() const;
  /// Share that the program took outside of interrupts: neither they nor sleep.
  double program_share() const;
  /// Latest less earliest entry of the tick, each against a grid of a millisecond.
  double tick_jitter_us() const;

 private:
  static void on_irq(avr_irq_t* irq, std::uint32_t vector, void* meter);
  void entered(int vector);
  void left();
  void note_tick();
  double passed_cycles() const { return double(machine_.cycle() - start_cycle_); }

  emulator::AvrMachine& machine_;
  int tick_vector_;
  std::map<int, InterruptCost> costs_;
  int running_ = 0;
  std::uint64_t entry_cycle_ = 0;
  std::uint64_t interrupt_cycles_ = 0;
  std::uint64_t start_cycle_ = 0;
  std::uint64_t first_tick_cycle_ = 0;
  std::int64_t earliest_tick_ = 0;
  std::int64_t latest_tick_ = 0;
};

}  // namespace echomap::tests
