// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "hil_mock/unicorn/peripheral.hpp"
#include "hil_mock/world/pin_signal.hpp"

namespace echomap::unicorn {

/// A port of 16 pins. Source: ST RM0008, chapter 9. What the outside puts on a pin stays through a
/// reset; an input that nobody drives follows its pull-up or pull-down, a floating one is low.
class GpioPort final : public Peripheral {
 public:
  /// Called when the level of a pin has changed.
  std::function<void(std::uint8_t pin, bool high)> on_change;

  /// Drives an input from outside, from now on.
  void drive(std::uint8_t pin, bool high);
  /// Takes these pins, bit by bit, from the program: what it writes for them has no effect, and it
  /// reads them low.
  void take_away(std::uint32_t pins);

  bool level(std::uint8_t pin) const { return (levels() & bit(pin)) != 0; }
  /// Whether a timer or the USART has the pin.
  bool is_alternate(std::uint8_t pin) const { return drives(pin) && (mode(pin) & 8U) != 0; }
  /// What the program itself puts on the pin: of one that JTAG has, the debug port's pull-up, of
  /// one that a timer has, low.
  world::PinSignal signal(std::uint8_t pin) const;
  /// Whether the program itself drives the pin high: no pull-up does.
  bool is_driven_high(std::uint8_t pin) const {
    return drives(pin) && !is_alternate(pin) && level(pin);
  }

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  unsigned mode(std::uint8_t pin) const;
  bool drives(std::uint8_t pin) const { return (mode(pin) & 3U) != 0 && !is_taken(pin); }
  bool is_taken(std::uint8_t pin) const { return (taken_ & bit(pin)) != 0; }
  std::uint32_t levels() const;
  bool level_of(std::uint8_t pin) const;
  void set_output(std::uint32_t value);
  void report_changes();

  std::uint32_t configuration_[2]{};
  std::uint32_t output_ = 0;
  std::uint32_t taken_ = 0;
  std::uint32_t driven_ = 0;
  std::uint32_t driven_levels_ = 0;
  std::uint32_t reported_ = 0;
};

}  // namespace echomap::unicorn
