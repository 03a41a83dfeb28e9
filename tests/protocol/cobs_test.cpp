// SPDX-License-Identifier: MIT
#include "protocol/cobs.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::protocol {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The block stuffed, without its delimiter.
Bytes stuffed(const Bytes& block) {
  Bytes buffer(block.size() + 1, 0xAA);
  std::copy(block.begin(), block.end(), buffer.begin() + 1);
  cobs_encode_in_place(buffer.data(), static_cast<std::uint8_t>(block.size()));
  return buffer;
}

/// What the decoder makes of stuffed bytes and a delimiter; empty where it says kTruncated.
std::optional<Bytes> unstuffed(const Bytes& bytes, CobsDecoder& decoder) {
  Bytes block;
  std::uint8_t value = 0;
  for (const std::uint8_t byte : bytes) {
    if (decoder.take(byte, value) == CobsStatus::kData) {
      block.push_back(value);
    }
  }
  return decoder.take(0, value) == CobsStatus::kEnd ? std::optional(block) : std::nullopt;
}

std::optional<Bytes> unstuffed(const Bytes& bytes) {
  CobsDecoder decoder;
  return unstuffed(bytes, decoder);
}

Bytes counting(int first, int last) {
  Bytes bytes(static_cast<std::size_t>(last - first + 1));
  std::iota(bytes.begin(), bytes.end(), static_cast<std::uint8_t>(first));
  return bytes;
}

Bytes joined(const Bytes& left, const Bytes& right) {
  Bytes bytes(left.size() + right.size());
  std::copy(right.begin(), right.end(), std::copy(left.begin(), left.end(), bytes.begin()));
  return bytes;
}

Bytes random_block(std::mt19937& generator) {
  Bytes block(generator() % 254);
  const unsigned alphabet = 1 + generator() % 256;
  for (std::uint8_t& byte : block) {
    byte = static_cast<std::uint8_t>(generator() % alphabet);
  }
  return block;
}

struct Example {
  Bytes block;
  Bytes wire;
};

TEST(Cobs, StuffsTheIpHeaderOfThePaper) {
  const Bytes block{0x45, 0x00, 0x00, 0x2C, 0x4C, 0x79, 0x00, 0x00, 0x40, 0x06, 0x4F, 0x37};
  const Bytes wire{0x02, 0x45, 0x01, 0x04, 0x2C, 0x4C, 0x79, 0x01, 0x05, 0x40, 0x06, 0x4F, 0x37};
  EXPECT_EQ(stuffed(block), wire);
  EXPECT_EQ(unstuffed(wire), block);
}

TEST(Cobs, AgreesWithTheShortExamplesOfWikipedia) {
  const std::vector<Example> examples{
      {{0x00}, {0x01, 0x01}},
      {{0x00, 0x00}, {0x01, 0x01, 0x01}},
      {{0x00, 0x11, 0x00}, {0x01, 0x02, 0x11, 0x01}},
      {{0x11, 0x22, 0x00, 0x33}, {0x03, 0x11, 0x22, 0x02, 0x33}},
      {{0x11, 0x22, 0x33, 0x44}, {0x05, 0x11, 0x22, 0x33, 0x44}},
      {{0x11, 0x00, 0x00, 0x00}, {0x02, 0x11, 0x01, 0x01, 0x01}},
  };
  for (const Example& example : examples) {
    EXPECT_EQ(stuffed(example.block), example.wire);
    EXPECT_EQ(unstuffed(example.wire), example.block);
  }
}

TEST(Cobs, UnstuffsTheLongExamplesOfWikipedia) {
  const std::vector<Example> examples{
      {counting(0x01, 0xFE), joined({0xFF}, counting(0x01, 0xFE))},
      {counting(0x00, 0xFE), joined({0x01, 0xFF}, counting(0x01, 0xFE))},
      {counting(0x01, 0xFF), joined(joined({0xFF}, counting(0x01, 0xFE)), {0x02, 0xFF})},
      {joined(counting(0x02, 0xFF), {0x00}),
       joined(joined({0xFF}, counting(0x02, 0xFF)), {0x01, 0x01})},
      {joined(counting(0x03, 0xFF), {0x00, 0x01}),
       joined(joined({0xFE}, counting(0x03, 0xFF)), {0x02, 0x01})},
  };
  for (const Example& example : examples) {
    EXPECT_EQ(unstuffed(example.wire), example.block);
  }
}

TEST(Cobs, StuffsTheLongestBlockWithOneByte) {
  const Bytes block = counting(0x01, 0xFD);
  EXPECT_EQ(stuffed(block), joined({0xFE}, block));
}

TEST(Cobs, EveryShortBlockComesBack) {
  const std::uint8_t alphabet[] = {0x00, 0x01, 0x02, 0xFF};
  for (unsigned number = 0; number < 1U << 14; ++number) {
    Bytes block;
    for (unsigned rest = number; rest > 1; rest >>= 2) {
      block.push_back(alphabet[rest & 3U]);
    }
    ASSERT_EQ(unstuffed(stuffed(block)), block);
  }
}

TEST(Cobs, EveryRandomBlockComesBackWithoutZerosAndOneByteLonger) {
  std::mt19937 generator(1);
  CobsDecoder decoder;
  for (int i = 0; i < 2000; ++i) {
    const Bytes block = random_block(generator);
    const Bytes wire = stuffed(block);
    ASSERT_EQ(wire.size(), block.size() + 1);
    ASSERT_THAT(wire, testing::Each(testing::Ne(0)));
    ASSERT_EQ(unstuffed(wire, decoder), block);
  }
}

TEST(Cobs, SaysWhenTheDelimiterCutsARun) {
  const Bytes wire = stuffed({0x11, 0x22, 0x00, 0x33});
  EXPECT_EQ(unstuffed({wire.begin(), wire.end() - 1}), std::nullopt);
  EXPECT_EQ(unstuffed({wire.begin(), wire.begin() + 2}), std::nullopt);
}

TEST(Cobs, ADelimiterBringsTheDecoderBackFromAnything) {
  std::mt19937 generator(2);
  CobsDecoder decoder;
  const Bytes block{0x00, 0x07, 0x00};
  for (int i = 0; i < 2000; ++i) {
    std::uint8_t value = 0;
    for (const std::uint8_t byte : random_block(generator)) {
      decoder.take(byte, value);
    }
    decoder.take(0, value);
    ASSERT_EQ(unstuffed(stuffed(block), decoder), block);
  }
}

}  // namespace
}  // namespace echomap::protocol
