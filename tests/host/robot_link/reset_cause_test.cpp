// SPDX-License-Identifier: MIT
#include "host/robot_link/reset_cause.hpp"

#include <gtest/gtest.h>

#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {
namespace {

TEST(ResetCause, IsToldInWords) {
  EXPECT_EQ(reset_cause_text(protocol::kResetBrownOut), "brown-out");
  EXPECT_EQ(reset_cause_text(protocol::kResetExternal), "reset line");
  EXPECT_EQ(reset_cause_text(protocol::kResetPowerOn | protocol::kResetWatchdog),
            "watchdog, power-on");
}

TEST(ResetCause, MayNotBeTold) { EXPECT_EQ(reset_cause_text(0), "cause not reported"); }

}  // namespace
}  // namespace echomap::robot_link
