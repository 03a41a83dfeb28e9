// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <sim_avr.h>

namespace echomap::emulator {

/// Puts functions in the way of the program's accesses to I/O registers, over or instead of
/// simavr's own. Addresses are those of the data space.
class RegisterHooks {
 public:
  /// `avr` must not run any more once the hooks are gone.
  explicit RegisterHooks(avr_t& avr) : avr_(avr) {}
  RegisterHooks(const RegisterHooks&) = delete;
  RegisterHooks& operator=(const RegisterHooks&) = delete;

  /// Calls `hook` after simavr has handled a write.
  void after_write(std::uint16_t address, std::function<void()> hook);
  /// Calls `hook` instead of simavr's handler; it stores the register's new value itself.
  void replace_write(std::uint16_t address, std::function<void(std::uint8_t)> hook);
  /// Calls `hook` instead of simavr's handler; the program reads what it returns.
  void replace_read(std::uint16_t address, std::function<std::uint8_t()> hook);

 private:
  struct AfterWrite {
    avr_io_write_t inner;
    void* inner_param;
    std::function<void()> hook;
  };

  avr_t& avr_;
  std::deque<AfterWrite> after_writes_;
  std::deque<std::function<void(std::uint8_t)>> writes_;
  std::deque<std::function<std::uint8_t()>> reads_;
};

}  // namespace echomap::emulator
