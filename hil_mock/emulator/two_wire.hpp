// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <avr_twi.h>
#include <cstdint>
#include <sim_avr.h>

#include "hil_mock/emulator/cycle_queue.hpp"
#include "hil_mock/emulator/register_hooks.hpp"
#include "hil_mock/world/two_wire_device.hpp"

namespace echomap::emulator {

/// The two-wire interface as master on a bus with at most one device, in place of simavr's: that
/// one answers SLA+W with the status of data, takes a microsecond for any byte, and its TWINT
/// cannot be polled. Ours follows the ATmega328P data sheet, section 22.7, tables 22-2 and 22-3, at
/// the speed of TWBR. The device has registers: the first byte written names one, and they count
/// up.
class TwoWire {
 public:
  TwoWire(avr_t& avr, RegisterHooks& hooks, CycleQueue& queue);

  /// Puts a device on the bus; it must outlive this.
  void connect(world::TwoWireDevice& device) { device_ = &device; }

  /// While the bus is held, nothing that is begun on it ends.
  void hold(bool held) { held_ = held; }

  /// The chip was reset: the transfer is over.
  void reset();

 private:
  /// Who speaks next on the bus.
  enum class Phase : std::uint8_t { kIdle, kAddress, kRegister, kWrite, kRead, kRefused };

  void write_control(std::uint8_t value);
  void begin(std::uint8_t control);
  void begin_start();
  void begin_stop();
  void begin_address(std::uint8_t address_byte);
  void begin_write(std::uint8_t byte);
  void begin_read(bool acknowledge);
  void end_after(unsigned bits, std::uint8_t status);
  void set_status(std::uint8_t status);
  std::uint64_t bit_cycles() const;

  avr_t& avr_;
  avr_twi_t& twi_;
  CycleQueue& queue_;
  world::TwoWireDevice* device_ = nullptr;
  bool held_ = false;
  Phase phase_ = Phase::kIdle;
  std::uint8_t device_register_ = 0;
  std::uint64_t free_cycle_ = 0;  ///< When the bus has done what it was last told.
  std::uint32_t transfer_ = 0;    ///< Counts what was begun, so that what was given up stays so.
};

}  // namespace echomap::emulator
