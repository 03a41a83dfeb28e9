// SPDX-License-Identifier: MIT
#include "firmware/tasks/safety.hpp"

#include <gtest/gtest.h>

#include "firmware/app/settings.hpp"
#include "firmware/boards/native/native_board.hpp"

namespace echomap::tasks {
namespace {

using protocol::MotionOutcome;

class SafetyTest : public testing::Test {
 protected:
  ~SafetyTest() override {
    press(false);
    motion.stop(MotionOutcome::kStopped);
  }
  static void press(bool pressed) { native::NativeBoard::instance().set_bump(false, pressed); }
  void tick(int times) {
    for (int i = 0; i < times; ++i) {
      safety.tick();
    }
  }
  void move(std::int32_t left, std::int32_t right) {
    motion.start_move(protocol::MoveTicks{3, left, right, 100, 0});
  }
  MotionOutcome outcome() const { return motion.report().outcome; }

  drivers::WheelEncoders encoders;
  protocol::ConfigureDrive settings = app::kDefaultDrive;
  control::WheelMotion motion{encoders, settings};
  Safety safety{motion};
};

TEST_F(SafetyTest, StartsDisarmed) { EXPECT_FALSE(safety.armed()); }

TEST_F(SafetyTest, DisarmingStopsTheWheels) {
  safety.arm();
  move(100, 100);
  safety.disarm();
  EXPECT_FALSE(safety.armed());
  EXPECT_FALSE(motion.moving());
  EXPECT_EQ(outcome(), MotionOutcome::kStopped);
}

TEST_F(SafetyTest, MotionExpiresToTheMillisecondUnlessRenewed) {
  move(100, 100);
  safety.renew(50);
  tick(49);
  EXPECT_EQ(outcome(), MotionOutcome::kRunning);
  safety.renew(30);
  tick(29);
  EXPECT_EQ(outcome(), MotionOutcome::kRunning);
  tick(1);
  EXPECT_EQ(outcome(), MotionOutcome::kExpired);
}

TEST_F(SafetyTest, ZeroStandsForTheDefaultTimeToLive) {
  move(100, 100);
  safety.renew(0);
  tick(protocol::kDefaultTimeToLiveMs - 1);
  EXPECT_EQ(outcome(), MotionOutcome::kRunning);
  tick(1);
  EXPECT_EQ(outcome(), MotionOutcome::kExpired);
}

TEST_F(SafetyTest, AcceptsHalfASecondAtMost) {
  EXPECT_TRUE(Safety::accepts_time_to_live(500));
  EXPECT_FALSE(Safety::accepts_time_to_live(501));
}

TEST_F(SafetyTest, PressStopsForwardMotionAndTurnsButNotBackingOff) {
  struct Case {
    std::int32_t left, right;
    MotionOutcome expected;
  };
  for (const Case& one : {Case{100, 100, MotionOutcome::kBumped},
                          Case{100, -100, MotionOutcome::kBumped},
                          Case{-100, -100, MotionOutcome::kRunning}}) {
    press(false);
    tick(drivers::Contacts::kReleaseMs);
    move(one.left, one.right);
    tick(1);
    press(true);
    tick(1);
    EXPECT_EQ(outcome(), one.expected) << one.left << ' ' << one.right;
    motion.stop(MotionOutcome::kStopped);
  }
}

TEST_F(SafetyTest, HeldContactLetsTheRobotTurnAwayButNotGoOn) {
  press(true);
  tick(1);
  EXPECT_TRUE(safety.blocks(100, 100));
  EXPECT_TRUE(safety.blocks(100, -99));
  EXPECT_FALSE(safety.blocks(100, -100));
  EXPECT_FALSE(safety.blocks(-100, -100));
  move(100, -100);
  tick(5);
  EXPECT_EQ(outcome(), MotionOutcome::kRunning);
  motion.drive(50, 60);
  tick(1);
  EXPECT_EQ(outcome(), MotionOutcome::kBumped);
}

/// Neither a set-point of zero nor one backwards stops the wheels at once: until they stand the
/// robot still goes forward.
TEST_F(SafetyTest, BumpStopsARobotThatIsStillGoingForward) {
  for (const std::int16_t then : {std::int16_t{0}, std::int16_t{-1000}}) {
    press(false);
    tick(drivers::Contacts::kReleaseMs);
    motion.drive(1000, 1000);
    for (int i = 0; i < 100; ++i) {
      motion.step();
    }
    motion.drive(then, then);
    motion.step();
    press(true);
    tick(1);
    EXPECT_FALSE(motion.moving()) << "then " << then;
  }
}

TEST_F(SafetyTest, NothingIsBlockedWithoutAContact) { EXPECT_FALSE(safety.blocks(100, 100)); }

}  // namespace
}  // namespace echomap::tasks
