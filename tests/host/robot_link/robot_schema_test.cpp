// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_schema.hpp"

#include <gmock/gmock.h>

#include "tests/host/robot_link/other_messages.hpp"

namespace echomap::robot_link {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct CheckFacts {
  const std::vector<DescribedMessage>& described;
  std::size_t at = 0;
  template <class M>
  void operator()(const M* /*of*/) {
    ASSERT_LT(at, described.size());
    EXPECT_EQ(described[at].id, M::kId);
    EXPECT_EQ(described[at].name, M::name());
    EXPECT_EQ(described[at].schema.seed, protocol::MessageFacts<M>::kSeed) << M::name();
    EXPECT_EQ(described[at].schema.payload_size, protocol::MessageFacts<M>::kSize) << M::name();
    ++at;
  }
};

SchemaDifference difference_to(const std::vector<std::uint8_t>& description) {
  return SchemaDifference(read_robot_schema(description).value());
}

TEST(RobotSchema, FindsSeedAndLengthOfEveryMessageInItsDescription) {
  const auto described = read_robot_schema(description_of<protocol::AllMessages>());
  ASSERT_TRUE(described);
  CheckFacts check{*described};
  protocol::AllMessages::for_each(check);
  EXPECT_EQ(check.at, described->size());
}

TEST(RobotSchema, HasTheDigestThatTheHandshakeTells) {
  EXPECT_EQ(digest_of(read_robot_schema(description_of<protocol::AllMessages>()).value()),
            protocol::kSchemaDigest);
  EXPECT_EQ(digest_of(read_robot_schema(description_of<other_messages::Newer>()).value()),
            protocol::DigestOf<other_messages::Newer>::kValue);
}

TEST(RobotSchema, IsNoneForBytesThatDescribeNothing) {
  EXPECT_FALSE(read_robot_schema(std::vector<std::uint8_t>{0x81, 0x00, 0x17}));
  auto cut = description_of<protocol::AllMessages>();
  cut.push_back(0x01);  // The head of a field whose name is cut off.
  EXPECT_FALSE(read_robot_schema(cut));
}

TEST(SchemaDifference, IsNoneBetweenTheSameMessages) {
  const auto none = difference_to(description_of<protocol::AllMessages>());
  EXPECT_THAT(none.different(), IsEmpty());
  EXPECT_THAT(none.missing_on_robot(), IsEmpty());
  EXPECT_THAT(none.unknown_to_host(), IsEmpty());
  EXPECT_TRUE(none.agrees(protocol::Gyro::kId));
  EXPECT_EQ(none.summary(), "");
}

TEST(SchemaDifference, NamesWhatAnOlderFirmwareLacks) {
  const auto older = difference_to(description_of<other_messages::Older>());
  EXPECT_THAT(older.different(), ElementsAre("Health"));
  EXPECT_THAT(older.missing_on_robot(),
              ElementsAre("TakeOver",
                          "ConfigureWiring",
                          "ConfigureScalar",
                          "DriveSetpoint",
                          "Ranges",
                          "Gyro",
                          "EncoderErrors",
                          "Scalar"));
  EXPECT_THAT(older.unknown_to_host(), IsEmpty());
  EXPECT_FALSE(older.agrees(protocol::Health::kId));
  EXPECT_FALSE(older.agrees(protocol::Gyro::kId));
  EXPECT_TRUE(older.agrees(protocol::Odometry::kId));
  EXPECT_EQ(older.foreign(protocol::Health::kId)->payload_size, 6);
  EXPECT_FALSE(older.foreign(protocol::Gyro::kId));
  EXPECT_EQ(older.summary(),
            "other fields in Health; the robot lacks TakeOver, ConfigureWiring, ConfigureScalar, "
            "DriveSetpoint, Ranges, Gyro, EncoderErrors, Scalar");
}

TEST(SchemaDifference, NamesWhatANewerFirmwareHasBesides) {
  const auto newer = difference_to(description_of<other_messages::Newer>());
  EXPECT_THAT(newer.unknown_to_host(), ElementsAre("Compass"));
  EXPECT_TRUE(newer.foreign(Compass::kId));
  EXPECT_EQ(newer.summary(), "this host lacks Compass");
}

}  // namespace
}  // namespace echomap::robot_link
