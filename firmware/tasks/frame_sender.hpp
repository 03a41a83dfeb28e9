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
  template <class M>
  struct FrameFacts {
    enum : uint8_t { kBytes = protocol::MessageFacts<M>::kSize + protocol::kFrameOverhead };
  };
  /// Room that telemetry leaves: a HelloReply after its delimiter, an Ack and a Pong.
  enum : uint8_t {
    kAnswerBytes = 1 + FrameFacts<protocol::HelloReply>::kBytes +
                   FrameFacts<protocol::Ack>::kBytes + FrameFacts<protocol::Pong>::kBytes
  };

  template <class M>
  bool send(const M& message, uint8_t reserve) {
    using Facts = protocol::MessageFacts<M>;
    static_assert(Facts::kSize <= protocol::kMaxPayload, "payload is larger than a frame takes");
    const protocol::Payload<M> payload(message);
    return send(payload.bytes(), M::kId, Facts::kSize, Facts::kSeed, reserve);
  }
  bool send(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed, uint8_t reserve);

  drivers::SerialPort& port_;
  protocol::FrameEncoder encoder_;
  uint8_t seq_ = 0;
};

}  // namespace tasks
}  // namespace echomap
