// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "hil_mock/world/floor_contact.hpp"
#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/geometry/angle.hpp"
#include "tests/hil_mock/mock_device/native_session.hpp"
#include "tests/hil_mock/world/rooms.hpp"

// The sensors of the papers' robots from the room to the wire: world, pins and bus, native
// firmware, messages.
namespace echomap::mock_device {
namespace {

using geometry::radians;
using protocol::MotionOutcome;

constexpr double kCountsPerMillivolt = 1024.0 / 5000.0;

world::RobotParams bundled_robot(const std::string& name) {
  const auto path = files::bundled_file(name, "hil_mock/robots", "robot");
  return world::read_robot(files::TomlReader::load(path));
}

world::FloorPlan bundled_room(const std::string& name) {
  const auto path = files::bundled_file(name, "hil_mock/worlds", "world");
  return world::read_floor_plan(files::TomlReader::load(path));
}

/// Cliffs left, front left, front right, right, then wheel-drop, virtual wall, wall; a range and
/// the battery on pins 8 and 9: as create.toml is wired.
protocol::ConfigurePins create_pins() {
  constexpr std::uint8_t kHigh = protocol::kPinActiveHigh;
  protocol::ConfigurePins pins{};
  pins.command_id = 10;
  pins.pin_0 = protocol::kPinCliffLeft | kHigh;
  pins.pin_1 = protocol::kPinCliffFrontLeft | kHigh;
  pins.pin_2 = protocol::kPinCliffFrontRight | kHigh;
  pins.pin_3 = protocol::kPinCliffRight | kHigh;
  pins.pin_4 = protocol::kPinWheelDrop;
  pins.pin_5 = protocol::kPinVirtualWall;
  pins.pin_6 = protocol::kPinWall;
  pins.pin_8 = protocol::kPinRange0;
  pins.pin_9 = protocol::kPinBattery;
  return pins;
}

class CreateOnTheLanding : public testing::Test {
 protected:
  static constexpr std::uint8_t kCliffs =
      protocol::kHazardCliffLeft | protocol::kHazardCliffFrontLeft |
      protocol::kHazardCliffFrontRight | protocol::kHazardCliffRight;

  void start(double x_m, double y_m, double heading_deg) {
    session.simulation().schedule({0, 1'000'000, {x_m, y_m, radians(heading_deg)}});
    session.pass_ms(50);
    session.send(create_pins());
    session.send(protocol::ConfigureSensors{11, 20, 0, 0});
    session.send(protocol::ConfigureSafety{12, kCliffs | protocol::kHazardWheelDrop, 0, 0, 0});
    session.send(protocol::ConfigureDrive{1, 0, 1500, 1500, 70, 30, 500, 20});
    session.send(protocol::Arm{3, 1});
    session.pass_ms(300);
  }
  std::uint8_t hazards() const { return session.heard().status.hazards; }
  MotionOutcome move_outcome() const {
    return static_cast<MotionOutcome>(session.heard().status.move_outcome);
  }
  bool armed() const { return (session.heard().status.flags & protocol::kFlagArmed) != 0; }

  NativeSession session{bundled_room("landing"), bundled_robot("create"), 1};
};

TEST_F(CreateOnTheLanding, StopsAtTheStairsWithItsWheelsOnTheFloor) {
  start(2.2, 0.7, 0.0);
  ASSERT_EQ(hazards(), 0);
  session.send(protocol::MoveTicks{4, 5000, 5000, 750, 200});  // 0.3 m/s
  session.keep_alive_ms(4000);
  EXPECT_EQ(move_outcome(), MotionOutcome::kHazard);
  EXPECT_NE(hazards() & (protocol::kHazardCliffFrontLeft | protocol::kHazardCliffFrontRight), 0);
  EXPECT_TRUE(session.world().body().support().left && session.world().body().support().right);
  const geometry::Pose2& pose = session.world().T_world_robot();
  const double to_edge_m = world::hole_distance_m(session.world().plan(), pose.position_m());
  EXPECT_GT(to_edge_m, 0.06) << "the axle stands back from the edge";
  EXPECT_LT(to_edge_m, 0.15) << "the sensors are 0.15 m before the axle";
}

TEST_F(CreateOnTheLanding, LiftingItStopsReportsAndDisarms) {
  start(1.0, 1.5, 0.0);
  session.send(protocol::MoveTicks{4, 3000, 3000, 750, 200});
  session.keep_alive_ms(500);
  ASSERT_EQ(move_outcome(), MotionOutcome::kRunning);
  const std::int64_t now_ns = session.simulation().now_ns();
  session.simulation().schedule({now_ns, now_ns + 1'000'000'000, {2.0, 2.0, 1.0}});
  session.keep_alive_ms(500);
  EXPECT_EQ(move_outcome(), MotionOutcome::kLifted);
  EXPECT_EQ(hazards() & (kCliffs | protocol::kHazardWheelDrop),
            kCliffs | protocol::kHazardWheelDrop);
  EXPECT_FALSE(armed());
  session.keep_alive_ms(1000);
  EXPECT_EQ(hazards() & (kCliffs | protocol::kHazardWheelDrop), 0) << "it is down again";
  EXPECT_FALSE(armed()) << "until somebody says so";
}

TEST_F(CreateOnTheLanding, StopsAtTheVirtualWallOfTheDoorway) {
  start(1.6, 2.6, 90.0);
  EXPECT_EQ(hazards() & protocol::kHazardVirtualWall, 0);
  session.send(protocol::ConfigureSafety{13, protocol::kHazardVirtualWall, 0, 0, 0});
  session.send(protocol::MoveTicks{4, 2000, 2000, 500, 200});
  session.keep_alive_ms(3000);
  EXPECT_EQ(move_outcome(), MotionOutcome::kHazard);
  EXPECT_LT(session.world().T_world_robot().y_m(), 3.05) << "the beam lies across y = 3.05";
}

TEST_F(CreateOnTheLanding, ItsWallSensorSeesAWallOnTheRight) {
  start(1.0, 0.18, 0.0);
  EXPECT_NE(hazards() & protocol::kHazardWall, 0);
  EXPECT_GT(session.heard().ranges.channel_0, 40);
  start(1.0, 0.40, 0.0);
  EXPECT_EQ(hazards() & protocol::kHazardWall, 0);
  EXPECT_LT(session.heard().ranges.channel_0, 20);
}

TEST_F(CreateOnTheLanding, ItsBatteryFallsUnderLoad) {
  start(1.0, 1.5, 0.0);
  session.pass_ms(1500);
  const int resting = session.heard().health.battery_raw;
  EXPECT_NEAR(resting, (17.0 - 0.3 * 0.25) * 250.0 * kCountsPerMillivolt, 3.0);
  session.send(protocol::MoveTicks{4, 4000, -4000, 1000, 200});
  session.keep_alive_ms(2500);
  EXPECT_LT(session.heard().health.battery_raw, resting - 2);
}

TEST(EpuckOnItsField, ReadsItsRingOfEight) {
  NativeSession session(bundled_room("epuck_field"), bundled_robot("epuck"), 1);
  protocol::ConfigurePins pins{};
  pins.command_id = 10;
  pins.pin_8 = protocol::kPinRange0;
  pins.pin_9 = protocol::kPinRange0 + 1;
  pins.pin_10 = protocol::kPinRange0 + 2;
  pins.pin_11 = protocol::kPinRange0 + 3;
  pins.pin_12 = protocol::kPinRange0 + 4;
  pins.pin_13 = protocol::kPinRange0 + 5;
  pins.pin_14 = protocol::kPinRange0 + 6;
  pins.pin_15 = protocol::kPinRange0 + 7;
  session.send(pins);
  session.send(protocol::ConfigureSensors{11, 20, 0, 0});
  session.simulation().schedule({0, 1'000'000, {0.055, 0.30, 0.0}});
  session.pass_ms(300);
  const protocol::Ranges& ranges = session.heard().ranges;
  const std::array<int, 8> counts = {ranges.channel_0,
                                     ranges.channel_1,
                                     ranges.channel_2,
                                     ranges.channel_3,
                                     ranges.channel_4,
                                     ranges.channel_5,
                                     ranges.channel_6,
                                     ranges.channel_7};
  // The wall is 2 cm behind the robot's rim: sensors 3 and 4 look at it 30 degrees off.
  const double range_m = (0.055 - 0.035 * std::cos(radians(30.0))) / std::cos(radians(30.0));
  const double expected = kCountsPerMillivolt * world::ir_millivolts(world::IrKind::kEpuck,
                                                                     {range_m, 0.9, radians(30.0)});
  EXPECT_NEAR(counts[3], expected, 0.15 * expected + 8.0);
  EXPECT_NEAR(counts[4], expected, 0.15 * expected + 8.0);
  for (const std::size_t far : {0U, 1U, 2U, 5U, 6U, 7U}) {
    EXPECT_LT(counts[far], 25) << far;
  }
}

/// What the gyro says the robot has turned between two messages, in degrees.
double turned_deg(const protocol::Gyro& from, const protocol::Gyro& to, double bias, double dt_s) {
  constexpr double kCountsPerDegPerS = 65.5;
  const double samples = static_cast<std::uint16_t>(to.samples - from.samples);
  const double sum = static_cast<double>(to.yaw_sum) - static_cast<double>(from.yaw_sum);
  return (sum - bias * samples) * dt_s / kCountsPerDegPerS;
}

class UnoWithGyro : public testing::TestWithParam<std::uint32_t> {};

TEST_P(UnoWithGyro, ItsGyroFollowsATurnWithinItsErrors) {
  constexpr int kPeriodMs = 10;
  NativeSession session(world::box_room(), bundled_robot("uno_2wd"), GetParam());
  session.configure_and_arm();
  session.send(protocol::ConfigureSensors{11, 0, kPeriodMs, 1});
  session.pass_ms(500);
  const protocol::Gyro first = session.heard().gyro;
  session.pass_ms(5000);
  const protocol::Gyro resting = session.heard().gyro;
  const double samples = static_cast<std::uint16_t>(resting.samples - first.samples);
  EXPECT_NEAR(samples, 5000.0 / kPeriodMs, 3.0);
  const double bias = (resting.yaw_sum - first.yaw_sum) / samples;

  const double from_rad = session.world().T_world_robot().heading_rad();
  session.send(protocol::MoveTicks{4, -850, 850, 1000, 200});
  session.keep_alive_ms(2500);
  const double truth_deg = geometry::degrees(
      geometry::angle_between(from_rad, session.world().T_world_robot().heading_rad()));
  EXPECT_GT(std::abs(truth_deg), 60.0);
  const protocol::Gyro after = session.heard().gyro;
  EXPECT_EQ(after.errors, resting.errors);
  // Three standard deviations of 1 % of scale, and 0.3 degrees for bias and noise.
  EXPECT_NEAR(turned_deg(resting, after, bias, 1e-3 * kPeriodMs),
              truth_deg,
              0.03 * std::abs(truth_deg) + 0.3);
}

INSTANTIATE_TEST_SUITE_P(Seeds, UnoWithGyro, testing::Values(1U, 2U, 3U, 4U, 5U));

/// Whole turns and readings as in Singh and Bedi 2013, section 3.1: 120 of them, 6 degrees apart.
TEST(UnoGeiger, CountsWhatTheFieldSaysWhereItStands) {
  const world::FloorPlan hall =
      bundled_room("source_hall").with_radiation(world::parse_sources({"3,1,200"}));
  NativeSession session(hall, bundled_robot("uno_geiger"), 3);
  protocol::ConfigurePins pins{};
  pins.command_id = 10;
  pins.pin_0 = protocol::kPinScalarPulses;
  session.send(pins);
  session.send(protocol::ConfigureScalar{11, 100});
  session.pass_ms(500);
  const protocol::Scalar first = session.heard().scalar;
  session.pass_ms(40'000);
  const protocol::Scalar last = session.heard().scalar;
  const double passed_s = 1e-6 * (last.stamp_us - first.stamp_us);
  const double rate_per_s = world::field_at(
      hall, world::SourceKind::kRadiation, session.world().T_world_robot().position_m());
  const double expected =
      passed_s * rate_per_s / (1.0 + rate_per_s * world::ScalarSensorParams{}.dead_time_s);
  EXPECT_NEAR(rate_per_s, 0.4 + 200.0 / 4.01, 0.01);
  EXPECT_NEAR(last.sum - first.sum, expected, 4.0 * std::sqrt(expected));
  EXPECT_EQ(last.samples, 0);
}

TEST(Ev3InABox, ItsStepperPansTwiceRoundAndUnwinds) {
  NativeSession session(world::box_room(), bundled_robot("ev3_mega"), 1);
  protocol::ConfigurePins pins{};
  pins.command_id = 10;
  pins.pin_0 = protocol::kPinStepperPhaseA;
  pins.pin_1 = protocol::kPinStepperPhaseA + 1;
  pins.pin_2 = protocol::kPinStepperPhaseA + 2;
  pins.pin_3 = protocol::kPinStepperPhaseA + 3;
  session.send(pins);
  session.send(protocol::ConfigurePan{11, 1, 0, 0, 4076, 0, 72000, 45});
  session.send(protocol::ConfigureSonar{2, 14000, 30});
  session.send(protocol::StartSweep{4, 0, 71400, 600, 0});
  double max_deg = 0.0;
  for (int second = 0; second < 40; ++second) {
    session.pass_ms(1000);
    max_deg = std::max(max_deg, geometry::degrees(session.simulation().pan_rad()));
  }
  EXPECT_EQ(session.heard().echoes.size(), 120U);
  EXPECT_EQ(session.heard().status.sweep_outcome,
            static_cast<std::uint8_t>(MotionOutcome::kReached));
  EXPECT_NEAR(max_deg, 714.0, 0.3);
  EXPECT_EQ(session.heard().echoes.at(75).pan_cdeg, 9000) << "450 degrees, wrapped";

  session.send(protocol::StartSweep{5, 0, 0, 600, 0});
  session.pass_ms(20000);
  EXPECT_NEAR(geometry::degrees(session.simulation().pan_rad()), 0.0, 0.3) << "no step was lost";
}

}  // namespace
}  // namespace echomap::mock_device
