// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/peripheral.hpp"

namespace echomap::unicorn {

/// What pulled the chip's reset; the last three come from the program itself.
enum class ResetSource : std::uint8_t {
  kPowerOn,   ///< Supply off and on: RAM is lost.
  kExternal,  ///< The reset pin: RAM stays.
  kWatchdog,
  kWindowWatchdog,
  kSoftware,  ///< SYSRESETREQ of the core.
};

/// Clocks: what is switched on becomes ready after its time, and a peripheral without its clock
/// does not answer. Source: ST RM0008, chapter 7. The CPU runs at 72 MHz from the start.
class Rcc final : public Peripheral {
 public:
  /// The bus whose register switches a peripheral's clock on.
  enum class Bus : std::uint8_t { kAlwaysOn, kApb1, kApb2 };

  explicit Rcc(EventQueue& queue) : queue_(queue) {}

  /// Cycles of 72 MHz in one of the CPU.
  unsigned cpu_cycle() const;
  bool clocks(Bus bus, std::uint8_t number) const;
  /// Adds the cause of a reset to CSR; the pin is pulled by every one of them.
  void note_reset(ResetSource source);

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  void write_cfgr(std::uint32_t value);
  void make_ready(std::uint32_t on, std::uint32_t ready, std::uint64_t after_cycles);

  EventQueue& queue_;
  std::uint32_t cr_ = 0;
  std::uint32_t cfgr_ = 0;
  std::uint32_t apb2_enabled_ = 0;
  std::uint32_t apb1_enabled_ = 0;
  std::uint32_t csr_ = 0;
};

}  // namespace echomap::unicorn
