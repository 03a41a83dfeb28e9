// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_link_params.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::robot_link {
namespace {

using std::chrono::milliseconds;

TEST(RobotLinkParams, RefusesPeriodsThatDoNotFitTogether) {
  EXPECT_THROW(checked({.keep_alive_ttl = milliseconds(40)}), std::invalid_argument);
  EXPECT_THROW(checked({.keep_alive_ttl = milliseconds(501)}), std::invalid_argument);
  EXPECT_THROW(checked({.hello_period = milliseconds(0)}), std::invalid_argument);
  EXPECT_THROW(checked({.quiet_after = milliseconds(1000)}), std::invalid_argument);
}

TEST(RobotLinkParams, LetsMotionOutliveTwoStallsOfARadio) {
  const RobotLinkParams params = checked(radio_link());
  EXPECT_GE(params.keep_alive_ttl, milliseconds(2 * 150));
}

}  // namespace
}  // namespace echomap::robot_link
