// SPDX-License-Identifier: MIT
#include "host/session/scalar_profile.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::session {
namespace {

using testing::HasSubstr;

/// Of a robot that has these functions on its first two pins.
RobotProfile scalar_profile_of(const std::string& lines) {
  RobotProfile profile;
  profile.configuration.pins.pin_0 = protocol::kPinScalarPulses;
  profile.configuration.pins.pin_1 = protocol::kPinScalarLevel;
  const auto file = files::TomlReader::parse("[scalar]\n" + lines, "robot.toml");
  read_scalar(file.table("scalar"), profile);
  file.reject_unknown_keys();
  return profile;
}

std::string error_of(const std::string& lines) {
  try {
    scalar_profile_of(lines);
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(ScalarProfile, DescribesATube) {
  const RobotProfile profile = scalar_profile_of(
      "kind = \"pulses\"\nperiod_ms = 250\ndead_time_us = 190\nbackground_per_s = 0.4\n");
  const sensors::ScalarParams& scalar = profile.sensors.scalar.value();
  EXPECT_EQ(scalar.kind, sensors::ScalarKind::kPulses);
  EXPECT_EQ(scalar.unit, "pulses/s");
  EXPECT_NEAR(scalar.dead_time_s, 190e-6, 1e-12);
  EXPECT_EQ(scalar.background_per_s, 0.4);
  EXPECT_EQ(profile.configuration.scalar.period_ms, 250);
  EXPECT_TRUE(wants_scalar(profile.configuration));
}

TEST(ScalarProfile, DescribesALevel) {
  const RobotProfile profile = scalar_profile_of(
      "kind = \"level\"\nperiod_ms = 50\nunit = \"lux\"\nzero = 5\nfull_scale = 1000\n");
  const sensors::ScalarParams& scalar = profile.sensors.scalar.value();
  EXPECT_EQ(scalar.kind, sensors::ScalarKind::kLevel);
  EXPECT_EQ(scalar.unit, "lux");
  EXPECT_EQ(scalar.zero, 5.0);
  EXPECT_EQ(scalar.full_scale, 1000.0);
  EXPECT_FALSE(scalar.background_per_s);
}

TEST(ScalarProfile, RefusesWhatDoesNotFit) {
  EXPECT_THAT(error_of("kind = \"noise\"\nperiod_ms = 50\n"), HasSubstr("\"pulses\" or \"level\""));
  EXPECT_THAT(error_of("kind = \"pulses\"\nperiod_ms = 9\n"), HasSubstr("from 10 to 2000"));
  EXPECT_THAT(error_of("kind = \"pulses\"\nperiod_ms = 2001\n"), HasSubstr("from 10 to 2000"));
  EXPECT_THAT(error_of("kind = \"pulses\"\nperiod_ms = 50\ndead_time_us = -1\n"),
              HasSubstr("negative"));
  EXPECT_THAT(error_of("kind = \"pulses\"\nperiod_ms = 50\nfull_scale = 5\n"),
              HasSubstr("full_scale"))
      << "it is a level's";
  EXPECT_THAT(error_of("kind = \"level\"\nperiod_ms = 50\nfull_scale = 5\n"), HasSubstr("unit"));
  EXPECT_THAT(error_of("kind = \"level\"\nperiod_ms = 50\nunit = \"V\"\nfull_scale = 0\n"),
              HasSubstr("must differ"));
  RobotProfile without_pin;
  const auto file = files::TomlReader::parse("kind = \"pulses\"\nperiod_ms = 50\n", "robot.toml");
  EXPECT_THROW(read_scalar(file, without_pin), files::ConfigError);
}

TEST(ScalarProfile, IsWantedWithAPinOrAPeriod) {
  protocol::Configuration configuration{};
  EXPECT_FALSE(wants_scalar(configuration));
  configuration.pins.pin_9 = protocol::kPinScalarLevel;
  EXPECT_TRUE(wants_scalar(configuration));
  configuration.pins.pin_9 = protocol::kPinBattery;
  EXPECT_FALSE(wants_scalar(configuration));
  configuration.scalar.period_ms = 10;
  EXPECT_TRUE(wants_scalar(configuration));
}

TEST(ScalarProfile, SaysWhatABoardThatRefusesLacks) {
  EXPECT_THAT(advice_on_refused_scalar(0), HasSubstr("an EV3 has ports in place of spare pins"));
  EXPECT_THAT(advice_on_refused_scalar(protocol::kCapabilityScalar), HasSubstr("D11 .. D13"));
}

}  // namespace
}  // namespace echomap::session
