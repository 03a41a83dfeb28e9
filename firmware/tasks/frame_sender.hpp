// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/serial_port.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"

namespace echomap {
namespace tasks {

/// Numbers, frames and queues messages. Telemetry leaves room in the queue for an answer, so that
/// an answer is lost only when the host asks faster than the line can tell.
class FrameSender {
 public:
  constexpr explicit FrameSender(drivers::SerialPort& port) : port_(port) {}

  /// Queues an answer to the host; false when there is no room.
  template <class M>
  bool answer(const M& message) {
    return send(message, 0);
  }

  /// Queues telemetry; false when there is no room now.
  template <class M>
  bool tell(const M& message) {
    return send(message, kAnswerBytes);
  }

  /// Ends whatever piece of a frame the host may have, so that the next frame stands alone.
  void delimit();

 private:
  /// A HelloReply and its delimiter, an Ack and a Pong.
  static constexpr uint8_t kAnswerBytes = 51;

  template <class M>
  bool send(const M& message, uint8_t reserve) {
    constexpr uint8_t kFrameBytes = protocol::MessageFacts<M>::kSize + protocol::kFrameOverhead;
    if (port_.send_room() < kFrameBytes + reserve) {
      return false;
    }
    return port_.send(encoder_.encode(message, seq_++));
  }

  drivers::SerialPort& port_;
  protocol::FrameEncoder encoder_;
  uint8_t seq_ = 0;
};

}  // namespace tasks
}  // namespace echomap
