// SPDX-License-Identifier: MIT
#include "firmware/drivers/ring_buffer.hpp"

#include <deque>
#include <random>

#include <gtest/gtest.h>

namespace echomap::drivers {
namespace {

TEST(RingBuffer, TakesAsMuchAsItHoldsAndNoMore) {
  RingBuffer<4> ring;
  for (std::uint8_t byte = 1; byte <= 4; ++byte) {
    EXPECT_TRUE(ring.push(byte));
  }
  EXPECT_FALSE(ring.push(5));
  EXPECT_EQ(ring.size(), 4);
  EXPECT_EQ(ring.room(), 0);
  std::uint8_t byte = 0;
  EXPECT_TRUE(ring.pop(byte));
  EXPECT_EQ(byte, 1);
}

TEST(RingBuffer, EmptyGivesNothing) {
  RingBuffer<8> ring;
  std::uint8_t byte = 77;
  EXPECT_FALSE(ring.pop(byte));
  EXPECT_EQ(byte, 77);
}

TEST(RingBuffer, IsAQueueThroughEveryWrapOfItsIndices) {
  RingBuffer<128> ring;
  std::deque<std::uint8_t> model;
  std::mt19937 generator(1);
  for (int i = 0; i < 20000; ++i) {
    const auto bits = static_cast<std::uint32_t>(generator());
    if ((bits & 256U) != 0) {
      const auto byte = static_cast<std::uint8_t>(bits);
      const bool taken = ring.push(byte);
      ASSERT_EQ(taken, model.size() < 128);
      if (taken) {
        model.push_back(byte);
      }
    } else {
      std::uint8_t byte = 0;
      ASSERT_EQ(ring.pop(byte), !model.empty());
      if (!model.empty()) {
        ASSERT_EQ(byte, model.front());
        model.pop_front();
      }
    }
    ASSERT_EQ(ring.size(), model.size());
  }
}

}  // namespace
}  // namespace echomap::drivers
