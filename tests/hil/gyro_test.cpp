// SPDX-License-Identifier: MIT
/// The MPU-6050 on the two-wire bus of every board: the release image drives the bus, the emulator
/// has it by the data sheet.
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "hil_mock/world/mpu6050.hpp"
#include "host/geometry/angle.hpp"
#include "tests/hil/measure/loaded_robot.hpp"
#include "tests/hil/on_every_board.hpp"

namespace echomap::tests {
namespace {

using protocol::CommandStatus;

constexpr std::uint8_t kPeriodMs = 10;
constexpr protocol::ConfigureSensors kGyroOn{0, 0, kPeriodMs, 1};
/// Three writes, the first read, and one that Hello or the last message cuts off.
constexpr int kSetUpSamples = 5;

/// Without noise and bias.
world::Mpu6050 ideal_gyro() {
  return world::Mpu6050(
      world::RateGyro({0.0, 0.0, 0.0, 0.0}, world::NoiseStream(1, world::NoisePurpose::kGyro)));
}

/// What a Gyro message says the robot has turned by, with +-500 degrees/s.
double turned_deg(const protocol::Gyro& message) {
  constexpr double kPerDegPerS = 65.5;
  return message.yaw_sum / kPerDegPerS * kPeriodMs * 1e-3;
}

using PinSetting = std::uint8_t protocol::ConfigurePins::*;

/// Two spare pins: the number of the first, and both settings.
struct BusPins {
  unsigned first;
  PinSetting settings[2];
};

/// Those that the bus takes; none on a board whose bus has pins of its own.
std::optional<BusPins> bus_pins_of(const std::string& board) {
  using protocol::ConfigurePins;
  static const std::map<std::string, BusPins> boards{
      {"uno", {3, {&ConfigurePins::pin_3, &ConfigurePins::pin_4}}},
      {"stm32f103", {9, {&ConfigurePins::pin_9, &ConfigurePins::pin_10}}},
      {"pico", {7, {&ConfigurePins::pin_7, &ConfigurePins::pin_8}}},
  };
  const auto found = boards.find(board);
  return found == boards.end() ? std::nullopt : std::optional(found->second);
}

class GyroOnTheBus : public OnEveryBoard {
 protected:
  /// Lets it turn along from here on.
  void turn(double deg_per_s) {
    robot.each_ms = [this, deg_per_s] { gyro.step(1e-3, geometry::radians(deg_per_s)); };
  }

  world::Mpu6050 gyro = ideal_gyro();
};

INSTANTIATE_TEST_SUITE_P(Boards, GyroOnTheBus, every_board(), image_label);

TEST_P(GyroOnTheBus, TurnsReachTheHostBothWays) {
  robot.board().connect(gyro);
  const auto reply = robot.connect();
  ASSERT_TRUE(reply.has_value());
  EXPECT_TRUE((reply->capabilities & protocol::kCapabilityGyro) != 0);
  ASSERT_EQ(robot.command(kGyroOn), CommandStatus::kAccepted);
  robot.run_ms(500);
  const double still_deg = turned_deg(robot.last<protocol::Gyro>().value());
  EXPECT_NEAR(still_deg, 0.0, 0.1);
  turn(90.0);
  robot.run_ms(2000);
  const double left_deg = turned_deg(robot.last<protocol::Gyro>().value());
  EXPECT_NEAR(left_deg - still_deg, 180.0, 3.0) << "two periods and the filter's delay late";
  turn(-45.0);
  robot.run_ms(2000);
  const protocol::Gyro last = robot.last<protocol::Gyro>().value();
  EXPECT_NEAR(turned_deg(last) - left_deg, -90.0, 4.0);
  EXPECT_NEAR(last.samples, 4500 / kPeriodMs, 12);
  EXPECT_LE(last.errors, kSetUpSamples);
}

TEST_P(GyroOnTheBus, WithoutADeviceEverySampleIsAnErrorAndTheRobotGoesOn) {
  ASSERT_TRUE(robot.connect());
  ASSERT_EQ(robot.command(kGyroOn), CommandStatus::kAccepted);
  robot.run_ms(1000);
  const protocol::Gyro last = robot.last<protocol::Gyro>().value();
  EXPECT_GT(last.samples, 90);
  EXPECT_EQ(last.errors, last.samples);
  EXPECT_EQ(last.yaw_sum, 0);
  EXPECT_EQ(robot.command(protocol::Arm{0, 1}), CommandStatus::kAccepted);
  robot.board().connect(gyro);
  turn(90.0);
  robot.run_ms(1000);
  const protocol::Gyro later = robot.last<protocol::Gyro>().value();
  EXPECT_LE(later.errors - last.errors, kSetUpSamples) << "it is found when it is there";
  EXPECT_GT(later.yaw_sum, 0);
}

TEST_P(GyroOnTheBus, ADeviceThatWasCutOffInAByteIsClockedOutOfIt) {
  robot.board().connect(gyro);
  ASSERT_TRUE(robot.connect());
  ASSERT_EQ(robot.command(kGyroOn), CommandStatus::kAccepted);
  robot.run_ms(500);
  const std::uint16_t before = robot.last<protocol::Gyro>().value().errors;
  for (const unsigned bits : {1U, 5U, 9U}) {
    robot.chip().hold_two_wire_bus(bits);
    robot.run_ms(300);
    const std::uint16_t errors = robot.last<protocol::Gyro>().value().errors;
    robot.run_ms(300);
    EXPECT_EQ(robot.last<protocol::Gyro>().value().errors, errors) << bits << " bits";
  }
  EXPECT_GT(robot.last<protocol::Gyro>().value().errors, before);
}

TEST_P(GyroOnTheBus, TheBusIsLeftAloneWhileTheGyroIsOff) {
  robot.board().connect(gyro);
  ASSERT_TRUE(robot.connect());
  ASSERT_EQ(robot.command(kGyroOn), CommandStatus::kAccepted);
  robot.run_ms(500);
  ASSERT_EQ(robot.command(protocol::ConfigureSensors{0, 0, 0, 1}), CommandStatus::kAccepted);
  robot.chip().hold_two_wire_bus(5);
  robot.run_ms(300);
  ASSERT_EQ(robot.command(kGyroOn), CommandStatus::kAccepted);
  robot.run_ms(300);
  const std::uint16_t errors = robot.last<protocol::Gyro>().value().errors;
  robot.run_ms(300);
  EXPECT_EQ(robot.last<protocol::Gyro>().value().errors, errors);
}

TEST_P(GyroOnTheBus, ItsPinsAreSparePinsAgainWhenItIsOff) {
  const auto bus = bus_pins_of(robot.board().board_name());
  if (!bus) {
    EXPECT_EQ(robot.board().board_name(), "mega");
    return;
  }
  robot.board().connect(gyro);
  ASSERT_TRUE(robot.connect());
  ASSERT_EQ(robot.command(kGyroOn), CommandStatus::kAccepted);
  robot.run_ms(100);
  protocol::ConfigurePins pins{};
  pins.pin_0 = protocol::kPinStepperPhaseA;
  pins.pin_1 = protocol::kPinStepperPhaseA + 1;
  pins.pin_2 = protocol::kPinStepperPhaseA + 2;
  pins.*bus->settings[0] = protocol::kPinStepperPhaseA + 3;
  ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::ConfigureSensors{0, 0, 0, 1}), CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::ConfigurePan{0, 1, 0, 0, 4076, -72000, 72000, 50}),
            CommandStatus::kAccepted);
  ASSERT_EQ(robot.command(protocol::StartSweep{0, 0, 9000, 9000, 20}), CommandStatus::kAccepted);
  EXPECT_TRUE(robot.run_until([&] { return robot.board().aux_output(bus->first); }, 1000));
}

TEST_P(GyroOnTheBus, SparePinsThatAreTheBusRefuseTheGyro) {
  constexpr BusPins kNoBus{3, {&protocol::ConfigurePins::pin_3, &protocol::ConfigurePins::pin_4}};
  ASSERT_TRUE(robot.connect());
  const auto bus = bus_pins_of(robot.board().board_name());
  for (const PinSetting setting : bus.value_or(kNoBus).settings) {
    protocol::ConfigurePins pins{};
    pins.*setting = protocol::kPinWheelDrop | protocol::kPinActiveHigh;
    ASSERT_EQ(robot.command(pins), CommandStatus::kAccepted);
    EXPECT_EQ(robot.command(kGyroOn), bus ? CommandStatus::kOutOfRange : CommandStatus::kAccepted);
  }
}

class GyroUnderLoad : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Boards, GyroUnderLoad, every_board(), image_label);

/// The bus at five times the usual rate beside 40,000 edges a second and wheel on a full line.
TEST_P(GyroUnderLoad, BusAndEncodersDoNotHurtEachOther) {
  world::Mpu6050 gyro = ideal_gyro();
  LoadedRobot robot(release_image(GetParam()), {.edges_per_s = 40'000, .odometry_period_ms = 10});
  robot.connect();
  robot.session().board().connect(gyro);
  ASSERT_EQ(robot.session().command(protocol::ConfigureSensors{0, 0, 2, 1}),
            CommandStatus::kAccepted);
  std::uint16_t errors = 0;
  std::uint16_t samples = 0;
  robot.session().each_ms = [&] {
    if (const auto last = robot.session().last<protocol::Gyro>()) {
      errors = last->errors;
      samples = last->samples;
    }
  };
  robot.run_s(10.0);
  const LoadResult result = robot.finish();
  std::printf("%s: %d samples, %d errors, miscounts %d\n",
              GetParam(),
              samples,
              errors,
              static_cast<int>(result.miscounts));
  EXPECT_GT(samples, 4900);
  EXPECT_LE(errors, kSetUpSamples);
  EXPECT_EQ(result.miscounts, 0);
  EXPECT_EQ(result.encoder_errors, 0);
  EXPECT_EQ(result.receive_overruns, 0);
  EXPECT_EQ(result.frames_bad, 0);
  EXPECT_EQ(result.frames_lost, 0);
}

}  // namespace
}  // namespace echomap::tests
