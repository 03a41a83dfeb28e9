// SPDX-License-Identifier: MIT
#include "host/sensors/observation_converter.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace echomap::sensors {
namespace {

using protocol::Echo;
using protocol::Odometry;
using std::numbers::pi;

/// One millimetre per tick.
constexpr RobotGeometry kGeometry{.wheel_diameter_m = 1.0 / pi, .counts_per_turn = 1000.0};
constexpr SonarRangeParams kSonar{
    .speed_of_sound_m_s = 340.0, .min_range_m = 0.04, .max_range_m = 4.0};

std::optional<double> range_of(std::uint16_t flight_us, const SonarRangeParams& sonar = kSonar) {
  ObservationConverter converter(kGeometry, sonar);
  return converter.convert(Echo{0, 0, flight_us, 0, 0}).range_m;
}

TEST(ObservationConverter, GivesMetresAndRobotTime) {
  ObservationConverter converter(kGeometry, kSonar);
  converter.convert(Odometry{1'000, 0, 0, 0});
  const auto seen = converter.convert(Odometry{21'000, 250, -125, 0});
  EXPECT_EQ(seen.stamp.time_since_epoch().count(), 21'000);
  EXPECT_NEAR(seen.travel.left_m, 0.250, 1e-12);
  EXPECT_NEAR(seen.travel.right_m, -0.125, 1e-12);
}

TEST(ObservationConverter, ScalesTheTravelOfEachWheel) {
  RobotGeometry uneven = kGeometry;
  uneven.left_wheel_scale = 1.08;
  uneven.right_wheel_scale = 0.5;
  ObservationConverter converter(uneven, kSonar);
  converter.convert(Odometry{1'000, 0, 0, 0});
  const auto seen = converter.convert(Odometry{21'000, 250, -125, 0});
  EXPECT_NEAR(seen.travel.left_m, 0.270, 1e-12);
  EXPECT_NEAR(seen.travel.right_m, -0.0625, 1e-12);
  const auto echo = converter.convert(Echo{41'000, 0, 10'000, 500, 250});
  EXPECT_NEAR(echo.travel.left_m, 0.540, 1e-12);
  EXPECT_NEAR(echo.travel.right_m, 0.125, 1e-12);
}

TEST(ObservationConverter, HalvesTheFlightThereAndBack) {
  ASSERT_TRUE(range_of(10'000));
  EXPECT_NEAR(*range_of(10'000), 1.7, 1e-12);
}

TEST(ObservationConverter, TakesNoEchoAndRangesOutsideOfTheSonarsForNone) {
  EXPECT_FALSE(range_of(protocol::kNoEcho));
  EXPECT_FALSE(range_of(0));
  EXPECT_FALSE(range_of(235));  // 3.995 cm
  EXPECT_TRUE(range_of(236));
  EXPECT_TRUE(range_of(23'529));
  EXPECT_FALSE(range_of(23'530));  // 4.0001 m
}

TEST(ObservationConverter, NeverReadsACodeAsARangeHoweverFarTheSonarSees) {
  EXPECT_FALSE(range_of(protocol::kNoEcho, {.max_range_m = 100.0}));
  EXPECT_FALSE(range_of(protocol::kNoSonar, {.max_range_m = 100.0}));
  EXPECT_TRUE(range_of(protocol::kNoSonar - 1, {.max_range_m = 100.0}));
}

TEST(ObservationConverter, KnowsASonarThatListensInVainFromOneThatDoesNotAnswer) {
  ObservationConverter converter(kGeometry, kSonar);
  EXPECT_TRUE(converter.convert(Echo{0, 0, 10'000, 0, 0}).has_answered);
  EXPECT_TRUE(converter.convert(Echo{0, 0, protocol::kNoEcho, 0, 0}).has_answered);
  EXPECT_FALSE(converter.convert(Echo{0, 0, protocol::kNoSonar, 0, 0}).has_answered);
}

TEST(ObservationConverter, TakesLongSilenceOfOlderFirmwareForADeadSonar) {
  for (const bool is_older : {true, false}) {
    ObservationConverter converter(kGeometry, kSonar);
    if (is_older) {
      converter.set_protocol_minor(1);
    }
    for (int ping = 0; ping < 60; ++ping) {
      EXPECT_TRUE(converter.convert(Echo{0, 0, protocol::kNoEcho, 0, 0}).has_answered) << ping;
    }
    EXPECT_EQ(converter.convert(Echo{0, 0, protocol::kNoEcho, 0, 0}).has_answered, !is_older);
    EXPECT_TRUE(converter.convert(Echo{0, 0, 10'000, 0, 0}).has_answered);
    EXPECT_TRUE(converter.convert(Echo{0, 0, protocol::kNoEcho, 0, 0}).has_answered);
  }
}

TEST(ObservationConverter, LooksLeftForPositivePan) {
  ObservationConverter converter(kGeometry, kSonar);
  EXPECT_NEAR(converter.convert(Echo{0, 9'000, 0, 0, 0}).pan_rad, pi / 2.0, 1e-12);
  EXPECT_NEAR(converter.convert(Echo{0, -4'500, 0, 0, 0}).pan_rad, -pi / 4.0, 1e-12);
}

TEST(ObservationConverter, SharesTheCountersBetweenOdometryAndEchoes) {
  std::mt19937 random(4);
  ObservationConverter converter(kGeometry, kSonar);
  std::int64_t left = 0;
  std::int64_t right = 0;
  std::int64_t stamp_us = 0;
  converter.convert(Odometry{0, 0, 0, 0});
  for (int i = 0; i < 20'000; ++i) {
    left += static_cast<std::int64_t>(random() % 30'000);
    right -= static_cast<std::int64_t>(random() % 30'000);
    stamp_us += static_cast<std::int64_t>(random() % 1'000'000);
    const auto wire_left = static_cast<std::int16_t>(left);
    const auto wire_right = static_cast<std::int16_t>(right);
    const auto wire_stamp = static_cast<std::uint32_t>(stamp_us);
    OdometryObservation seen;
    if (random() % 2 == 0) {
      seen = converter.convert(Odometry{wire_stamp, wire_left, wire_right, 0});
    } else {
      const auto echo = converter.convert(Echo{wire_stamp, 0, 1'000, wire_left, wire_right});
      seen = {echo.stamp, echo.travel};
    }
    ASSERT_EQ(seen.stamp.time_since_epoch().count(), stamp_us);
    ASSERT_NEAR(seen.travel.left_m, static_cast<double>(left) * 1e-3, 1e-6);
    ASSERT_NEAR(seen.travel.right_m, static_cast<double>(right) * 1e-3, 1e-6);
  }
}

TEST(ObservationConverter, GoesOnThroughAReset) {
  ObservationConverter converter(kGeometry, kSonar);
  converter.convert(Odometry{5'000'000, 0, 0, 0});
  converter.convert(Odometry{6'000'000, 700, 700, 0});
  converter.restart();
  const auto seen = converter.convert(Odometry{40'000, 3, -2, 0});
  EXPECT_EQ(seen.stamp.time_since_epoch().count(), 6'040'000);
  EXPECT_NEAR(seen.travel.left_m, 0.703, 1e-12);
  EXPECT_NEAR(seen.travel.right_m, 0.698, 1e-12);
}

TEST(ObservationConverter, RefusesParametersThatMakeNoSense) {
  const auto build = [](const RobotGeometry& geometry, const SonarRangeParams& sonar) {
    const ObservationConverter converter(geometry, sonar);
  };
  EXPECT_NO_THROW(build(RobotGeometry{}, SonarRangeParams{}));
  EXPECT_THROW(build({.track_m = 0.0}, kSonar), std::invalid_argument);
  EXPECT_THROW(build({.left_wheel_scale = 0.0}, kSonar), std::invalid_argument);
  EXPECT_THROW(build(kGeometry, {.speed_of_sound_m_s = 0.0}), std::invalid_argument);
  EXPECT_THROW(build(kGeometry, {.min_range_m = 2.0, .max_range_m = 1.0}), std::invalid_argument);
  EXPECT_THROW(build(kGeometry, {.min_range_m = std::nan("")}), std::invalid_argument);
}

SensorParams all_sensors() {
  SensorParams sensors;
  sensors.infrared = {{3, {}}, {0, {}}, {7, {}}};
  sensors.infrared_curve = InfraredCurve({{1000.0, 0.01}, {10.0, 0.10}});
  sensors.gyro = GyroParams{1.0, 0.01, false};
  sensors.battery_full_scale_v = 10.0;
  return sensors;
}

TEST(ObservationConverter, GivesInfraredRangesInTheOrderOfTheProfile) {
  ObservationConverter converter(kGeometry, kSonar, all_sensors());
  protocol::Ranges message{};
  message.stamp_us = 5000;
  message.channel_3 = 250;
  message.channel_0 = 3;
  message.channel_7 = protocol::kNoRange;
  const InfraredObservation seen = converter.convert(message);
  EXPECT_EQ(seen.stamp.time_since_epoch().count(), 5000);
  ASSERT_EQ(seen.range_m.size(), 3U);
  EXPECT_NEAR(seen.range_m[0].value(), 0.02, 1e-12);
  EXPECT_FALSE(seen.range_m[1]) << "nothing in reach";
  EXPECT_FALSE(seen.range_m[2]) << "no pin reads it";
}

TEST(ObservationConverter, GivesTheBatterysVoltage) {
  ObservationConverter converter(kGeometry, kSonar, all_sensors());
  protocol::Health message{};
  message.battery_raw = 1023;
  EXPECT_NEAR(converter.convert(message)->voltage_v, 10.0, 1e-12);
  message.battery_raw = 341;
  EXPECT_NEAR(converter.convert(message)->voltage_v, 10.0 / 3.0, 1e-12);
  message.battery_raw = 0;
  EXPECT_FALSE(converter.convert(message)) << "not measured";
}

TEST(ObservationConverter, HasNoYawAndNoVoltageWithoutTheirSensors) {
  ObservationConverter converter(kGeometry, kSonar);
  EXPECT_FALSE(converter.convert(protocol::Gyro{0, 1000, 1, 0}));
  protocol::Health message{};
  message.battery_raw = 512;
  EXPECT_FALSE(converter.convert(message));
  EXPECT_TRUE(converter.convert(protocol::Ranges{}).range_m.empty());
}

TEST(ObservationConverter, KeepsTheYawThroughAReset) {
  ObservationConverter converter(kGeometry, kSonar, all_sensors());
  converter.convert(protocol::Gyro{0, 32768, 1, 0});
  converter.restart();
  const auto seen = converter.convert(protocol::Gyro{0, 32768, 1, 0});
  EXPECT_NEAR(seen->yaw.yaw_rad, 0.01, 1e-12);
}

TEST(ObservationConverter, NamesWhatTouchesOrThreatens) {
  ObservationConverter converter(kGeometry, kSonar);
  protocol::Status message{};
  message.flags = protocol::kFlagArmed | protocol::kFlagBumpRight;
  message.hazards = protocol::kHazardCliffFrontLeft | protocol::kHazardWall;
  const HazardObservation seen = converter.convert(message);
  EXPECT_FALSE(seen.bump_left);
  EXPECT_TRUE(seen.bump_right);
  EXPECT_EQ(seen.cliffs, (std::array{false, true, false, false}));
  EXPECT_FALSE(seen.lifted);
  EXPECT_FALSE(seen.virtual_wall);
  EXPECT_TRUE(seen.wall);
  message.hazards = protocol::kHazardWheelDrop | protocol::kHazardVirtualWall;
  EXPECT_TRUE(converter.convert(message).lifted);
  EXPECT_TRUE(converter.convert(message).virtual_wall);
}

/// One whose contacts are normally closed reports both as pressed until it knows of them.
TEST(ObservationConverter, TakesNoBumpFromARobotThatIsNotArmed) {
  ObservationConverter converter(kGeometry, kSonar);
  protocol::Status message{};
  message.flags = protocol::kFlagBumpLeft | protocol::kFlagBumpRight;
  EXPECT_FALSE(converter.convert(message).is_touching());
  protocol::Odometry odometry{0, 0, 0, protocol::kFlagBumpLeft};
  EXPECT_FALSE(converter.with_bumps_of(odometry, {}).is_touching());
  odometry.flags |= protocol::kFlagArmed;
  EXPECT_TRUE(converter.with_bumps_of(odometry, {}).bump_left);
}

TEST(ObservationConverter, CountsTheErrorsOfTheEncodersThroughWrapsAndResets) {
  ObservationConverter converter(kGeometry, kSonar);
  converter.convert(protocol::EncoderErrors{0, 65'000, 4});
  converter.convert(protocol::EncoderErrors{1000, 100, 4});
  converter.restart();
  const EncoderErrorObservation seen = converter.convert(protocol::EncoderErrors{0, 5, 0});
  EXPECT_EQ(seen.left, 636 + 5) << "since the first message";
  EXPECT_EQ(seen.right, 0);
}

TEST(ObservationConverter, ReadsTheScalarSensorWhereTheWheelsAre) {
  SensorParams sensors;
  sensors.scalar = ScalarParams{};
  ObservationConverter converter(kGeometry, kSonar, sensors);
  EXPECT_FALSE(converter.convert(protocol::Scalar{1'000'000, 0, 0, 40, 0}));
  const auto seen = converter.convert(protocol::Scalar{1'200'000, 250, 125, 49, 0});
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->stamp.time_since_epoch().count(), 1'200'000);
  EXPECT_NEAR(seen->travel.left_m, 0.250, 1e-12);
  EXPECT_EQ(seen->count, 9.0);
  EXPECT_NEAR(seen->dwell_s, 0.2, 1e-12);
  converter.restart();
  EXPECT_FALSE(converter.convert(protocol::Scalar{1'000, 0, 0, 2, 0})) << "counts begin at zero";
  EXPECT_EQ(converter.convert(protocol::Scalar{2'000, 0, 0, 5, 0})->count, 3.0);
}

TEST(ObservationConverter, HasNoScalarReadingWithoutASensor) {
  ObservationConverter converter(kGeometry, kSonar);
  converter.convert(protocol::Scalar{1'000, 0, 0, 2, 0});
  EXPECT_FALSE(converter.convert(protocol::Scalar{2'000, 0, 0, 5, 0}));
}

TEST(ObservationConverter, RefusesInfraredSensorsWithoutACurve) {
  SensorParams sensors = all_sensors();
  sensors.infrared_curve.reset();
  EXPECT_THROW(ObservationConverter(kGeometry, kSonar, sensors), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::sensors
