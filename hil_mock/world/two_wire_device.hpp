// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace echomap::world {

/// A device with registers on a two-wire bus (I2C).
class TwoWireDevice {
 public:
  virtual ~TwoWireDevice() = default;

  /// Its 7-bit address.
  virtual std::uint8_t address() const = 0;
  virtual void write(std::uint8_t device_register, std::uint8_t value) = 0;
  /// Reading may latch: read registers in the order in which the bus asks for them.
  virtual std::uint8_t read(std::uint8_t device_register) = 0;
};

}  // namespace echomap::world
