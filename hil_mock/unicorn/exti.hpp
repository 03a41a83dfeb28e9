// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// AFIO: which port each EXTI line looks at; the remapping of timers is only kept. Source: ST
/// RM0008, section 9.4.
class Afio final : public Peripheral {
 public:
  bool listens_to(std::uint8_t port, std::uint8_t pin) const {
    return (exticr_[pin / 4] >> (pin % 4 * 4) & 0xFU) == port;
  }
  std::uint32_t remapping() const { return mapr_; }

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
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
