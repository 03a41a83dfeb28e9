// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// The window watchdog with its early wake-up interrupt, on a bus of half the CPU's 72 MHz. Source:
/// ST RM0008, chapter 20. Only a reset stops it.
class Wwdg final : public Peripheral {
 public:
  Wwdg(EventQueue& queue, Nvic& nvic) : queue_(queue), nvic_(nvic) {}

  /// Called when nobody has kicked it in time, or somebody did before its window.
  std::function<void()> on_timeout;

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  void write_control(std::uint32_t value);
  std::uint64_t step_cycles() const;
  std::uint32_t count() const;
  void restart(std::uint32_t count);
  void at_step(std::uint64_t step, std::function<void()> event);
  void update();

  EventQueue& queue_;
  Nvic& nvic_;
  bool runs_ = false;
  bool warned_ = false;
  std::uint32_t first_count_ = 0;
  std::uint32_t configuration_ = 0;
  std::uint64_t start_cycle_ = 0;
  std::uint32_t rounds_ = 0;
};

}  // namespace echomap::unicorn
