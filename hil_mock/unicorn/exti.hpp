// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// EXTI: a line for each number of a pin, which latches the edges it is told to and interrupts
/// until the program clears it. Lines 16 and above, of other parts, are missing. Source: ST RM0008,
/// section 10.3.
class Exti final : public Peripheral {
 public:
  explicit Exti(Nvic& nvic) : nvic_(nvic) {}

  /// The pin of this line has changed.
  void take_edge(std::uint8_t line, bool high);

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  void tell_nvic();

  Nvic& nvic_;
  std::uint32_t enabled_ = 0;
  std::uint32_t rising_ = 0;
  std::uint32_t falling_ = 0;
  std::uint32_t pending_ = 0;
};

}  // namespace echomap::unicorn
