// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/serial_port.hpp"
#include "firmware/tasks/line_budget.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"

namespace echomap {
namespace tasks {

/// Numbers, frames and queues messages. All but answers leave room in the queue for an answer, and
/// answers beyond their share of the line leave room for telemetry, so that one is lost only when
/// the host asks faster than the line can tell, and no such host takes telemetry's place.
class FrameSender {
 public:
  constexpr explicit FrameSender(drivers::SerialPort& port) : port_(port) {}

  /// Queues an answer to the host; false when there is no room. The host asks again.
  template <class M>
  bool answer(const M& message) {
    using Facts = protocol::MessageFacts<M>;
    static_assert(Facts::kSize <= protocol::kMaxPayload, "payload is larger than a frame takes");
    const protocol::Payload<M> payload(message);
    return answer(payload.bytes(), M::kId, Facts::kSize, Facts::kSeed);
  }

  /// Queues telemetry; false when there is no room now or the budget does not allow it.
  template <class M>
  bool tell(const M& message) {
    using Facts = protocol::MessageFacts<M>;
    const protocol::Payload<M> payload(message);
    return tell(payload.bytes(), M::kId, Facts::kSize, Facts::kSeed);
  }

  /// Queues what telemetry and answers leave room for; false when they do not.
  template <class M>
  bool fill_in(const M& message) {
    using Facts = protocol::MessageFacts<M>;
    const protocol::Payload<M> payload(message);
    return has_room_for<M>() && send(payload.bytes(), M::kId, Facts::kSize, Facts::kSeed);
  }

  /// True when M can be queued and leave room for answers.
  template <class M>
  bool has_room_for() const {
    return has_room(FrameFacts<M>::kBytes);
  }

  LineBudget& budget() { return budget_; }
  const LineBudget& budget() const { return budget_; }

  /// Ends whatever piece of a frame the host may have, so that the next frame stands alone.
  void delimit();

 private:
  template <class M>
  struct FrameFacts {
    enum : uint8_t { kBytes = protocol::MessageFacts<M>::kSize + protocol::kFrameOverhead };
  };
  /// Room that is left for answers: a HelloReply after its delimiter, an Ack and a Pong.
  enum : uint8_t {
    kAnswerBytes = 1 + FrameFacts<protocol::HelloReply>::kBytes +
                   FrameFacts<protocol::Ack>::kBytes + FrameFacts<protocol::Pong>::kBytes,
    /// The largest telemetry.
    kTelemetryBytes = FrameFacts<protocol::Ranges>::kBytes
  };

  bool has_room(uint8_t frame_bytes) const {
    return port_.send_room() >= frame_bytes + kAnswerBytes;
  }
  bool answer(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed);
  bool tell(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed);
  bool send(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed);

  drivers::SerialPort& port_;
  LineBudget budget_;
  uint8_t seq_ = 0;
};

}  // namespace tasks
}  // namespace echomap
