// SPDX-License-Identifier: MIT
#include "host/tracking/camera_fix.hpp"

#include <gtest/gtest.h>

namespace echomap::tracking {
namespace {

TEST(CameraFix, IsReadFromALine) {
  const auto fix = parse_camera_fix(
      R"({"stamp_s": 12.5, "sent_s": 12.6, "x_m": 1, "y_m": -2.5, "heading_rad": 0.5,
          "std_m": 0.01, "std_rad": 0.02, "camera": "left"})");
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->stamp_s, 12.5);
  EXPECT_EQ(fix->sent_s, 12.6);
  EXPECT_EQ(fix->T_camera_robot.y_m(), -2.5);
  EXPECT_EQ(fix->T_camera_robot.heading_rad(), 0.5);
  EXPECT_EQ(fix->stddev_m, 0.01);
  EXPECT_EQ(fix->stddev_rad, 0.02);
}

TEST(CameraFix, IsSentAtOnceWhereItDoesNotSay) {
  const auto fix = parse_camera_fix(R"({"stamp_s": 3, "x_m": 1, "y_m": 2, "heading_rad": 0})");
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->sent_s, 3.0);
  EXPECT_GT(fix->stddev_m, 0.0);
}

TEST(CameraFix, IsNothingWhereALineIsNone) {
  for (const char* wrong :
       {"",
        "{",
        "[]",
        "null",
        "\xff\xfe",
        R"({"x_m": 1, "y_m": 2, "heading_rad": 0})",
        R"({"stamp_s": 3, "x_m": 1, "heading_rad": 0})",
        R"({"stamp_s": "3", "x_m": 1, "y_m": 2, "heading_rad": 0})",
        R"({"stamp_s": null, "x_m": 1, "y_m": 2, "heading_rad": 0})",
        R"({"stamp_s": 3, "x_m": 1e300, "y_m": 2, "heading_rad": 0})",
        R"({"stamp_s": 3, "x_m": 1e999, "y_m": 2, "heading_rad": 0})",
        R"({"stamp_s": 3, "x_m": 1, "y_m": 2, "heading_rad": 0, "std_m": 0})",
        R"({"stamp_s": 3, "x_m": 1, "y_m": 2, "heading_rad": 0, "std_rad": -1})",
        R"({"stamp_s": 3, "sent_s": 2, "x_m": 1, "y_m": 2, "heading_rad": 0})"}) {
    EXPECT_FALSE(parse_camera_fix(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace echomap::tracking
