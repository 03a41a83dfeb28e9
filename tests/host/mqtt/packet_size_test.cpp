// SPDX-License-Identifier: MIT
#include "host/mqtt/packet_size.hpp"

#include <gtest/gtest.h>

namespace echomap::mqtt {
namespace {

// The remaining length has as many bytes as it has groups of seven bits (MQTT 5, section 1.5.5).
TEST(PacketSize, CountsTheBytesOfTheRemainingLength) {
  EXPECT_EQ(publish_packet_bytes(1, 121), 2U + 127U);
  EXPECT_EQ(publish_packet_bytes(1, 122), 3U + 128U);
  EXPECT_EQ(publish_packet_bytes(1, 16377), 3U + 16383U);
  EXPECT_EQ(publish_packet_bytes(1, 16378), 4U + 16384U);
  EXPECT_EQ(publish_packet_bytes(1, 2097146), 5U + 2097152U);
}

}  // namespace
}  // namespace echomap::mqtt
