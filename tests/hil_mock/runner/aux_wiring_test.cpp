// SPDX-License-Identifier: MIT
#include "hil_mock/runner/aux_wiring.hpp"

#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/toml_reader.hpp"
#include "tests/hil_mock/runner/fake_board.hpp"
#include "tests/hil_mock/world/rooms.hpp"

namespace echomap::runner {
namespace {

using world::PinPart;

/// One of each kind of part, on pins 0 .. 4.
world::RobotParams wired_robot() {
  world::RobotParams robot;
  robot.name = "wired";
  robot.parts.cliffs = {{world::CliffPlace::kLeft, {0.0, 0.0}}};
  robot.parts.ranges = {{5, world::IrKind::kGp2y0a21, {}}};
  robot.parts.gyro = world::GyroParams{};
  robot.parts.stepper = world::StepperParams{};
  world::PinWires& wires = robot.wiring["fake"];
  wires[0] = world::PinWire{PinPart::kCliffLeft, true};
  wires[1] = world::PinWire{PinPart::kWheelDrop, false};
  wires[2] = world::PinWire{PinPart::kStepperA, false};
  wires[3] = world::PinWire{PinPart::kStepperD, false};
  wires[4] = world::PinWire{static_cast<PinPart>(static_cast<int>(PinPart::kRange0) + 5), false};
  return robot;
}

class AuxWiringTest : public testing::Test {
 protected:
  FakeBoard board;
  world::RobotWorld robot_world{world::box_room(), wired_robot(), 1};
  AuxWiring wiring{board, robot_world};
};

TEST_F(AuxWiringTest, LevelsAreThoseOfTheWireFromTheStart) {
  EXPECT_EQ(board.aux_levels[0], false);
  EXPECT_EQ(board.aux_levels[1], true);
  robot_world.lift();
  wiring.drive_inputs();
  EXPECT_EQ(board.aux_levels[0], true);
  EXPECT_EQ(board.aux_levels[1], false);
}

TEST_F(AuxWiringTest, VoltagesGoToTheirPin) {
  world::EncoderChanges changes;
  robot_world.place({3.5, 1.5, 0.0});
  robot_world.step(0.001, {}, changes);
  wiring.drive_inputs();
  EXPECT_NEAR(board.aux_millivolts[4].value(), 600.0, 60.0);
}

TEST_F(AuxWiringTest, CoilsAreTheOutputsOfTheirPins) {
  board.aux_outputs[3] = true;
  EXPECT_EQ(wiring.coils(), (world::Coils{false, false, false, true}));
  EXPECT_EQ(board.aux_levels[3], std::nullopt) << "nobody drives an output from outside";
}

TEST_F(AuxWiringTest, TheGyroIsOnTheBus) {
  EXPECT_EQ(board.two_wire_device, robot_world.parts().gyro());
}

TEST(AuxWiring, PulsesOfATubeComeAStepLaterAtTheirPlace) {
  world::RobotParams robot;
  robot.parts.scalar = world::ScalarSensorParams{};
  robot.parts.scalar->pulse_s = 150e-6;
  robot.wiring["fake"][7] = world::PinWire{PinPart::kScalarPulses, false};
  world::FloorMarks marks;
  marks.backgrounds.radiation_per_s = 1000.0;
  FakeBoard board;
  world::RobotWorld robot_world(
      {"hot", {world::rectangle(0.0, 0.0, 4.0, 3.0), {}}, {}, {2.0, 1.5, 0.0}, marks}, robot, 1);
  AuxWiring wiring(board, robot_world);
  EXPECT_EQ(board.aux_levels[7], true) << "high at rest";
  std::size_t before = 0;
  for (int ms = 1; ms <= 200; ++ms) {
    board.time_ns = ms * 1'000'000;
    world::EncoderChanges changes;
    robot_world.step(1e-3, {}, changes);
    wiring.drive_inputs();
    for (; before < board.aux_pulses.size(); ++before) {
      const FakeBoard::AuxPulse& pulse = board.aux_pulses[before];
      EXPECT_EQ(pulse.pin, 7U);
      EXPECT_GE(pulse.fall_ns, board.time_ns);
      EXPECT_LT(pulse.fall_ns, board.time_ns + 1'000'000);
      EXPECT_EQ(pulse.rise_ns - pulse.fall_ns, 150'000);
    }
  }
  EXPECT_GT(before, 100U);
}

TEST(AuxWiring, ABareRobotDrivesNoPin) {
  FakeBoard board;
  world::RobotWorld robot_world(world::box_room(), {}, 1);
  AuxWiring(board, robot_world).drive_inputs();
  EXPECT_THAT(board.aux_levels, testing::Each(std::nullopt));
  EXPECT_EQ(board.two_wire_device, nullptr);
}

TEST(AuxWiring, ARobotThatIsWiredForOtherBoardsIsRefused) {
  FakeBoard board;
  board.board = "uno";
  world::RobotWorld robot_world(world::box_room(), wired_robot(), 1);
  try {
    AuxWiring(board, robot_world);
    FAIL() << "no error";
  } catch (const files::ConfigError& error) {
    EXPECT_THAT(
        error.what(),
        testing::HasSubstr("wired is not wired for the board uno; its file has [wiring] for: fake\n"
                           "  next: run it on one of these, or add [wiring.uno] to its file"));
  }
}

}  // namespace
}  // namespace echomap::runner
