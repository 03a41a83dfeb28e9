// SPDX-License-Identifier: MIT
#include "host/datasets/tum_log.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/support/log_test.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class TumLogTest : public tests::LogTest {
 protected:
  TumLogTest() : LogTest("a.tum", open_tum_log) {}
};

TEST_F(TumLogTest, EachLineIsAGivenPoseTurnedAboutZ) {
  const auto poses = tests::only<GivenPose>(
      read("# t x y z qx qy qz qw\n0.5 1 2 3 0 0 " + std::to_string(std::sin(0.6)) + " " +
           std::to_string(std::cos(0.6)) + "\n0.75 0 0 0 0 0 0 1"));
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].stamp_s, 0.5);
  EXPECT_EQ(poses[0].T_map_robot.y_m(), 2.0);
  EXPECT_NEAR(poses[0].T_map_robot.heading_rad(), 1.2, 1e-5);
  EXPECT_EQ(poses[1].T_map_robot.heading_rad(), 0.0);
}

TEST_F(TumLogTest, AScaledQuaternionTurnsAsMuch) {
  const auto poses = tests::only<GivenPose>(read("0 0 0 0 0 0 5 5\n"));
  EXPECT_NEAR(poses.at(0).T_map_robot.heading_rad(), std::acos(0.0), 1e-12);
}

TEST_F(TumLogTest, ErrorsNameTheLine) {
  EXPECT_THAT(error_of("# \n0 1 2 3 0 0 0\n"), HasSubstr("a.tum:2: qw is missing"));
  EXPECT_THAT(error_of("0 1 2 3 0 0 0 1 1\n"), HasSubstr("a.tum:1: '1' follows"));
}

}  // namespace
}  // namespace echomap::datasets
