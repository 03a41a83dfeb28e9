// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// AFIO: which pins the debug port has, where channels 1 and 2 of TIM2 are, and of which port the
/// lines of EXTI are. Source: ST RM0008,
/// section 9.4.
class Afio final : public Peripheral {
 public:
  /// Channels 1 and 2, instead of on A0 and A1.
  bool tim2_is_on_a15_and_b3() const;
  /// Which pins are JTAG's and no program's: bits of port A (A15) and of port B (B3, B4). All are
  /// from a reset on.
  std::uint32_t jtag_pins_of_a() const;
  std::uint32_t jtag_pins_of_b() const;
  /// Number of the port, A is 0, whose pin `line` is the one that EXTI's line looks at.
  unsigned port_of_line(std::uint8_t line) const;
  /// Called when those of the debug port and of TIM2 may have changed.
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

}  // namespace echomap::unicorn
