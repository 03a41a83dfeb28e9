// SPDX-License-Identifier: MIT
#include "host/robot_link/protocol_mismatch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/messages.hpp"
#include "protocol/version.hpp"

namespace echomap::robot_link {
namespace {

protocol::HelloReply our_reply() {
  protocol::HelloReply reply{};
  reply.protocol_major = protocol::kProtocolMajor;
  reply.protocol_minor = protocol::kProtocolMinor;
  reply.schema_digest = protocol::kSchemaDigest;
  reply.firmware_version = 7;
  return reply;
}

TEST(ProtocolMismatch, IsNoneForTheSameMessages) { EXPECT_TRUE(speaks_our_protocol(our_reply())); }

TEST(ProtocolMismatch, IsOneForAnyBitOfTheDigestAndForAnotherMajor) {
  for (int bit = 0; bit < 32; ++bit) {
    protocol::HelloReply reply = our_reply();
    reply.schema_digest ^= 1U << bit;
    EXPECT_FALSE(speaks_our_protocol(reply));
  }
  protocol::HelloReply reply = our_reply();
  ++reply.protocol_major;
  EXPECT_FALSE(speaks_our_protocol(reply));
}

TEST(ProtocolMismatch, UpdatesTheOlderSide) {
  const auto side = [](std::uint8_t major, std::uint8_t minor) {
    ProtocolMismatch mismatch;
    mismatch.host_major = 2;
    mismatch.host_minor = 5;
    mismatch.robot_major = major;
    mismatch.robot_minor = minor;
    return mismatch.side_to_update();
  };
  EXPECT_EQ(side(1, 9), SideToUpdate::kFirmware);
  EXPECT_EQ(side(2, 4), SideToUpdate::kFirmware);
  EXPECT_EQ(side(2, 5), SideToUpdate::kFirmware);
  EXPECT_EQ(side(2, 6), SideToUpdate::kHost);
  EXPECT_EQ(side(3, 0), SideToUpdate::kHost);
}

TEST(ProtocolMismatch, SaysBothVersionsAndWhatToUpdate) {
  const ProtocolMismatch mismatch{.host_major = 1,
                                  .host_minor = 2,
                                  .host_digest = 0xABCD,
                                  .robot_major = 1,
                                  .robot_minor = 0,
                                  .robot_digest = 0x12345678,
                                  .robot_firmware_version = 107,
                                  .difference = "other fields in Echo"};
  EXPECT_EQ(mismatch.message(),
            "the robot's firmware 1.0.7 speaks protocol 1.0 (schema 12345678), this host protocol "
            "1.2 (schema 0000abcd): other fields in Echo\n  next: the robot is older: ./run flash");
}

TEST(ProtocolMismatch, CallsNeitherOlderWhereVersionsAreEqual) {
  protocol::HelloReply reply = our_reply();
  reply.schema_digest ^= 1U;
  const std::string message = mismatch_with(reply).message();
  EXPECT_THAT(message, testing::HasSubstr("of one version"));
  EXPECT_THAT(message, testing::Not(testing::HasSubstr("older")));
}

TEST(ProtocolMismatch, TakesTheRobotsSideFromItsReply) {
  const ProtocolMismatch mismatch = mismatch_with(our_reply());
  EXPECT_EQ(mismatch.robot_digest, protocol::kSchemaDigest);
  EXPECT_EQ(mismatch.host_digest, protocol::kSchemaDigest);
  EXPECT_EQ(mismatch.robot_firmware_version, 7);
}

}  // namespace
}  // namespace echomap::robot_link
