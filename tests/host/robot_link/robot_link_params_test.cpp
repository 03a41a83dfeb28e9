// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_link_params.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::robot_link {
namespace {

using std::chrono::milliseconds;

TEST(RobotLinkParams, RefusesPeriodsThatDoNotFitTogether) {
  EXPECT_THROW(validated({.keep_alive_ttl = milliseconds(40)}), std::invalid_argument);
  EXPECT_THROW(validated({.keep_alive_ttl = milliseconds(501)}), std::invalid_argument);
  EXPECT_THROW(validated({.hello_period = milliseconds(0)}), std::invalid_argument);
  EXPECT_THROW(validated({.quiet_after = milliseconds(1000)}), std::invalid_argument);
}

TEST(RobotLinkParams, FillsAMillisecondWithDelimitersAtEverySpeed) {
  EXPECT_EQ(wired_link(9600).ping.max_lead_bytes, 1U);
  EXPECT_EQ(wired_link(115200).ping.max_lead_bytes, RobotLinkParams{}.ping.max_lead_bytes);
  EXPECT_EQ(wired_link(500'000).ping.max_lead_bytes, 24U) << "the robot's buffer is small";
  EXPECT_NEAR(wired_link(115200).clock.phase_step_us, RobotLinkParams{}.clock.phase_step_us, 0.5);
  EXPECT_EQ(wired_link(9600).clock.phase_step_us, 1000.0) << "USB's own step";
}

TEST(RobotLinkParams, LeavesRoomOnASlowWire) {
  const RobotLinkParams slow = wired_link(9600);
  // A ping and its delimiters, ten bits a byte, against 9600 bits a second.
  const double bytes = 10.0 + 0.5 * static_cast<double>(slow.ping.max_lead_bytes);
  EXPECT_LE(bytes * 10.0 / std::chrono::duration<double>(slow.ping.first_period).count(),
            0.5 * 9600.0);
}

TEST(RobotLinkParams, LetsMotionOutliveTwoStallsOfARadio) {
  const RobotLinkParams params = validated(radio_link());
  EXPECT_GE(params.keep_alive_ttl, milliseconds(2 * 150));
}

}  // namespace
}  // namespace echomap::robot_link
