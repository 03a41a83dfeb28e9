// SPDX-License-Identifier: MIT
/// Hangs planted in the flash of the release image, in each task and each interrupt that a driving
/// robot runs. AVR boards only; what every board shows is in safety_test.cpp.
#include <cstdio>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil/measure/planted_hangs.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

class PlantedHang : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, PlantedHang, every_board(), image_label);

/// The start runs through it, too: planted there, a hang is met again, with the motors off.
bool is_on_the_way_of_the_start(const std::string& file) {
  return file.ends_with("/motors.cpp") || file.ends_with("/motor_bridge.cpp");
}

void expect_off(const std::string& where, const HangOutcome& outcome, bool starts_again = true) {
  std::printf("hang in %s: PWM off %.1f ms, reset %.1f ms behind it\n",
              where.c_str(),
              outcome.off_ms,
              outcome.reset_ms);
  EXPECT_LE(outcome.off_ms, 150.0) << where;
  if (starts_again) {
    EXPECT_LE(outcome.reset_ms, 300.0) << where;
  }
  EXPECT_TRUE(outcome.stayed_off) << where;
}

/// No interrupt of the watchdog can come then: its reset switches the motors off.
TEST_P(PlantedHang, WithInterruptsLockedIsReset) {
  RobotOnTheMove moving{release_image(GetParam())};
  moving.drive();
  hang_with_interrupts_locked(moving);
  const HangOutcome outcome = moving.outcome_of_hang();
  expect_off("a lock of interrupts", outcome);
  EXPECT_EQ(outcome.reset_cause, protocol::kResetWatchdog);
  ASSERT_TRUE(moving.robot.connect(4712));
  EXPECT_EQ(moving.robot.command(protocol::MoveTicks{0, 100, 100, 500, 0}),
            protocol::CommandStatus::kDisarmed);
}

/// The old Nano's bootloader would not come back from a reset by the watchdog.
TEST_P(PlantedHang, StartsAgainWithoutAReset) {
  RobotOnTheMove moving{release_image(GetParam())};
  moving.robot.run_ms(50);
  const auto at_power_up = moving.robot.chip().port_registers();
  for (int start = 1; start <= 5; ++start) {
    moving.drive();
    moving.robot.chip().hang();
    const HangOutcome outcome = moving.outcome_of_hang();
    expect_off("an endless loop", outcome);
    EXPECT_EQ(outcome.reset_cause, protocol::kResetWatchdog);
    EXPECT_EQ(moving.robot.chip().resets(), 0U);
    EXPECT_EQ(moving.robot.chip().port_registers(), at_power_up) << "start " << start;
    ASSERT_TRUE(moving.robot.connect());  // With drive()'s session, which it would else refuse.
    moving.robot.forget_heard();
    moving.robot.run_ms(200);
    EXPECT_GE(moving.robot.all<protocol::Odometry>().size(), 9U) << "start " << start;
  }
}

TEST_P(PlantedHang, SwitchesOffWhereverTheProgramHangs) {
  std::set<HangPlace> hung;
  plant_hangs(release_image(GetParam()), [&](const HangPlace& place, const HangOutcome& outcome) {
    expect_off(place.file + (place.in_interrupt ? " (interrupt)" : ""),
               outcome,
               !is_on_the_way_of_the_start(place.file));
    hung.insert(place);
  });
  for (const char* task : {"bulk",
                           "command",
                           "frame_sender",
                           "heartbeat",
                           "line_budget",
                           "safety",
                           "scheduler",
                           "sensors",
                           "telemetry"}) {
    EXPECT_TRUE(hung.contains({std::string("firmware/tasks/") + task + ".cpp", false})) << task;
  }
  for (const char* part : {"tick", "twi", "uart"}) {
    EXPECT_TRUE(hung.contains({std::string("firmware/boards/avr_common/") + part + ".cpp", true}))
        << part;
  }
}

}  // namespace
}  // namespace echomap::tests
