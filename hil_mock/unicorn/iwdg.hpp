// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// The independent watchdog, its oscillator at exactly 40 kHz. Source: ST RM0008, chapter 19. Only
/// a reset stops it.
class Iwdg final : public Peripheral {
 public:
  explicit Iwdg(EventQueue& queue) : queue_(queue) {}

  /// Called when nobody has kicked it in time.
  std::function<void()> on_timeout;

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  void restart();

  EventQueue& queue_;
  bool runs_ = false;
  bool unlocked_ = false;
  std::uint32_t prescaler_ = 0;
  std::uint32_t reload_ = 0;
  std::uint32_t rounds_ = 0;
};

}  // namespace echomap::unicorn
