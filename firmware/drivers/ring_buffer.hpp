// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// Bytes from one producer to one consumer, of which one may be an interrupt: each side writes only
/// its own index, and a byte index is read in one instruction, so neither needs a lock.
template <uint8_t kSize>
class RingBuffer {
  static_assert(kSize <= 128 && (kSize & (kSize - 1)) == 0, "free-running indices need this");

 public:
  /// False when full: the byte is not taken.
  bool push(uint8_t byte) {
    const uint8_t head = head_;
    if (static_cast<uint8_t>(head - tail_) == kSize) {
      return false;
    }
    bytes_[head & (kSize - 1)] = byte;
    head_ = static_cast<uint8_t>(head + 1);
    return true;
  }

  /// False when empty.
  bool pop(uint8_t& byte) {
    const uint8_t tail = tail_;
    if (tail == head_) {
      return false;
    }
    byte = bytes_[tail & (kSize - 1)];
    tail_ = static_cast<uint8_t>(tail + 1);
    return true;
  }

  uint8_t size() const { return static_cast<uint8_t>(head_ - tail_); }
  uint8_t room() const { return static_cast<uint8_t>(kSize - size()); }

 private:
  volatile uint8_t bytes_[kSize] = {};
  volatile uint8_t head_ = 0;
  volatile uint8_t tail_ = 0;
};

}  // namespace drivers
}  // namespace echomap
