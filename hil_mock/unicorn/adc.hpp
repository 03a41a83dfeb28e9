// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// ADC1: one conversion of one channel, started by the program, in 68 cycles of 12 MHz. Source: ST
/// RM0008, chapter 11.
class Adc final : public Peripheral {
 public:
  explicit Adc(EventQueue& queue) : queue_(queue) {}

  /// What a channel of 0 to 9 reads from now on, 0 .. 4095; 0 before the first call.
  void set_input(std::uint8_t channel, std::uint16_t value) { inputs_.at(channel) = value; }

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  void convert();

  EventQueue& queue_;
  std::array<std::uint16_t, 10> inputs_{};
  std::uint32_t sr_ = 0;
  std::uint32_t cr2_ = 0;
  std::uint32_t channel_ = 0;
  std::uint32_t dr_ = 0;
  std::uint32_t conversions_ = 0;
};

}  // namespace echomap::unicorn
