// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "hil_mock/unicorn/event_queue.hpp"
#include "hil_mock/unicorn/nvic.hpp"
#include "hil_mock/unicorn/peripheral.hpp"
#include "hil_mock/world/two_wire_device.hpp"

namespace echomap::unicorn {

/// I2C2 as a master of 7-bit addresses, at most one device on its bus. A byte takes nine bits by
/// CCR; the bus waits where the program does. A program that acknowledges a byte too many lets the
/// device speak on, so that no STOP gets through. Source: ST RM0008, chapter 26.
class I2c final : public Peripheral {
 public:
  I2c(EventQueue& queue, Nvic& nvic) : queue_(queue), nvic_(nvic) {}

  /// Puts a device on the bus; it must outlive this.
  void connect(world::TwoWireDevice& device) { device_ = &device; }
  /// Whether both pins are the unit's; without them nothing moves.
  std::function<bool()> has_pins;
  /// While the bus is held, nothing that is begun on it ends.
  void hold(bool held) { held_ = held; }

  std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void reset() override;

 private:
  void write_control(std::uint32_t value);
  void write_data(std::uint8_t byte);
  std::uint32_t read_data();
  std::uint32_t read_status2();

  std::uint64_t bit_cycles() const;
  /// Calls `step` after so many bits, unless the unit was reset or switched off in between.
  void after(unsigned bits, std::function<void()> step);
  void start();
  void stop();
  void end_address(std::uint8_t byte);
  void begin_sending(std::uint8_t byte);
  void end_sending(std::uint8_t byte);
  void begin_receiving();
  void end_receiving();
  bool sends() const;
  void update();

  EventQueue& queue_;
  Nvic& nvic_;
  world::TwoWireDevice* device_ = nullptr;
  std::uint32_t cr1_ = 0;
  std::uint32_t cr2_ = 0;
  std::uint32_t ccr_ = 0;
  std::uint32_t trise_ = 0;
  std::uint32_t sr1_ = 0;
  std::uint32_t sr2_ = 0;
  std::uint32_t seen_ = 0;  ///< Flags of SR1 that were read since.
  std::uint8_t data_ = 0;
  std::uint8_t shifted_ = 0;             ///< Received, while `data_` is not read.
  std::optional<std::uint8_t> to_send_;  ///< Behind the one under way.
  bool sending_ = false;
  bool register_is_next_ = false;  ///< Of the device: its first byte says which.
  std::uint8_t register_ = 0;
  bool acknowledges_next_ = false;  ///< What ACK said when the byte before ended.
  bool device_speaks_ = false;
  std::uint32_t transfers_ = 0;
  bool held_ = false;
};

}  // namespace echomap::unicorn
