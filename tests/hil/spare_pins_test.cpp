// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "hil_mock/runner/aux_wiring.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/geometry/angle.hpp"
#include "tests/hil/on_every_board.hpp"
#include "tests/hil_mock/world/rooms.hpp"

// Parts that the world wires to the spare pins and the bus of each board, as its release firmware
// reads and drives them.
namespace echomap::tests {
namespace {

using protocol::CommandStatus;
using world::PinPart;
using world::PinWire;

/// A pin of each board that reads voltages, and its supply.
struct VoltagePin {
  std::size_t pin;
  double supply_mv;
};
const std::map<std::string, VoltagePin> voltage_pins = {
    {"uno", {5, 5000.0}}, {"mega", {8, 5000.0}}, {"stm32f103", {6, 3300.0}}, {"pico", {6, 3300.0}}};

/// The configuration that fits `wires`, for the functions that are tested here.
protocol::ConfigurePins pins_with(std::size_t battery_pin) {
  protocol::ConfigurePins pins{};
  pins.pin_0 = protocol::kPinCliffLeft | protocol::kPinActiveHigh;
  pins.pin_1 = protocol::kPinWheelDrop;
  pins.pin_5 = battery_pin == 5 ? protocol::kPinBattery : protocol::kPinUnused;
  pins.pin_6 = battery_pin == 6 ? protocol::kPinBattery : protocol::kPinUnused;
  pins.pin_8 = battery_pin == 8 ? protocol::kPinBattery : protocol::kPinUnused;
  return pins;
}

class SparePins : public OnEveryBoard {
 protected:
  /// Lets the world go along with the board from here on.
  void wire(world::RobotWorld& world) {
    wiring.emplace(robot.board(), world);
    robot.each_ms = [this, &world] {
      world::EncoderChanges changes;
      world.step(1e-3, duty, changes);
      wiring->drive_inputs();
      if (stepper) {
        stepper->step(1e-3, wiring->coils());
      }
    };
  }

  world::WheelDuty duty;
  std::optional<runner::AuxWiring> wiring;
  std::optional<world::StepperMotor> stepper;
};

INSTANTIATE_TEST_SUITE_P(Boards, SparePins, every_board(), image_label);

TEST_P(SparePins, LevelsAndVoltagesReachTheHost) {
  const std::string board = robot.board().board_name();
  const VoltagePin voltage = voltage_pins.at(board);
  world::RobotParams body;
  body.parts.cliffs = {{world::CliffPlace::kLeft, {0.05, 0.05}}};
  body.parts.battery = world::BatteryParams{};
  body.parts.battery->divider = 0.3;
  world::PinWires& wires = body.wiring[board];
  wires[0] = PinWire{PinPart::kCliffLeft, true};
  wires[1] = PinWire{PinPart::kWheelDrop, false};
  wires.at(voltage.pin) = PinWire{PinPart::kBattery, false};
  world::RobotWorld world(world::box_room(), body, 1);
  wire(world);
  ASSERT_TRUE(robot.connect());
  ASSERT_EQ(robot.command(pins_with(voltage.pin)), CommandStatus::kAccepted);
  robot.run_ms(1500);
  EXPECT_EQ(robot.last<protocol::Status>().value().hazards, 0);
  const double expected =
      1000.0 * 0.3 * world.parts().battery().value().volts() * 1024.0 / voltage.supply_mv;
  EXPECT_NEAR(robot.last<protocol::Health>().value().battery_raw, expected, 4.0);

  world.lift();
  robot.run_ms(300);
  EXPECT_EQ(robot.last<protocol::Status>().value().hazards,
            protocol::kHazardCliffLeft | protocol::kHazardWheelDrop);
}

TEST_P(SparePins, AStepperTurnsTheSonarAllTheWayRoundAndBack) {
  const auto path = files::bundled_file("nxt_tribot", "hil_mock/robots", "robot");
  world::RobotWorld world(world::box_room(), world::read_robot(files::TomlReader::load(path)), 1);
  stepper.emplace(world.robot().parts.stepper.value());
  wire(world);
  ASSERT_TRUE(robot.connect());
  protocol::ConfigurePins pins{};
  pins.pin_0 = protocol::kPinStepperPhaseA;
  pins.pin_1 = protocol::kPinStepperPhaseA + 1;
  pins.pin_2 = protocol::kPinStepperPhaseA + 2;
  pins.pin_3 = protocol::kPinStepperPhaseA + 3;
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::ConfigurePan{0, 1, 0, 0, 4076, -72000, 72000, 50}),
            CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 36000, 9000, 20}), CommandStatus::kAccepted);
  robot.run_ms(9000);
  EXPECT_EQ(robot.all<protocol::Echo>().size(), 5U);
  EXPECT_NEAR(geometry::degrees(stepper->pan_rad()), 360.0, 0.2);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 0, 9000, 20}), CommandStatus::kAccepted);
  robot.run_ms(8500);
  EXPECT_NEAR(geometry::degrees(stepper->pan_rad()), 0.0, 0.2) << "no step was lost";
}

TEST_P(SparePins, AGyroOnTheBusFollowsATurn) {
  constexpr int kPeriodMs = 10;
  constexpr double kCountsPerDegPerS = 65.5;
  world::RobotParams body;
  body.parts.gyro = world::GyroParams{0.0, 0.0, 0.0, 0.005};
  world::RobotWorld world(world::box_room(), body, 1);
  wire(world);
  ASSERT_TRUE(robot.connect());
  ASSERT_EQ(robot.command(protocol::ConfigureSensors{0, 0, kPeriodMs, 1}),
            CommandStatus::kAccepted);
  robot.run_ms(500);
  const auto resting = robot.last<protocol::Gyro>().value();
  duty = {-0.4, 0.4};
  robot.run_ms(2000);
  duty = {};
  robot.run_ms(500);
  const auto after = robot.last<protocol::Gyro>().value();
  EXPECT_EQ(after.errors, resting.errors);
  EXPECT_NEAR(std::uint16_t(after.samples - resting.samples), 2500 / kPeriodMs, 3);
  const double turned_deg =
      double(after.yaw_sum - resting.yaw_sum) * 1e-3 * kPeriodMs / kCountsPerDegPerS;
  EXPECT_GT(turned_deg, 90.0);
  EXPECT_NEAR(
      geometry::angle_between(world.T_world_robot().heading_rad(), geometry::radians(turned_deg)),
      0.0,
      geometry::radians(1.0));
}

}  // namespace
}  // namespace echomap::tests
