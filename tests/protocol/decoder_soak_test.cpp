// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/frame_decoder.hpp"
#include "protocol/message_codec.hpp"
#include "tests/protocol/frames.hpp"
#include "tests/support/golden_vectors.hpp"

// A million bytes of noise in every run; ECHOMAP_SOAK=1 makes it a hundred million, meant for a
// build with sanitizers.
namespace echomap::protocol {
namespace {

std::uint64_t bytes_to_push() {
  return std::getenv("ECHOMAP_SOAK") != nullptr ? 100'000'000 : 1'000'000;
}

/// Decodes every kind of message from the same noise. Each payload has a heap block of exactly its
/// size, so that a sanitizer sees the first byte read or written beyond it.
class DecodeAnyMessage {
 public:
  explicit DecodeAnyMessage(const Bytes& noise) : noise_(noise) {}

  template <class M>
  void operator()(const M* /*tag*/) {
    constexpr std::size_t kSize = MessageFacts<M>::kSize;
    const auto payload = std::make_unique<std::uint8_t[]>(kSize);
    std::copy_n(noise_.begin(), kSize, payload.get());
    const auto again = std::make_unique<std::uint8_t[]>(kSize);
    put_payload(get_payload<M>(payload.get()), again.get());
    same_ = same_ && std::equal(payload.get(), payload.get() + kSize, again.get());
  }

  bool all_came_back() const { return same_; }

 private:
  const Bytes& noise_;
  bool same_ = true;
};

class Noise {
 public:
  explicit Noise(unsigned seed) : generator_(seed), golden_(tests::load_golden_vectors().frames) {}

  /// 64 random bytes, the zero as often as any other or once in eight.
  Bytes bytes() {
    Bytes noise(64);
    const bool many_zeros = generator_() % 2 == 0;
    for (std::uint8_t& byte : noise) {
      byte = many_zeros && generator_() % 8 == 0 ? 0 : static_cast<std::uint8_t>(generator_());
    }
    return noise;
  }

  const Bytes& golden_frame() { return golden_[generator_() % golden_.size()].bytes; }

  /// `frame` after one to four bytes of it were changed, lost or doubled.
  Bytes mutated(Bytes frame) {
    for (auto faults = 1 + generator_() % 4; faults > 0; --faults) {
      const auto at = frame.begin() + static_cast<std::ptrdiff_t>(generator_() % frame.size());
      switch (generator_() % 3) {
        case 0:
          *at = static_cast<std::uint8_t>(generator_());
          break;
        case 1:
          frame.erase(at);
          break;
        default:
          frame.insert(at, std::uint8_t{*at});
      }
    }
    return frame;
  }

 private:
  std::mt19937 generator_;
  std::vector<tests::GoldenFrame> golden_;
};

struct IgnoreMessage {
  template <class M>
  void operator()(const M& /*message*/) {}
};

/// Pushes bytes; each frame that comes out must be one that the list knows. The id, sequence number
/// and payload of the last one; empty where none came out.
Bytes last_frame_in(FrameDecoder& decoder, const Bytes& bytes) {
  Bytes content;
  IgnoreMessage ignore;
  for (const std::uint8_t byte : bytes) {
    if (decoder.take(byte) == DecodeStatus::kFrame) {
      const Frame frame = decoder.frame();
      EXPECT_TRUE(Dispatcher<AllMessages>::dispatch(frame.id, frame.payload, ignore));
      content = {frame.id, frame.seq};
      content.insert(content.end(), frame.payload, frame.payload + frame.payload_size);
    }
  }
  return content;
}

TEST(DecoderSoak, NoNoiseBreaksTheDecoderOrAMessage) {
  Noise noise(5);
  FrameDecoder decoder(AllMessages::find_schema);
  const std::uint64_t wanted = bytes_to_push();
  std::uint64_t frames = 0;
  for (std::uint64_t pushed = 0; pushed < wanted;) {
    const Bytes bytes = noise.bytes();
    DecodeAnyMessage decode(bytes);
    AllMessages::for_each(decode);
    ASSERT_TRUE(decode.all_came_back());
    frames += last_frame_in(decoder, bytes).empty() ? 0 : 1;
    pushed += bytes.size();
  }
  RecordProperty("bytes", std::to_string(wanted));
  RecordProperty("frames", std::to_string(frames));
  // A frame out of noise needs its id, its length and its CRC right at once.
  EXPECT_LE(frames, 1 + wanted / 10'000'000);
}

TEST(DecoderSoak, MutatedFramesPassNoOftenerThanTheCrcLetsThem) {
  Noise noise(6);
  FrameDecoder decoder(AllMessages::find_schema);
  const std::uint64_t wanted = bytes_to_push();
  std::uint64_t mutations = 0;
  std::uint64_t wrong = 0;
  for (std::uint64_t pushed = 0; pushed < wanted; ++mutations) {
    const Bytes& golden = noise.golden_frame();
    const Bytes expected = last_frame_in(decoder, golden);
    ASSERT_FALSE(expected.empty());
    Bytes bytes = noise.mutated(golden);
    bytes.push_back(0);
    const Bytes content = last_frame_in(decoder, bytes);
    wrong += content.empty() || content == expected ? 0 : 1;
    pushed += bytes.size();
  }
  RecordProperty("mutations", std::to_string(mutations));
  RecordProperty("wrong", std::to_string(wrong));
  // A CRC of 16 bits lets one in 65,536 pass; small numbers scatter.
  EXPECT_LE(wrong, 10 + 2 * mutations / 65'536);
}

}  // namespace
}  // namespace echomap::protocol
