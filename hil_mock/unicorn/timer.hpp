// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"
#include "hil_mock/world/pin_signal.hpp"

namespace echomap::unicorn {

/// A timer of the family TIM1 .. TIM4: counts up, makes PWM on two channels, captures its first
/// input, and interrupts. Source: ST RM0008, chapters 14 and 15. Preloads of compare and reload are
/// not modelled, a new value holds at once; nor is the update flag while its interrupt is off.
class Timer final : public Peripheral {
 public:
  Timer(EventQueue& queue, Nvic& nvic, std::uint8_t line)
      : queue_(queue), nvic_(nvic), line_(line) {}

  /// Level of the timer's first input, for the channels that capture it.
  void set_input1(bool high);

  /// Output of channel 1 or 2, on a pin that the timer has; low where it makes no PWM.
  world::PinSignal output(unsigned channel) const;
  /// Length of the pulses of channel 1, in cycles.
  std::uint64_t pulse_cycles() const;

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  bool runs() const;
  bool is_output(unsigned channel) const;
  bool makes_pwm(unsigned channel) const;
  bool captures(unsigned channel, bool rising) const;
  std::uint32_t& value(std::uint32_t offset) { return registers_[offset / 4]; }
  std::uint32_t value(std::uint32_t offset) const { return registers_[offset / 4]; }
  std::uint64_t period_cycles() const;
  std::uint32_t count() const;
  void restart(std::uint32_t count);
  void schedule_update();
  void set_flags(std::uint32_t flags);

  EventQueue& queue_;
  Nvic& nvic_;
  std::uint8_t line_;
  std::array<std::uint32_t, 20> registers_{};
  std::uint32_t prescaler_ = 0;   ///< The one in force: PSC as of the last update.
  std::uint64_t zero_cycle_ = 0;  ///< When the count was 0.
  std::uint32_t stopped_count_ = 0;
  std::uint32_t schedules_ = 0;
  bool input1_ = false;
};

}  // namespace echomap::unicorn
