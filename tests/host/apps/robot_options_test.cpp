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
  EXPECT_EQ(run({"explore", "--port", "x", "--baud", "1234"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "0"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--stops", "1001"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--board", "due"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"demo", "--emulator", "mock", "--board", "uno"}).code, console::ExitCode::kUsage);
}

TEST(RobotOptions, ARobotIsTakenOverByAnyCommandWithAPort) {
  EXPECT_THAT(run({"explore", "--help"}).out, HasSubstr("--take-over"));
  EXPECT_THAT(run({"localize", "--help"}).out, HasSubstr("--take-over"));
}

TEST(RobotOptions, AnImageIsNamedOrOfASpeed) {
  EXPECT_EQ(run({"flash", "--baud", "1234"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"flash", "--baud", "115200", "--image", "x.hex"}).code, console::ExitCode::kUsage);
}

TEST(RobotOptions, AViewIsAMapALineOrNone) {
  EXPECT_THAT(run({"explore", "--help"}).out, HasSubstr("--view"));
  EXPECT_EQ(run({"demo", "--view", "picture"}).code, console::ExitCode::kUsage);
  EXPECT_EQ(run({"localize", "--view", "map", "--headless"}).code, console::ExitCode::kUsage);
}

TEST(RobotOptions, SlamIsAnotherNameOfExplore) {
  EXPECT_THAT(run({"slam", "--help"}).out, HasSubstr("echomap explore"));
  const auto refused = run({"slam", "--slam", "scan"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage) << "that is for lasers";
  EXPECT_THAT(refused.err, HasSubstr("--slam"));
}

TEST(RobotOptions, AnOldNameOfASlamMethodAnswersWithTheNewOne) {
  const auto refused = run({"explore", "--slam", "grid"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("now called 'multiscan'"));
}

TEST(RobotOptions, APoseIsOfTheCameraOrOfSlam) {
  const auto refused = run({"explore", "--fixes", "udp:127.0.0.1:5000", "--slam", "multiscan"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("excludes"));
}

TEST(RobotOptions, ARunThatIsResumedIsADirectoryAndHasNoCamera) {
  EXPECT_EQ(run({"explore", "--resume", "no/such/run"}).code, console::ExitCode::kUsage);
  const auto refused = run({"explore", "--resume", ".", "--fixes", "udp:127.0.0.1:5000"});
  EXPECT_EQ(refused.code, console::ExitCode::kUsage);
  EXPECT_THAT(refused.err, HasSubstr("excludes"));
}

}  // namespace
}  // namespace echomap::apps
