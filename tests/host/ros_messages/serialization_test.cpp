// SPDX-License-Identifier: MIT
#include "host/ros_messages/serialization.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/all_ros_messages.hpp"
#include "tests/support/random_message.hpp"

namespace echomap::ros_messages {
namespace {

using tests::random_message;

TEST(Serialization, EveryMessageReadsBackEqual) {
  std::mt19937 random(1);
  tests::AllRosMessages::for_each([&random]<class M>() {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 50; ++i) {
      const M message = random_message<M>(random);
      serialize(message, bytes);
      ASSERT_EQ(deserialize<M>(bytes), message) << M::kName;
    }
  });
}

/// Reads bytes that may be anything, in a block of their own, so that a sanitizer sees what is read
/// beyond them. True where they were accepted; what was accepted has to serialize and read back to
/// the same bytes.
template <class M>
bool reads(std::vector<std::uint8_t> bytes) {
  bytes.shrink_to_fit();
  try {
    const std::vector<std::uint8_t> again = serialize(deserialize<M>(bytes));
    EXPECT_EQ(serialize(deserialize<M>(again)), again) << M::kName;
    return true;
  } catch (const CdrError&) {
    return false;
  }
}

TEST(Serialization, EveryMessageThatIsCutOffIsRefused) {
  std::mt19937 random(2);
  tests::AllRosMessages::for_each([&random]<class M>() {
    for (int i = 0; i < 5; ++i) {
      const std::vector<std::uint8_t> whole = serialize(random_message<M>(random));
      for (std::size_t size = 0; size < whole.size(); ++size) {
        ASSERT_FALSE(reads<M>({whole.data(), whole.data() + size})) << M::kName << " of " << size;
      }
      EXPECT_TRUE(reads<M>(whole));
    }
  });
}

TEST(Serialization, DamagedBytesAreRefusedOrReadAsAnotherMessage) {
  std::mt19937 random(3);
  tests::AllRosMessages::for_each([&random]<class M>() {
    const std::vector<std::uint8_t> whole = serialize(random_message<M>(random));
    for (int i = 0; i < 300; ++i) {
      std::vector<std::uint8_t> bytes = whole;
      for (auto faults = 1 + random() % 3; faults > 0; --faults) {
        bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
      }
      reads<M>(bytes);
    }
  });
}

TEST(Serialization, RandomBytesAreRefusedOrReadAsSomeMessage) {
  std::mt19937 random(4);
  tests::AllRosMessages::for_each([&random]<class M>() {
    for (int i = 0; i < 300; ++i) {
      std::vector<std::uint8_t> bytes(random() % 200);
      // Small numbers, so that counts are passed now and then.
      std::generate(bytes.begin(), bytes.end(), [&] {
        return static_cast<std::uint8_t>(random() % 4 == 0 ? random() % 8 : 0);
      });
      if (bytes.size() >= 4) {
        bytes[0] = 0;
        bytes[1] = static_cast<std::uint8_t>(random() % 2);
      }
      reads<M>(bytes);
    }
  });
}

}  // namespace
}  // namespace echomap::ros_messages
