// SPDX-License-Identifier: MIT
#include "host/transport/lockstep_lines.hpp"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace echomap::transport {
namespace {

TEST(LockstepLines, ReadADevicesHello) {
  const auto device = parse_lockstep_hello(
      R"({"lockstep":1,"firmware":"echomap-uno 0.1.0","emulator":"simavr 1.6"})");
  ASSERT_TRUE(device.has_value());
  EXPECT_EQ(device->firmware, "echomap-uno 0.1.0");
  EXPECT_EQ(device->emulator, "simavr 1.6");
}

TEST(LockstepLines, RefuseAnotherHello) {
  for (const std::string line : {"",
                                 "hello",
                                 "[1]",
                                 R"({"lockstep":2,"firmware":"f","emulator":"e"})",
                                 R"({"lockstep":1,"firmware":3,"emulator":"e"})",
                                 R"({"lockstep":1,"firmware":"f"})"}) {
    EXPECT_FALSE(parse_lockstep_hello(line)) << line;
  }
}

TEST(LockstepLines, ReadTheAnswerToAGrant) {
  const auto reached = parse_reached("reached 20000 18446744073709551615");
  ASSERT_TRUE(reached.has_value());
  EXPECT_EQ(reached->until_us, 20000);
  EXPECT_EQ(reached->device_bytes, 18446744073709551615U);
}

TEST(LockstepLines, ReadTheTruthInTheAnswerToAGrant) {
  EXPECT_FALSE(parse_reached("reached 20000 17")->true_pose);
  const auto reached = parse_reached("reached 20000 17 1500000 -250001 -90000000");
  ASSERT_TRUE(reached && reached->true_pose);
  EXPECT_EQ(reached->until_us, 20000);
  EXPECT_EQ(reached->device_bytes, 17U);
  EXPECT_DOUBLE_EQ(reached->true_pose->x_m, 1.5);
  EXPECT_DOUBLE_EQ(reached->true_pose->y_m, -0.250001);
  EXPECT_DOUBLE_EQ(reached->true_pose->heading_rad, -0.5 * std::numbers::pi);
}

/// A stream reads -1 as the greatest unsigned number: the host would wait for so many bytes.
TEST(LockstepLines, RefuseAnotherAnswer) {
  for (const std::string line : {"",
                                 "reached",
                                 "reached 5",
                                 "reached 5 -1",
                                 "reached 5 +1",
                                 "reached 5 6 7",
                                 "reached 5 6 7 8",
                                 "reached 5 6 7 8 9 10",
                                 "reached 5 6 7 8 9 ",
                                 "reached 5 6 7 8 0.5",
                                 "reached  5 6",
                                 "reached 5 6 ",
                                 "reached 5 18446744073709551616",
                                 "reached 5x 6",
                                 "bye 5 6"}) {
    EXPECT_FALSE(parse_reached(line)) << line;
  }
}

}  // namespace
}  // namespace echomap::transport
