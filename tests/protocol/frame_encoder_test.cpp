// SPDX-License-Identifier: MIT
#include "protocol/frame_encoder.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/protocol/every_message.hpp"
#include "tests/protocol/frames.hpp"

namespace echomap::protocol {
namespace {

template <class M>
class FrameEncoderOf : public testing::Test {};
TYPED_TEST_SUITE(FrameEncoderOf, TestTypes<AllMessages>::Types, MessageNames);

TYPED_TEST(FrameEncoderOf, AddsTheOverheadAndPutsTheOnlyZeroAtTheEnd) {
  std::mt19937 generator(TypeParam::kId);
  for (int i = 0; i < 200; ++i) {
    const Bytes frame = frame_of(random_message<TypeParam>(generator), 0);
    ASSERT_EQ(frame.size(), std::size_t{MessageFacts<TypeParam>::kSize} + kFrameOverhead);
    ASSERT_EQ(std::find(frame.begin(), frame.end(), 0), frame.end() - 1);
  }
}

TYPED_TEST(FrameEncoderOf, MakesFramesThatTheDecoderTakesBack) {
  std::mt19937 generator(TypeParam::kId);
  FrameDecoder decoder(AllMessages::find_schema);
  for (int i = 0; i < 200; ++i) {
    const auto message = random_message<TypeParam>(generator);
    const auto seq = static_cast<std::uint8_t>(i);
    ASSERT_EQ(outcomes(decoder, frame_of(message, seq)), std::vector{DecodeStatus::kFrame});
    const Frame frame = decoder.frame();
    ASSERT_EQ(frame.id, TypeParam::kId);
    ASSERT_EQ(frame.seq, seq);
    ASSERT_EQ(frame.payload_size, unsigned{MessageFacts<TypeParam>::kSize});
    ASSERT_EQ(values_of(get_payload<TypeParam>(frame.payload)), values_of(message));
  }
}

TEST(FrameEncoder, ForgetsTheFrameBefore) {
  FrameEncoder encoder;
  encoder.encode(Pong{0xFFFFFFFF, 0xFFFFFFFF}, 1);
  const ByteSpan span = encoder.encode(Stop{17}, 2);
  EXPECT_EQ(Bytes(span.data, span.data + span.size), frame_of(Stop{17}, 2));
}

}  // namespace
}  // namespace echomap::protocol
