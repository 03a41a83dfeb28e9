// SPDX-License-Identifier: MIT
#include "host/session/firmware_name.hpp"

#include <gtest/gtest.h>

namespace echomap::session {
namespace {

TEST(FirmwareName, IsThatOfARealBoard) {
  protocol::HelloReply robot{};
  robot.firmware_version = 107;
  EXPECT_EQ(firmware_of(robot), "echomap 1.0.7");
}

}  // namespace
}  // namespace echomap::session
