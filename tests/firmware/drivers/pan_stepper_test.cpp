// SPDX-License-Identifier: MIT
#include "firmware/drivers/pan_stepper.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"

namespace echomap::drivers {
namespace {

/// Follows the coils as a rotor does: to the half step next to where it stands. A jump of two or
/// more it cannot follow.
class Rotor {
 public:
  std::int32_t steps = 0;
  int jumps = 0;

  void see(unsigned phases) {
    constexpr unsigned kHalfSteps[8] = {1, 3, 2, 6, 4, 12, 8, 9};
    for (int direction : {0, 1, -1}) {
      if (phases == kHalfSteps[(steps + direction) & 7]) {
        steps += direction;
        return;
      }
    }
    jumps += phases == 0 ? 0 : 1;
  }
};

class PanStepperTest : public testing::Test {
 protected:
  PanStepperTest() {
    board.power_on();
    protocol::ConfigurePins phases{};
    phases.pin_0 = protocol::kPinStepperPhaseA;
    phases.pin_1 = protocol::kPinStepperPhaseA + 1;
    phases.pin_2 = protocol::kPinStepperPhaseA + 2;
    phases.pin_3 = protocol::kPinStepperPhaseA + 3;
    pins.configure(phases);
  }
  /// Phases of the four pins now.
  unsigned phases() const {
    unsigned levels = 0;
    for (unsigned i = 0; i < 4; ++i) {
      levels |= board.aux_output(static_cast<std::uint8_t>(i)) ? 1U << i : 0U;
    }
    return levels;
  }
  /// Milliseconds that it takes to get there.
  int turn(std::int32_t pan_cdeg) {
    stepper.turn_to(settings, pan_cdeg);
    int ms = 0;
    while (!stepper.tick(pins) && ms < 100000) {
      ++ms;
      rotor.see(phases());
    }
    return ms;
  }

  native::NativeBoard& board = native::NativeBoard::instance();
  protocol::ConfigurePins active{};
  SparePins pins{active};
  protocol::ConfigurePan settings{0, 1, 0, 0, 4096, -36000, 36000, 60};
  PanStepper stepper;
  Rotor rotor;
};

TEST_F(PanStepperTest, TakesEveryStepAtItsSpeed) {
  const int ms = turn(9000);
  EXPECT_EQ(rotor.steps, 1024);
  EXPECT_NEAR(ms, 1500, 4) << "90 degrees at 60 a second";
  EXPECT_EQ(rotor.jumps, 0);
}

TEST_F(PanStepperTest, UnwindsWhatItHasWoundUp) {
  turn(-36000);
  EXPECT_EQ(rotor.steps, -4096);
  turn(36000);
  EXPECT_EQ(rotor.steps, 4096) << "two turns to the left, not to the nearest equal direction";
  turn(0);
  EXPECT_EQ(rotor.steps, 0);
  EXPECT_EQ(rotor.jumps, 0);
}

TEST_F(PanStepperTest, NegativeStepsTurnTheOtherWay) {
  settings.steps_per_turn = -2048;
  turn(18000);
  EXPECT_EQ(rotor.steps, -1024);
}

TEST_F(PanStepperTest, RoundingDoesNotAddUpOverManySweeps) {
  settings.steps_per_turn = 4076;
  for (int sweep = 0; sweep < 20; ++sweep) {
    for (std::int32_t pan = -9000; pan <= 9000; pan += 700) {
      turn(pan);
    }
    turn(0);
    EXPECT_EQ(rotor.steps, 0) << sweep;
  }
}

TEST_F(PanStepperTest, CoilsAreHeldOnTheWayAndOffAtRest) {
  turn(4500);
  EXPECT_NE(phases(), 0U);
  stepper.rest(pins);
  EXPECT_EQ(phases(), 0U);
}

TEST_F(PanStepperTest, RestInMidTurnStaysThereAndKnowsWhere) {
  stepper.turn_to(settings, 9000);
  for (int ms = 0; ms < 700; ++ms) {
    stepper.tick(pins);
    rotor.see(phases());
  }
  stepper.rest(pins);
  EXPECT_TRUE(stepper.tick(pins));
  EXPECT_NEAR(rotor.steps, 477, 2);
  turn(0);
  EXPECT_EQ(rotor.steps, 0);
  EXPECT_EQ(rotor.jumps, 0);
}

TEST_F(PanStepperTest, NeverStepsTwiceInAMillisecond) {
  settings.deg_per_s = 87;
  const int ms = turn(36000);
  EXPECT_EQ(rotor.steps, 4096);
  EXPECT_EQ(rotor.jumps, 0);
  EXPECT_GE(ms, 4096);
}

TEST_F(PanStepperTest, RefusesWhatIsTooFineOrTooFast) {
  EXPECT_TRUE(PanStepper::accepts(settings));
  settings.deg_per_s = 88;
  EXPECT_FALSE(PanStepper::accepts(settings)) << "more than a step a millisecond";
  settings.deg_per_s = 10;
  settings.steps_per_turn = 8193;
  EXPECT_FALSE(PanStepper::accepts(settings));
  settings.steps_per_turn = -8193;
  EXPECT_FALSE(PanStepper::accepts(settings));
  settings.steps_per_turn = 0;
  EXPECT_FALSE(PanStepper::accepts(settings));
}

}  // namespace
}  // namespace echomap::drivers
