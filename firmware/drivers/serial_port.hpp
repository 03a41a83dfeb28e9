// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/ring_buffer.hpp"
#include "protocol/byte_span.hpp"

namespace echomap {
namespace drivers {

/// The serial port behind its two ring buffers; nothing here waits.
class SerialPort {
 public:
  static constexpr uint8_t kReceiveBytes = 128;
  static constexpr uint8_t kSendBytes = 128;

  /// Queues all of `bytes`, or none and answers false.
  bool send(protocol::ByteSpan bytes);
  /// Bytes that `send` would take now.
  uint8_t send_room() const { return sending_.room(); }

  /// The next received byte; false when there is none.
  bool receive(uint8_t& byte) { return received_.pop(byte); }
  bool has_received() const { return received_.size() != 0; }
  /// Received bytes that were lost, in the port or for want of room.
  uint16_t overruns() const;

  /// From the port's interrupts.
  void on_received(uint8_t byte) {
    if (!received_.push(byte)) {
      on_overrun();
    }
  }
  void on_overrun() { ++overruns_; }
  bool on_send_ready(uint8_t& byte) { return sending_.pop(byte); }

 private:
  RingBuffer<kReceiveBytes> received_;
  RingBuffer<kSendBytes> sending_;
  uint16_t overruns_ = 0;
};

}  // namespace drivers
}  // namespace echomap
