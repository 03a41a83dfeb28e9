// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace echomap::unicorn {

/// Number of an exception: 15 is SysTick, 16 and up are the interrupt lines of the chip.
using Exception = std::uint8_t;

/// Which exceptions wait, which are served, and which comes next. Source: ARM DDI 0403 (ARMv7-M),
/// B1.5; priorities are of four bits, all of them for preemption.
class Nvic {
 public:
  static constexpr Exception kSysTick = 15;
  static constexpr Exception kFirstLine = 16;

  /// What the CPU's mask registers say.
  struct Masks {
    bool primask = false;
    std::uint8_t basepri = 0;
  };

  /// Level of interrupt line `line`: it waits from its rise on, and again while it stays high.
  void set_line(std::uint8_t line, bool high);
  void pend_sys_tick() { pending_[kSysTick] = true; }
  bool sys_tick_pends() const { return pending_[kSysTick]; }

  /// Whether anything waits that may be due when the masks allow it.
  bool has_pending() const { return pending_.any(); }
  /// The exception that interrupts what runs now; empty where nothing may.
  std::optional<Exception> next(Masks masks) const;
  /// Whether WFI wakes: PRIMASK does not hold it back.
  bool wakes(std::uint8_t basepri) const { return next({false, basepri}).has_value(); }

  /// The CPU begins and ends to serve an exception.
  void enter(Exception exception);
  void leave();

  /// Registers from 0xE000E100 (ISER .. IPR) and the priority of SysTick.
  std::uint32_t read(std::uint32_t address) const;
  void write(std::uint32_t address, std::uint32_t value);
  void reset() { *this = Nvic(); }

 private:
  static constexpr std::size_t kExceptions = 16 + 64;
  using Flags = std::bitset<kExceptions>;
  static constexpr std::uint16_t kThreadPriority = 0x100;

  std::uint16_t running_priority() const;
  std::uint32_t word_of(const Flags& flags, std::uint32_t word) const;
  void pend(Exception exception, bool pends);

  Flags enabled_;
  Flags pending_;
  Flags high_;
  std::array<std::uint8_t, kExceptions> priority_{};
  std::vector<Exception> served_;
};

}  // namespace echomap::unicorn
