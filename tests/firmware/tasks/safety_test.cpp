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
  /// There are no wheels, so none turns.
  SafetyTest() { configuration.safety.stall_ms = 0; }
  ~SafetyTest() override {
    press(false);
    show(0);
    motion.stop(MotionOutcome::kStopped);
  }
  /// Cliffs on pins 0 .. 3, wheel-drop on 4, virtual wall on 5, wall on 6, all active low.
  void use_hazard_pins() {
    protocol::ConfigurePins pins{};
    std::uint8_t* const functions[] = {
        &pins.pin_0, &pins.pin_1, &pins.pin_2, &pins.pin_3, &pins.pin_4, &pins.pin_5, &pins.pin_6};
    std::uint8_t function = protocol::kPinCliffLeft;
    for (std::uint8_t* const pin : functions) {
      *pin = function++;
    }
    sensors.configure(pins);
  }
  /// Shows these hazards on the pins.
  static void show(unsigned hazards) {
    for (std::uint8_t pin = 0; pin < 7; ++pin) {
      native::NativeBoard::instance().set_aux_level(pin, (hazards >> pin & 1U) == 0);
    }
  }
  static void press(bool pressed) { native::NativeBoard::instance().set_bump(false, pressed); }
  void tick(int times) {
    for (int i = 0; i < times; ++i) {
      sensors.tick();
      safety.tick();
    }
  }
  void move(std::int32_t left, std::int32_t right) {
    motion.start_move(protocol::MoveTicks{3, left, right, 100, 0});
  }
  MotionOutcome outcome() const { return motion.report().outcome; }

  drivers::WheelEncoders encoders;
  protocol::Configuration configuration = app::kDefaultConfiguration;
  control::WheelMotion motion{encoders, configuration.drive, configuration.safety};
  Sensors sensors{configuration.pins, configuration.sensors, configuration.scalar};
  Safety safety{motion, sensors, configuration.safety, configuration.wiring};
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
    tick(drivers::Contacts::kMaxReleaseMs);
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
    tick(drivers::Contacts::kMaxReleaseMs);
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

TEST_F(SafetyTest, EveryHazardOfTheSettingsStopsTheWheelsAndNoOther) {
  use_hazard_pins();
  for (const unsigned bit : {0U, 1U, 2U, 3U, 5U, 6U}) {
    for (const bool stops : {false, true}) {
      show(0);
      tick(drivers::DebouncedBits::kMaxReleaseMs);
      configuration.safety.hazard_stops = static_cast<std::uint8_t>(stops ? 1U << bit : 0U);
      move(100, 100);
      show(1U << bit);
      tick(1);
      const MotionOutcome expected = stops ? MotionOutcome::kHazard : MotionOutcome::kRunning;
      EXPECT_EQ(outcome(), expected) << "bit " << bit;
      motion.stop(MotionOutcome::kStopped);
    }
  }
}

TEST_F(SafetyTest, HazardLetsTheRobotBackOffAndTurnAway) {
  use_hazard_pins();
  struct Case {
    std::int32_t left, right;
    MotionOutcome at_its_begin, while_it_lasts;
  };
  for (const Case& one : {Case{100, 100, MotionOutcome::kHazard, MotionOutcome::kHazard},
                          Case{100, -100, MotionOutcome::kHazard, MotionOutcome::kRunning},
                          Case{-100, -100, MotionOutcome::kRunning, MotionOutcome::kRunning}}) {
    show(0);
    tick(drivers::DebouncedBits::kMaxReleaseMs);
    move(one.left, one.right);
    show(protocol::kHazardCliffFrontLeft);
    tick(1);
    EXPECT_EQ(outcome(), one.at_its_begin) << one.left << ' ' << one.right;
    motion.stop(MotionOutcome::kStopped);
    tick(5);
    EXPECT_EQ(safety.blocks(one.left, one.right), one.while_it_lasts == MotionOutcome::kHazard);
    move(one.left, one.right);
    tick(1);
    EXPECT_EQ(outcome(), one.while_it_lasts) << one.left << ' ' << one.right;
    motion.stop(MotionOutcome::kStopped);
  }
}

TEST_F(SafetyTest, SetpointGoesOnBackwardsOverACliffButNotForwards) {
  use_hazard_pins();
  motion.drive(500, 500);
  show(protocol::kHazardCliffLeft);
  tick(1);
  EXPECT_FALSE(motion.moving());
  EXPECT_TRUE(safety.blocks(500, 500));
  EXPECT_FALSE(safety.blocks(-500, -500));
}

TEST_F(SafetyTest, WheelDropStopsWhateverMovesAndDisarms) {
  use_hazard_pins();
  configuration.safety.hazard_stops = 0;
  for (const std::int32_t ticks : {100, -100}) {
    show(0);
    tick(drivers::DebouncedBits::kMaxReleaseMs);
    ASSERT_TRUE(safety.arm());
    move(ticks, ticks);
    show(protocol::kHazardWheelDrop);
    tick(1);
    EXPECT_FALSE(motion.moving());
    EXPECT_FALSE(safety.armed());
    EXPECT_EQ(outcome(), MotionOutcome::kLifted);
  }
}

TEST_F(SafetyTest, WheelDropIsToldOfAStandingRobotToo) {
  use_hazard_pins();
  safety.arm();
  show(protocol::kHazardWheelDrop);
  tick(1);
  show(0);
  tick(100);
  EXPECT_FALSE(safety.armed()) << "stays so when it is put back";
  EXPECT_EQ(outcome(), MotionOutcome::kLifted);
}

TEST_F(SafetyTest, CannotBeArmedWhileAWheelHangs) {
  use_hazard_pins();
  show(protocol::kHazardWheelDrop);
  tick(1);
  EXPECT_FALSE(safety.arm());
  EXPECT_FALSE(safety.armed());
  show(0);
  tick(drivers::DebouncedBits::kMaxReleaseMs);
  EXPECT_TRUE(safety.arm());
}

TEST_F(SafetyTest, NothingIsBlockedWithoutAContact) { EXPECT_FALSE(safety.blocks(100, 100)); }

}  // namespace
}  // namespace echomap::tasks
