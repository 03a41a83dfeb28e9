// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"

/// Frames and messages for tests of the protocol.
namespace echomap::protocol {

using Bytes = std::vector<std::uint8_t>;

/// A message on the wire.
template <class M>
Bytes frame_of(const M& message, std::uint8_t seq) {
  FrameEncoder encoder;
  const ByteSpan span = encoder.encode(message, seq);
  return {span.data, span.data + span.size};
}

/// What the decoder says of each frame in `bytes`, kIncomplete left out.
inline std::vector<DecodeStatus> outcomes(FrameDecoder& decoder, const Bytes& bytes) {
  std::vector<DecodeStatus> statuses;
  for (const std::uint8_t byte : bytes) {
    const DecodeStatus status = decoder.take(byte);
    if (status != DecodeStatus::kIncomplete) {
      statuses.push_back(status);
    }
  }
  return statuses;
}

/// The same, by a fresh decoder that knows every message.
inline std::vector<DecodeStatus> outcomes(const Bytes& bytes) {
  FrameDecoder decoder(AllMessages::find_schema);
  return outcomes(decoder, bytes);
}

/// Visitor that fills every field with random bits.
class RandomFillVisitor {
 public:
  explicit RandomFillVisitor(std::mt19937& generator) : generator_(generator) {}
  template <class T>
  void operator()(const char* /*name*/, T& value) {
    value = static_cast<T>(generator_());
  }

 private:
  std::mt19937& generator_;
};

/// A message of random fields.
template <class M>
M random_message(std::mt19937& generator) {
  M message{};
  RandomFillVisitor visitor(generator);
  M::each(message, visitor);
  return message;
}

/// Visitor that collects every field's value.
struct CollectVisitor {
  std::vector<std::int64_t> values;
  template <class T>
  void operator()(const char* /*name*/, const T& value) {
    values.push_back(static_cast<std::int64_t>(value));
  }
};

/// A message's fields in wire order, to compare and to print.
template <class M>
std::vector<std::int64_t> values_of(const M& message) {
  CollectVisitor visitor;
  M::each(message, visitor);
  return visitor.values;
}

}  // namespace echomap::protocol
