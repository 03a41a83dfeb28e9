// SPDX-License-Identifier: MIT
#include "host/apps/robot_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/apps/said_by_command_line.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

TEST(RobotOptions, TheHelpOfTheDemoTellsBodyFromProfile) {
  EXPECT_THAT(run({"demo", "--help"}).out, HasSubstr("--body"));
}

TEST(RobotOptions, AreCheckedBeforeARobotIsAsked) {
  EXPECT_EQ(run({"explore", "--port", "x", "--baud", "1234"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "0"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "101"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--board", "due"}).code, ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--emulator", "mock", "--board", "uno"}).code, ExitCode::kUsage);
}

}  // namespace
}  // namespace echomap::apps
