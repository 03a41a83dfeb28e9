// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/byte_span.hpp"
#include "protocol/message_codec.hpp"

namespace echomap {
namespace protocol {

/// Largest payload of a message, and the bytes that a frame adds to it:
/// COBS code, id, sequence number, CRC (2), delimiter.
constexpr uint8_t kMaxPayload = 48;
constexpr uint8_t kFrameOverhead = 6;
constexpr uint8_t kMaxFrame = kMaxPayload + kFrameOverhead;

/// Builds frames `COBS(id | seq | payload | crc16) 00` in a buffer of its own.
class FrameEncoder {
 public:
  /// Encodes `message`; the span is valid until the next call.
  template <class M>
  ByteSpan encode(const M& message, uint8_t seq) {
    using Facts = MessageFacts<M>;
    static_assert(Facts::kSize <= kMaxPayload, "payload is larger than a frame takes");
    const Payload<M> payload(message);
    return encode(payload.bytes(), M::kId, Facts::kSize, Facts::kSeed, seq);
  }
  /// The same for a payload of `size` bytes, at most kMaxPayload.
  ByteSpan encode(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed, uint8_t seq);

 private:
  static constexpr uint8_t kHeaderSize = 2;

  uint8_t buffer_[kMaxFrame];
};

}  // namespace protocol
}  // namespace echomap
