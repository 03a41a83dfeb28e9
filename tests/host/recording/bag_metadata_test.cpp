// SPDX-License-Identifier: MIT
#include "host/recording/bag_metadata.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::recording {
namespace {

using ::testing::HasSubstr;

TEST(BagMetadataTest, CountsMessagesByTopicAndFile) {
  BagMetadata metadata;
  metadata.begin_part("session.mcap");
  metadata.add("/odom", "nav_msgs/msg/Odometry", 1000);
  metadata.add("/odom", "nav_msgs/msg/Odometry", 3000);
  metadata.begin_part("session_1.mcap");
  metadata.add("/tf", "tf2_msgs/msg/TFMessage", 4500);
  const std::string yaml = metadata.yaml();
  EXPECT_THAT(yaml, HasSubstr("  duration:\n    nanoseconds: 3500\n"));
  EXPECT_THAT(yaml, HasSubstr("    nanoseconds_since_epoch: 1000\n  message_count: 3\n"));
  EXPECT_THAT(yaml,
              HasSubstr("        name: /odom\n        type: nav_msgs/msg/Odometry\n"
                        "        serialization_format: cdr\n        offered_qos_profiles: \"\"\n"
                        "      message_count: 2\n"));
  EXPECT_THAT(yaml, HasSubstr("relative_file_paths:\n    - session.mcap\n    - session_1.mcap\n"));
  EXPECT_THAT(yaml,
              HasSubstr("    - path: session_1.mcap\n      starting_time:\n"
                        "        nanoseconds_since_epoch: 4500\n      duration:\n"
                        "        nanoseconds: 0\n      message_count: 1\n"));
}

}  // namespace
}  // namespace echomap::recording
