// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace differential {

/// Kinds of output, so that equal numbers of two kinds differ.
enum class Output : uint8_t {
  kByteSent,
  kMotor,
  kMotorStop,
  kBridge,
  kServo,
  kTrigger,
  kPinUse,
  kPinLevel,
  kConversion,
  kTwoWire,
};

/// All outputs so far in two sums (Fletcher's checksum, modulo 2^32): once one differs, every later
/// state does. Cheap on a chip of 8 bits.
struct Trace {
  uint32_t sum;
  uint32_t sum_of_sums;

  void add(Output kind, uint16_t value) {
    sum += ((static_cast<uint32_t>(kind) << 16) | value) + 1U;
    sum_of_sums += sum;
  }
};

}  // namespace differential
}  // namespace echomap
