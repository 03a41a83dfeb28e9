// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// AFIO: which port each EXTI line looks at, which pins the debug port has, and where
/// channels 1 and 2 of TIM2 are. Source: ST RM0008, sections 9.3 and 9.4.
class Afio final : public Peripheral {
 public:
  bool listens_to(std::uint8_t port, std::uint8_t pin) const {
    return (exticr_[pin / 4] >> (pin % 4 * 4) & 0xFU) == port;
  }
  /// Channels 1 and 2, instead of on A0 and A1.
  bool tim2_is_on_a15_and_b3() const;
  /// Which pins are JTAG's and no program's: bits of port A (A15) and of port B (B3, B4). All are
  /// from a reset on.
  std::uint32_t jtag_pins_of_a() const;
  std::uint32_t jtag_pins_of_b() const;
  /// Called when that may have changed.
  std::function<void()> on_remap;

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  unsigned debug_port() const;
  void set_mapr(std::uint32_t value);

  std::uint32_t mapr_ = 0;
  std::array<std::uint32_t, 4> exticr_{};
};

/// Interrupts of pins 10 to 15, the only ones that the firmware uses. Source: ST RM0008,
/// chapter 10.
class Exti final : public Peripheral {
 public:
  Exti(const Afio& afio, Nvic& nvic) : afio_(afio), nvic_(nvic) {}

  void on_pin(std::uint8_t port, std::uint8_t pin, bool high);

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  void update();

  const Afio& afio_;
  Nvic& nvic_;
  std::uint32_t mask_ = 0;
  std::uint32_t rising_ = 0;
  std::uint32_t falling_ = 0;
  std::uint32_t pending_ = 0;
};

}  // namespace echomap::unicorn
