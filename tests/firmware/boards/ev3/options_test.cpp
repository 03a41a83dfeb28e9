// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/firmware/boards/ev3/brick_program.hpp"

namespace echomap::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

void expect_refused(const BrickStart& start, const std::string& words) {
  BrickProgram program(start);
  EXPECT_EQ(program.end(), 2) << words;
  EXPECT_THAT(program.errors(),
              AllOf(StartsWith("echomap-ev3: " + words), HasSubstr("\nusage: echomap-ev3 ")));
}

BrickStart at_line(const std::string& line) {
  BrickStart start;
  start.line = line;
  return start;
}

BrickStart with(const std::vector<std::string>& more) {
  BrickStart start;
  start.more = more;
  return start;
}

TEST(Ev3Options, PortsThatAreNoneAreRefused) {
  for (const char* line :
       {"tcp:", "tcp:abc", "tcp:0", "tcp:99999", "tcp:-1", "tcp:8375x", "tcp:4294967297"}) {
    expect_refused(at_line(line),
                   "--line " + std::string(line) + ": a TCP port is a number of 1 .. 65535\n");
  }
}

TEST(Ev3Options, ChannelsThatAreNoneAreRefused) {
  for (const char* line : {"rfcomm:", "rfcomm:0", "rfcomm:31", "rfcomm:one"}) {
    expect_refused(
        at_line(line),
        "--line " + std::string(line) + ": a channel of Bluetooth is a number of 1 .. 30\n");
  }
}

TEST(Ev3Options, LinesThatAreNoneAreRefused) {
  expect_refused(at_line("serial:"), "--line serial:: the device is missing");
  expect_refused(at_line("usb"), "--line usb: there is no such line\n");
  expect_refused(at_line("stdio:"), "--line stdio:: there is no such line\n");
}

TEST(Ev3Options, OtherMistakesAreNamed) {
  expect_refused(with({"--speed", "9"}), "--speed 9: there is no such option\n");
  expect_refused(with({"--sysfs"}), "--sysfs : there is no such option, or its value is missing\n");
  expect_refused(with({"--clock", "tcp:1"}), "--clock tcp:1: a simulated clock is unix:SOCKET\n");
}

TEST(Ev3Options, VersionIsToldWithoutARobot) {
  BrickProgram program(with({"--version"}));
  EXPECT_EQ(program.end(), 0);
  EXPECT_THAT(program.output(), StartsWith("echomap-ev3 "));
  EXPECT_THAT(program.errors(), IsEmpty());
}

}  // namespace
}  // namespace echomap::tests
