// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/golden_vectors.hpp"

namespace echomap::fuzz {

/// The golden frames as seeds, each alone, and all of them one after the other.
inline std::vector<Input> golden_frames() {
  std::vector<Input> seeds;
  Input all;
  for (const auto& frame : tests::load_golden_vectors().frames) {
    seeds.push_back(frame.bytes);
    all.insert(all.end(), frame.bytes.begin(), frame.bytes.end());
  }
  seeds.push_back(all);
  return seeds;
}

/// Ids of a list's messages, in its order.
template <class List>
struct IdsOf;
template <class... Messages>
struct IdsOf<protocol::MessageList<Messages...>> {
  static constexpr std::array<std::uint8_t, sizeof...(Messages)> kIds{Messages::kId...};
};

/// Makes whole frames with right check sums out of an input, as chance never would.
template <class List>
class FrameMaker {
 public:
  /// The next message of the input: a byte that chooses it, then its payload.
  Input next(Reader& input) {
    const std::uint8_t id = IdsOf<List>::kIds[input.byte() % IdsOf<List>::kIds.size()];
    const Input payload = input.exactly(List::find_schema(id).payload_size);
    const bool known = protocol::Dispatcher<List>::dispatch(id, payload.data(), *this);
    require(known, "a listed message is dispatched");
    return std::exchange(frame_, {});
  }

  template <class M>
  void operator()(const M& message) {
    frame_ = of(message);
  }

  template <class M>
  Input of(const M& message) {
    const protocol::ByteSpan bytes = encoder_.encode(message, seq_++);
    return {bytes.data, bytes.data + bytes.size};
  }

 private:
  protocol::FrameEncoder encoder_;
  std::uint8_t seq_ = 0;
  Input frame_;
};

/// Requires of a message, dispatched from its payload, that it encodes to the same.
struct EncodeAgain {
  std::span<const std::uint8_t> payload;
  template <class M>
  void operator()(const M& message) {
    Input again(protocol::MessageFacts<M>::kSize);
    put_payload(message, again.data());
    require(std::equal(again.begin(), again.end(), payload.begin(), payload.end()),
            "what is decoded encodes to the same");
  }
};

/// Hears what one side sends and requires that every byte of it belongs to a good frame.
template <class List>
class StrictEar {
 public:
  void hear(std::uint8_t byte) {
    const protocol::DecodeStatus status = decoder_.take(byte);
    require(!protocol::FrameDecoder::is_error(status), "what is sent are good frames");
    frames_ += status == protocol::DecodeStatus::kFrame ? 1 : 0;
  }
  std::size_t frames() const { return frames_; }

 private:
  protocol::FrameDecoder decoder_{List::find_schema};
  std::size_t frames_ = 0;
};

}  // namespace echomap::fuzz
