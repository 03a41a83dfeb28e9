// SPDX-License-Identifier: MIT
#include "firmware/drivers/pan_drive.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"

namespace echomap::drivers {
namespace {

constexpr protocol::ConfigurePan kServo{0, 0, 1500, 900, 0, -9000, 9000, 300};
constexpr protocol::ConfigurePan kStepper{0, 1, 0, 0, 4096, -36000, 36000, 60};

protocol::ConfigurePins phases() {
  protocol::ConfigurePins pins{};
  pins.pin_0 = protocol::kPinStepperPhaseA;
  pins.pin_1 = protocol::kPinStepperPhaseA + 1;
  pins.pin_2 = protocol::kPinStepperPhaseA + 2;
  pins.pin_3 = protocol::kPinStepperPhaseA + 3;
  return pins;
}

class PanDriveTest : public testing::Test {
 protected:
  PanDriveTest() { board.power_on(); }
  /// Milliseconds until it looks there.
  int turn(std::int32_t pan_cdeg) {
    pan.turn_to(pan_cdeg);
    int ms = 1;
    while (!pan.tick() && ms < 100000) {
      ++ms;
    }
    return ms;
  }

  native::NativeBoard& board = native::NativeBoard::instance();
  protocol::ConfigurePins active_pins{};
  SparePins pins{active_pins};
  protocol::ConfigurePan settings = kServo;
  PanDrive pan{settings, pins};
};

TEST_F(PanDriveTest, ServoTakesItsTravelAndAFrame) {
  EXPECT_EQ(turn(0), 600 + 20) << "it may come from anywhere";
  EXPECT_EQ(turn(600), 20 + 20);
  EXPECT_EQ(board.pan_pulse_us(), 1560);
}

TEST_F(PanDriveTest, ServoStoppedInMidTurnMayStandAnywhere) {
  turn(-9000);
  pan.turn_to(9000);
  pan.tick();
  pan.rest();
  EXPECT_EQ(turn(9000), 600 + 20);
}

TEST_F(PanDriveTest, ServoAtRestKnowsWhereItStands) {
  turn(-9000);
  pan.rest();
  EXPECT_EQ(turn(-8400), 20 + 20);
}

TEST_F(PanDriveTest, StepperTurnsOnItsPinsAndLeavesTheServoAlone) {
  pins.configure(phases());
  pan.configure(kStepper);
  EXPECT_NEAR(turn(36000), 6000, 10);
  EXPECT_EQ(board.pan_pulse_us(), 0.0);
  pan.rest();
  for (std::uint8_t pin = 0; pin < 4; ++pin) {
    EXPECT_FALSE(board.aux_output(pin));
  }
}

TEST_F(PanDriveTest, ReachesItsLimitsOnly) {
  EXPECT_TRUE(pan.reaches(9000));
  EXPECT_TRUE(pan.reaches(-9000));
  EXPECT_FALSE(pan.reaches(9001));
  EXPECT_FALSE(pan.reaches(-9001));
}

TEST_F(PanDriveTest, StepperReachesNothingWithoutItsPhases) {
  pan.configure(kStepper);
  EXPECT_FALSE(pan.reaches(0));
  pins.configure(phases());
  EXPECT_TRUE(pan.reaches(0));
  EXPECT_TRUE(pan.reaches(36000));
  EXPECT_FALSE(pan.reaches(36001));
}

TEST_F(PanDriveTest, KeepsCountOfTheStepsThroughAConfiguration) {
  pins.configure(phases());
  pan.configure(kStepper);
  turn(18000);
  pan.configure(kStepper);
  EXPECT_NEAR(turn(0), 3000, 10);
}

TEST_F(PanDriveTest, AcceptsServoAndStepperOnly) {
  EXPECT_TRUE(PanDrive::accepts(kServo));
  EXPECT_TRUE(PanDrive::accepts(kStepper));
  protocol::ConfigurePan other = kServo;
  other.kind = 2;
  EXPECT_FALSE(PanDrive::accepts(other));
  struct Reach {
    protocol::ConfigurePan settings;
    std::int32_t limit_cdeg;
  };
  for (Reach reach : {Reach{kServo, 18000}, Reach{kStepper, 72000}}) {
    protocol::ConfigurePan& far = reach.settings;
    far.us_per_90deg = 100;
    far.min_cdeg = -reach.limit_cdeg;
    far.max_cdeg = reach.limit_cdeg;
    EXPECT_TRUE(PanDrive::accepts(far));
    ++far.max_cdeg;
    EXPECT_FALSE(PanDrive::accepts(far)) << "a servo does not turn round, a stepper twice";
    --far.max_cdeg;
    --far.min_cdeg;
    EXPECT_FALSE(PanDrive::accepts(far));
  }
  for (protocol::ConfigurePan broken : {kServo, kStepper}) {
    broken.deg_per_s = 0;
    EXPECT_FALSE(PanDrive::accepts(broken));
    broken.deg_per_s = 10;
    broken.min_cdeg = broken.max_cdeg + 1;
    EXPECT_FALSE(PanDrive::accepts(broken));
  }
}

}  // namespace
}  // namespace echomap::drivers
