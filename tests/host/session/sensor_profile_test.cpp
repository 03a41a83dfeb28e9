// SPDX-License-Identifier: MIT
#include "host/session/sensor_profile.hpp"

#include <gtest/gtest.h>

namespace echomap::session {
namespace {

/// Of a robot whose wheels count one tick a millimetre.
RobotProfile profile_of(const std::string& toml) {
  RobotProfile profile;
  profile.geometry.wheel_diameter_m = 1.0 / 3.14159265358979;
  profile.geometry.counts_per_turn = 1000.0;
  const auto file = files::TomlReader::parse(toml, "robot.toml");
  read_sensors(file, profile);
  file.reject_unknown_keys();
  return profile;
}

TEST(SensorProfile, IsEmptyWhereAProfileHasNone) {
  const RobotProfile profile = profile_of("");
  EXPECT_TRUE(profile.sensors.infrared.empty());
  EXPECT_FALSE(profile.sensors.gyro);
  EXPECT_EQ(profile.configuration.pins.pin_0, 0);
  EXPECT_EQ(profile.configuration.safety.hazard_stops, 0);
}

TEST(SensorProfile, PutsEachWordOnItsPin) {
  const RobotProfile profile =
      profile_of("[wiring]\npin_0 = \"wall high\"\npin_7 = \"range_5\"\npin_15 = \"battery\"\n");
  EXPECT_EQ(profile.configuration.pins.pin_0, protocol::kPinWall | protocol::kPinActiveHigh);
  EXPECT_EQ(profile.configuration.pins.pin_7, protocol::kPinRange0 + 5);
  EXPECT_EQ(profile.configuration.pins.pin_15, protocol::kPinBattery);
  EXPECT_EQ(profile.configuration.pins.pin_1, protocol::kPinUnused);
}

TEST(SensorProfile, StopsAtCliffsByItselfAndAtWallsOnlyWhereItIsToldTo) {
  const std::string wires = "[wiring]\npin_0 = \"cliff_left\"\npin_1 = \"wall\"\n";
  EXPECT_EQ(profile_of(wires).configuration.safety.hazard_stops, 0x1F);
  const auto walls = profile_of(wires + "[safety]\nstop_at_wall = true\nrunaway_m = 0.02\n");
  EXPECT_EQ(walls.configuration.safety.hazard_stops, 0x1F | protocol::kHazardWall);
  EXPECT_EQ(walls.configuration.safety.runaway_ticks, 20);
}

TEST(SensorProfile, WatchesWhatItIsToldToOrSaysThatItCannot) {
  EXPECT_EQ(profile_of("[safety]\nrunaway_m = 0.0\n").configuration.safety.runaway_ticks, 0);
  EXPECT_EQ(profile_of("[safety]\nrunaway_m = 0.0006\n").configuration.safety.runaway_ticks, 1);
  EXPECT_THROW(profile_of("[safety]\nrunaway_m = 0.0004\n"), files::ConfigError);
}

TEST(SensorProfile, SaysWhichContactsAreNormallyClosed) {
  const auto closed = [](const std::string& lines) {
    return +profile_of("[safety]\n" + lines).configuration.wiring.contacts_normally_closed;
  };
  EXPECT_EQ(closed(""), 0);
  EXPECT_EQ(closed("contacts_normally_closed = true\n"), 3);
  EXPECT_EQ(closed("left_contact_normally_closed = true\n"), 1);
  EXPECT_EQ(closed("contacts_normally_closed = true\nleft_contact_normally_closed = false\n"), 2);
  EXPECT_THROW(closed("contacts_normally_closed = 1\n"), files::ConfigError);
}

}  // namespace
}  // namespace echomap::session
