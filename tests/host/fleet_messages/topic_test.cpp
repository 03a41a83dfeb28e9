// SPDX-License-Identifier: MIT
#include "host/fleet_messages/topic.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::fleet_messages {
namespace {

TopicId example_id(TopicKind kind) {
  switch (kind) {
    case TopicKind::kSubmap:
    case TopicKind::kSource:
    case TopicKind::kRelay:
      return content_hash("abc");
    case TopicKind::kGraph:
    case TopicKind::kManifest:
      return std::uint16_t{65535};
    default:
      return {};
  }
}

TEST(FleetTopic, IsWrittenAsTheDocumentSays) {
  EXPECT_EQ(format_topic({"office", "r1", TopicKind::kPose, {}}), "echomap/1/office/r1/pose");
  EXPECT_EQ(format_topic({"office", "r1", TopicKind::kManifest, std::uint16_t{12}}),
            "echomap/1/office/r1/manifest/12");
  EXPECT_EQ(format_topic({"office", "r1", TopicKind::kSubmap, content_hash("abc")}),
            "echomap/1/office/r1/submap/ba7816bf8f01cfea414140de5dae2223");
  EXPECT_EQ(fleet_filter("office"), "echomap/1/office/#");
}

TEST(FleetTopic, OfEveryKindIsReadBack) {
  for (const TopicKind kind : kTopicKinds) {
    const FleetTopic topic{"a-fleet_1", "robot-9", kind, example_id(kind)};
    const auto parsed = parse_topic(format_topic(topic));
    ASSERT_TRUE(parsed) << name_of(kind);
    EXPECT_EQ(*parsed, topic) << name_of(kind);
  }
}

TEST(FleetTopic, IsNoOtherText) {
  const std::vector<std::string> others{
      "",
      "echomap/1/office/r1",
      "echomap/2/office/r1/pose",
      "echomap/1/office/r1/pose/",
      "echomap/1/office/r1/pose/1",
      "echomap/1/office/r1/poses",
      "echomap/1/office//pose",
      "echomap/1//r1/pose",
      "echomap/1/Office/r1/pose",
      "echomap/1/office/r 1/pose",
      "echomap/1/office/+/pose",
      "echomap/1/office/#",
      "echomap/1/office/r1/pose\n",
      "/echomap/1/office/r1/pose",
      "echomap/1/office/" + std::string(33, 'r') + "/pose",
      "echomap/1/office/r1/graph",
      "echomap/1/office/r1/graph/",
      "echomap/1/office/r1/graph/01",
      "echomap/1/office/r1/graph/-1",
      "echomap/1/office/r1/graph/+1",
      "echomap/1/office/r1/graph/65536",
      "echomap/1/office/r1/graph/1x",
      "echomap/1/office/r1/graph/1/2",
      "echomap/1/office/r1/submap/1",
      "echomap/1/office/r1/submap/BA7816BF8F01CFEA414140DE5DAE2223",
  };
  for (const std::string& other : others) {
    EXPECT_FALSE(parse_topic(other)) << other;
  }
}

TEST(FleetTopic, KeepsWhatALateJoinerNeeds) {
  EXPECT_TRUE(is_retained(TopicKind::kSubmap));
  EXPECT_TRUE(is_retained(TopicKind::kPresence));
  EXPECT_TRUE(is_retained(TopicKind::kSearch));
  EXPECT_FALSE(is_retained(TopicKind::kPose)) << "a pose is of its moment";
  EXPECT_FALSE(is_retained(TopicKind::kAsk)) << "an old question is answered already";
}

}  // namespace
}  // namespace echomap::fleet_messages
