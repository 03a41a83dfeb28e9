// SPDX-License-Identifier: MIT
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "host/ros_messages/serialization.hpp"
#include "tests/support/all_ros_messages.hpp"
#include "tests/support/fastcdr_messages.hpp"
#include "tests/support/random_message.hpp"

// What ROS 2 reads and writes: fastcdr is the serializer of its default middleware.
namespace echomap::ros_messages {
namespace {

using eprosima::fastcdr::Cdr;

template <class M>
class Fastcdr : public testing::Test {};

using Compared = testing::Types<Odometry, Range, LaserScan, TFMessage, OccupancyGrid, JointState>;
TYPED_TEST_SUITE(Fastcdr, Compared);

TYPED_TEST(Fastcdr, WritesTheBytesThatWeWrite) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const TypeParam message = tests::random_message<TypeParam>(random);
    ASSERT_EQ(tests::fastcdr_bytes(message), serialize(message));
  }
}

TYPED_TEST(Fastcdr, ReadsWhatWeWrite) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const TypeParam message = tests::random_message<TypeParam>(random);
    ASSERT_EQ(tests::read_by_fastcdr<TypeParam>(serialize(message)), message);
  }
}

TYPED_TEST(Fastcdr, IsReadByUsInEitherByteOrder) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const TypeParam message = tests::random_message<TypeParam>(random);
    for (const auto order : {Cdr::LITTLE_ENDIANNESS, Cdr::BIG_ENDIANNESS}) {
      ASSERT_EQ(deserialize<TypeParam>(tests::fastcdr_bytes(message, order)), message);
    }
  }
}

}  // namespace
}  // namespace echomap::ros_messages
