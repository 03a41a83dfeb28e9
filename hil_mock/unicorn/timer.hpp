// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"
#include "hil_mock/world/pin_signal.hpp"

namespace echomap::unicorn {

/// What one timer of the family has of its own.
struct TimerKind {
  std::uint8_t update_line;
  std::uint8_t capture_line;
  bool has_main_output_enable = false;  ///< BDTR.MOE, of TIM1.
};

/// A timer of the family TIM1 .. TIM4: counts up, makes PWM, captures its first input with channels
/// 1 and 2, or counts the edges of its first two inputs as an encoder's, and interrupts. Source: ST
/// RM0008, chapters 14 and 15. The preload of the reload is not modelled, a new one holds at once;
/// nor are filters of inputs, and the update flag while its interrupt is off.
class Timer final : public Peripheral {
 public:
  Timer(EventQueue& queue, Nvic& nvic, TimerKind kind) : queue_(queue), nvic_(nvic), kind_(kind) {}

  /// Level of the timer's input 1 or 2.
  void set_input(unsigned input, bool high);

  /// Output of channel 1 to 4, on a pin that the timer has; low where it makes no PWM.
  world::PinSignal output(unsigned channel) const;
  /// Length of the channel's pulses, in cycles.
  std::uint64_t pulse_cycles(unsigned channel) const;
  /// Called when an update has taken over compares that were preloaded.
  std::function<void()> on_preload_taken;

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  bool runs() const;
  bool is_encoder() const;
  bool counts_clock() const { return runs() && !is_encoder(); }
  void count_edge(unsigned input);
  void capture(bool high);
  unsigned mode_bits(unsigned channel) const;
  unsigned enable_bits(unsigned channel) const;
  bool is_output(unsigned channel) const;
  bool is_preloaded(unsigned channel) const;
  bool makes_pwm(unsigned channel) const;
  bool captures(unsigned channel, bool rising) const;
  std::uint32_t& value(std::uint32_t offset) { return registers_[offset / 4]; }
  std::uint32_t value(std::uint32_t offset) const { return registers_[offset / 4]; }
  std::uint64_t period_cycles() const;
  std::uint32_t count() const;
  void restart(std::uint32_t count);
  std::uint32_t compare_in_force(unsigned channel) const;
  void take_compares(bool at_update);
  bool has_preloads() const;
  void schedule_update();
  void update();
  void set_flags(std::uint32_t flags);

  EventQueue& queue_;
  Nvic& nvic_;
  TimerKind kind_;
  std::array<std::uint32_t, 20> registers_{};
  std::array<std::uint32_t, 4> compares_{};  ///< As of the last update, where preloaded.
  std::uint32_t prescaler_ = 0;              ///< The one in force: PSC as of the last update.
  std::uint64_t zero_cycle_ = 0;             ///< When the count was 0.
  std::uint32_t stopped_count_ = 0;
  std::uint32_t schedules_ = 0;
  std::array<bool, 2> inputs_{};
};

}  // namespace echomap::unicorn
