// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "hil_mock/world/robot_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/geometry/angle.hpp"
#include "host/session/robot_profile.hpp"

// A bundled robot has two files, what the host believes and what is true; what was soldered and
// where its sensors sit must be the same in both.
namespace echomap::session {
namespace {

using Pins = std::array<int, 16>;

/// The pins of the message field by field; a visitor of its fields.
struct TakePins {
  Pins pins{};
  std::size_t next = 0;
  void operator()(std::string_view name, std::uint8_t pin) {
    if (name != "command_id") {
      pins.at(next++) = pin;
    }
  }
};

Pins configured(const RobotProfile& profile) {
  TakePins take;
  protocol::ConfigurePins::each(profile.configuration.pins, take);
  return take.pins;
}

int function_of(const world::PinWire& wire) {
  const int part = static_cast<int>(wire.part);
  constexpr int kRange0 = static_cast<int>(world::PinPart::kRange0);
  constexpr int kStepperA = static_cast<int>(world::PinPart::kStepperA);
  if (part >= kStepperA) {
    return protocol::kPinStepperPhaseA + part - kStepperA;
  }
  if (part >= kRange0) {
    return protocol::kPinRange0 + part - kRange0;
  }
  switch (wire.part) {
    case world::PinPart::kBattery:
      return protocol::kPinBattery;
    case world::PinPart::kScalarPulses:
      return protocol::kPinScalarPulses;
    case world::PinPart::kScalarLevel:
      return protocol::kPinScalarLevel;
    default:
      return (protocol::kPinCliffLeft + part) | (wire.active_high ? protocol::kPinActiveHigh : 0);
  }
}

Pins soldered(const world::PinWires& wires) {
  Pins pins{};
  for (std::size_t i = 0; i < wires.size(); ++i) {
    pins.at(i) = wires.at(i) ? function_of(*wires.at(i)) : protocol::kPinUnused;
  }
  return pins;
}

class BundledRobot : public testing::TestWithParam<const char*> {
 protected:
  RobotProfile profile = load_robot_profile(GetParam());
  world::RobotParams body = world::read_robot(
      files::TomlReader::load(files::bundled_file(GetParam(), "hil_mock/robots", "robot")));
};

TEST_P(BundledRobot, IsConfiguredAsItIsWiredOnEachOfItsBoards) {
  for (const auto& [board, wires] : body.wiring) {
    EXPECT_EQ(configured(profile), soldered(wires)) << board;
  }
  if (body.wiring.empty()) {
    EXPECT_EQ(configured(profile), Pins{});
  }
}

TEST_P(BundledRobot, HasTheSensorsThatItsProfileAsksFor) {
  const bool has_stepper =
      profile.configuration.pan.kind == static_cast<std::uint8_t>(protocol::PanKind::kStepper);
  EXPECT_EQ(profile.has_sonar, body.has_sonar);
  EXPECT_EQ(has_stepper, body.parts.stepper.has_value());
  EXPECT_TRUE(body.parts.gyro || !profile.sensors.gyro);
  EXPECT_EQ(profile.sensors.infrared.size(), body.parts.ranges.size());
}

TEST_P(BundledRobot, BelievesItsInfraredSensorsWhereTheySit) {
  for (const sensors::InfraredSensor& believed : profile.sensors.infrared) {
    for (const world::IrRangeParams& truth : body.parts.ranges) {
      if (truth.channel == believed.channel) {
        const geometry::Pose2 apart = truth.T_robot_sensor.inverse() * believed.T_robot_sensor;
        EXPECT_LT(apart.position_m().norm(), 1e-3) << truth.channel;
        EXPECT_NEAR(apart.heading_rad(), 0.0, 1e-9) << truth.channel;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    BundledRobot,
    testing::Values("uno_2wd", "nxt_tribot", "create", "epuck", "ev3", "ev3_mega"),
    [](const auto& robot) { return std::string(robot.param); });

}  // namespace
}  // namespace echomap::session
