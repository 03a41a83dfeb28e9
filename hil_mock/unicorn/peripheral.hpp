// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

namespace echomap::unicorn {

/// A block of registers of the chip, each of 32 bits.
class Peripheral {
 public:
  virtual ~Peripheral() = default;

  /// Reads the register at `offset` from the block's start; may change what the chip does.
  virtual std::uint32_t read(std::uint32_t offset) = 0;
  virtual void write(std::uint32_t offset, std::uint32_t value) = 0;
  /// The chip was reset: every register has its first value.
  virtual void reset() = 0;
};

/// The word with this one bit set.
constexpr std::uint32_t bit(unsigned number) { return std::uint32_t{1} << number; }

}  // namespace echomap::unicorn
