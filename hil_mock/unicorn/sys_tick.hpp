// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// SysTick on the core's clock: counts down from LOAD to 0 and begins again. Source: ARM DDI 0403,
/// B3.3. COUNTFLAG is not modelled.
class SysTick final : public Peripheral {
 public:
  SysTick(EventQueue& queue, Nvic& nvic) : queue_(queue), nvic_(nvic) {}

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  bool runs() const { return (ctrl_ & 1U) != 0 && load_ != 0; }
  void begin_round(std::uint64_t cycle);

  EventQueue& queue_;
  Nvic& nvic_;
  std::uint32_t ctrl_ = 0;
  std::uint32_t load_ = 0;
  std::uint64_t round_start_ = 0;
  std::uint32_t rounds_ = 0;  ///< Distinguishes the event of this round from one called off.
};

}  // namespace echomap::unicorn
