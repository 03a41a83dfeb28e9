// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include <unicorn/unicorn.h>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/nvic.hpp"

namespace echomap::unicorn {

/// A Cortex-M3: Unicorn's instructions with our exceptions, for Unicorn has neither NVIC nor
/// exception entry. Time goes on by the same number of cycles for each half-word of code, counted
/// block by block, whatever the instruction.
class CortexCore {
 public:
  /// What is behind an address that is no memory. `size` is 1, 2 or 4.
  struct Device {
    std::function<std::uint32_t(std::uint32_t address, unsigned size)> read;
    std::function<void(std::uint32_t address, unsigned size, std::uint32_t value)> write;
    std::uint32_t base = 0;  ///< Set by map_device.
  };

  /// All must outlive the core. Throws std::runtime_error where Unicorn refuses.
  CortexCore(EventQueue& queue, Nvic& nvic);
  CortexCore(const CortexCore&) = delete;
  CortexCore& operator=(const CortexCore&) = delete;

  void map_rom(std::uint32_t address, std::uint32_t bytes);
  void map_ram(std::uint32_t address, std::uint32_t bytes);
  /// `device` must outlive the core.
  void map_device(std::uint32_t address, std::uint32_t bytes, Device& device);
  void write_memory(std::uint32_t address, std::span<const std::uint8_t> bytes);

  /// Starts at the reset vector with the stack that stands before it.
  void reset();
  /// Runs, sleeps and serves exceptions until `now` is at or past `cycle`, or until
  /// `interrupt` was called. Throws std::runtime_error where the program has crashed.
  void run_to(std::uint64_t cycle);
  /// Makes `run_to` return before the next block.
  void interrupt() { interrupted_ = true; }

  /// Called when an exception has been entered, before its first instruction.
  std::function<void(Exception exception)> on_enter;
  /// Cycles that the core has slept through, since the beginning.
  std::uint64_t slept_cycles() const { return slept_cycles_; }

  /// Cycles of the event queue that a half-word of code takes.
  void set_half_word_cycles(unsigned cycles) { half_word_cycles_ = cycles; }

  std::uint32_t program_counter() const;
  /// Lets the core go on at `address`, as if it had jumped there.
  void jump_to(std::uint32_t address);

 private:
  struct Close {
    void operator()(uc_engine* engine) const { uc_close(engine); }
  };

  static void on_block(uc_engine* engine, std::uint64_t address, std::uint32_t size, void* core);
  static void on_exception(uc_engine* engine, std::uint32_t number, void* core);

  std::uint32_t get(int name) const;
  void set(int name, std::uint32_t value);
  Nvic::Masks masks() const;
  bool must_stop() const;
  bool serve_exception();
  void enter(Exception exception);
  void leave();
  void sleep();
  void execute();
  [[noreturn]] void crash(const std::string& why) const;

  EventQueue& queue_;
  Nvic& nvic_;
  std::unique_ptr<uc_engine, Close> engine_;
  std::uint64_t until_ = 0;
  std::uint64_t slept_cycles_ = 0;
  unsigned half_word_cycles_ = 1;
  bool sleeping_ = false;
  bool interrupted_ = false;
  bool stopped_ = false;  ///< By ourselves, and not by WFI.
  bool returning_ = false;
  int fault_ = 0;
};

}  // namespace echomap::unicorn
