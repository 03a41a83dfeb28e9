// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_identification.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/version.hpp"
#include "tests/host/robot_link/other_messages.hpp"

namespace echomap::robot_link {
namespace {

using testing::HasSubstr;

template <class List>
protocol::HelloReply reply_of(std::uint8_t protocol_minor) {
  protocol::HelloReply reply{};
  reply.protocol_major = protocol::kProtocolMajor;
  reply.protocol_minor = protocol_minor;
  reply.schema_digest = protocol::DigestOf<List>::kValue;
  reply.boot_id = 1;
  return reply;
}

template <class List>
BulkResult whole_description() {
  return {protocol::BulkContent::kSchema, BulkStatus::kWhole, description_of<List>()};
}

class RobotIdentificationTest : public testing::Test {
 protected:
  RobotIdentification identification{messages_for_mapping()};
};

TEST_F(RobotIdentificationTest, UnderstandsARobotOfTheSameMessagesWithoutADescription) {
  auto reply = reply_of<other_messages::Newer>(9);
  reply.schema_digest = protocol::kSchemaDigest;
  EXPECT_EQ(identification.identify(reply), RobotIdentity::kUnderstood);
  EXPECT_FALSE(identification.difference());
  EXPECT_TRUE(identification.understands(protocol::Gyro::kId));
}

TEST_F(RobotIdentificationTest, NeedsOneDescriptionOfOtherMessages) {
  const auto reply = reply_of<other_messages::Older>(0);
  EXPECT_EQ(identification.identify(reply), RobotIdentity::kUndescribed);
  EXPECT_EQ(identification.identify(reply, whole_description<other_messages::Older>()),
            RobotIdentity::kUnderstood);
  EXPECT_FALSE(identification.understands(protocol::Gyro::kId));
  EXPECT_TRUE(identification.understands(protocol::Odometry::kId));
  EXPECT_EQ(identification.identify(reply), RobotIdentity::kUnderstood) << "described before";
  EXPECT_EQ(identification.identify(reply_of<other_messages::Newer>(9)),
            RobotIdentity::kUndescribed);
}

TEST_F(RobotIdentificationTest, ForgetsTheDifferenceOnceTheRobotIsFlashed) {
  identification.identify(reply_of<other_messages::Older>(0),
                          whole_description<other_messages::Older>());
  auto flashed = reply_of<other_messages::Older>(protocol::kProtocolMinor);
  flashed.schema_digest = protocol::kSchemaDigest;
  EXPECT_EQ(identification.identify(flashed), RobotIdentity::kUnderstood);
  EXPECT_TRUE(identification.understands(protocol::Gyro::kId));
}

TEST_F(RobotIdentificationTest, RefusesAnOlderRobotThatLacksWhatIsNeeded) {
  EXPECT_EQ(identification.identify(reply_of<other_messages::Foreign>(0),
                                    whole_description<other_messages::Foreign>()),
            RobotIdentity::kRefused);
  ASSERT_TRUE(identification.mismatch());
  EXPECT_THAT(identification.mismatch()->message(), HasSubstr("./run flash"));
  EXPECT_THAT(identification.mismatch()->difference, HasSubstr("lacks Ack"));
}

TEST_F(RobotIdentificationTest, RefusesADescriptionThatIsNotOfTheDigestItTold) {
  EXPECT_EQ(identification.identify(reply_of<other_messages::Newer>(9),
                                    whole_description<other_messages::Older>()),
            RobotIdentity::kRefused);
}

TEST_F(RobotIdentificationTest, RefusesAnotherMajorVersionUnasked) {
  auto reply = reply_of<other_messages::Newer>(0);
  reply.protocol_major = protocol::kProtocolMajor + 1;
  reply.schema_digest = protocol::kSchemaDigest;
  EXPECT_EQ(identification.identify(reply), RobotIdentity::kRefused);
}

TEST_F(RobotIdentificationTest, KnowsAnotherStartByItsBootId) {
  auto reply = reply_of<other_messages::Newer>(0);
  EXPECT_FALSE(identification.is_another_start(reply)) << "the first that is heard";
  identification.note(reply);
  EXPECT_FALSE(identification.is_another_start(reply));
  reply.boot_id = 2;
  EXPECT_TRUE(identification.is_another_start(reply));
}

}  // namespace
}  // namespace echomap::robot_link
