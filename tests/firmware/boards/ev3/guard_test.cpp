// SPDX-License-Identifier: MIT
/// Deaths of the EV3's program. A busy machine takes its time, so that of each kind of death the
/// quickest of some is held to the limit: no luck makes a slow guard quick.
#include <algorithm>
#include <csignal>
#include <cstdio>

#include <gtest/gtest.h>

#include "protocol/handshake_messages.hpp"
#include "tests/firmware/boards/ev3/brick_program.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/median.hpp"

namespace echomap::tests {
namespace {

constexpr int kDeaths = 5;
constexpr double kLimitMs = 150.0;

/// What harms the program by signals to one of its two processes.
void expect_off_in_time(const char* name, const std::function<void(BrickProgram&)>& harm) {
  std::vector<double> off_ms;
  for (int death = 0; death < kDeaths; ++death) {
    BrickProgram program;
    ASSERT_TRUE(program.drive(1));
    const auto ms = program.ms_until_stopped([&] { harm(program); });
    ASSERT_TRUE(ms) << name;
    off_ms.push_back(*ms);
  }
  const double least_ms = *std::min_element(off_ms.begin(), off_ms.end());
  std::printf("ev3_crash_off_ms %s: median %.1f, least %.1f\n", name, median(off_ms), least_ms);
  EXPECT_LE(least_ms, kLimitMs) << name;
}

TEST(Ev3Guard, StopsMotorsOfARobotThatIsKilled) {
  expect_off_in_time("kill -9", [](BrickProgram& program) { ::kill(program.robot(), SIGKILL); });
}

TEST(Ev3Guard, StopsMotorsOfARobotThatCrashes) {
  expect_off_in_time("crash", [](BrickProgram& program) { ::kill(program.robot(), SIGSEGV); });
}

TEST(Ev3Guard, StopsMotorsOfARobotThatHangs) {
  expect_off_in_time("hang", [](BrickProgram& program) { ::kill(program.robot(), SIGSTOP); });
}

TEST(Ev3Guard, RobotStopsMotorsWhenItsGuardIsKilled) {
  expect_off_in_time("guard killed",
                     [](BrickProgram& program) { ::kill(program.guard(), SIGKILL); });
}

TEST(Ev3Guard, SignalsThatEndItStopTheMotorsFirst) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    BrickProgram program;
    ASSERT_TRUE(program.drive(1));
    EXPECT_TRUE(program.ms_until_stopped([&] { ::kill(program.guard(), signal); }));
    EXPECT_EQ(program.end(), 0);
    EXPECT_EQ(program.robot(), 0);
  }
}

TEST(Ev3Guard, HostThatHangsUpEndsIt) {
  BrickProgram program;
  ASSERT_TRUE(program.drive(1));
  EXPECT_TRUE(program.ms_until_stopped([&] { program.hang_up(); }));
  EXPECT_EQ(program.end(), 0);
}

TEST(Ev3Guard, StartsTheRobotAgainWithTheCauseAndAnotherBootId) {
  BrickProgram program;
  const auto first = program.connect(1);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->reset_cause, protocol::kResetPowerOn);
  const pid_t dead = program.robot();
  ::kill(dead, SIGKILL);
  ASSERT_TRUE(eventually([&] { return program.robot() != 0 && program.robot() != dead; }));
  const auto second = program.connect(2);
  ASSERT_TRUE(second);
  EXPECT_EQ(second->reset_cause, protocol::kResetWatchdog);
  EXPECT_EQ(second->boot_id, static_cast<std::uint16_t>(first->boot_id + 1));
  EXPECT_TRUE(program.drive(3));
}

}  // namespace
}  // namespace echomap::tests
