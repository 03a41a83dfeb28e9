// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "firmware/boards/ev3/parts.hpp"
#include "firmware/hal/contacts.hpp"
#include "firmware/hal/range_sensor.hpp"
#include "firmware/hal/yaw_gyro.hpp"
#include "tests/firmware/boards/ev3/brick_folder.hpp"

namespace echomap::hal {
namespace {

using tests::BrickFolder;
using State = RangeReading::State;

class Ev3SensorsTest : public testing::Test {
 protected:
  void open() { boards::open_sensors(brick.sysfs().c_str()); }

  /// Opens that sensor at in4 and returns what it says with each value.
  RangeReading range_at(const std::string& driver_name, int value) {
    const auto sensor = brick.add_sensor(3, "ev3-ports:in4", driver_name, "another");
    BrickFolder::write(sensor / "value0", std::to_string(value));
    open();
    mode = BrickFolder::read(sensor / "mode");
    return read_range();
  }

  BrickFolder brick;
  std::string mode;
};

TEST_F(Ev3SensorsTest, SonarOfTheEv3SaysMillimetresAndNothingAtItsEnd) {
  EXPECT_EQ(range_at("lego-ev3-us", 1234).range_mm, 1234);
  EXPECT_EQ(mode, "US-DIST-CM");
  EXPECT_EQ(range_at("lego-ev3-us", 2549).state, State::kRange);
  EXPECT_EQ(range_at("lego-ev3-us", 2550).state, State::kNothing);
  EXPECT_EQ(range_at("lego-ev3-us", 0).greatest_age_ms, 100);
}

TEST_F(Ev3SensorsTest, SonarOfTheNxtSaysCentimetresLater) {
  EXPECT_EQ(range_at("lego-nxt-us", 123).range_mm, 1230);
  EXPECT_EQ(range_at("lego-nxt-us", 255).state, State::kNothing);
  EXPECT_EQ(range_at("lego-nxt-us", 0).greatest_age_ms, 150);
}

TEST_F(Ev3SensorsTest, InfraredSensorSaysPercentOfSeventyCentimetres) {
  EXPECT_EQ(range_at("lego-ev3-ir", 50).range_mm, 350);
  EXPECT_EQ(range_at("lego-ev3-ir", 100).state, State::kNothing);
}

TEST_F(Ev3SensorsTest, PortWithoutASensorIsToldAsAbsent) {
  open();
  EXPECT_EQ(read_range().state, State::kAbsent);
  EXPECT_EQ(range_at("lego-ev3-color", 1).state, State::kAbsent);
  std::int16_t deg = 0;
  EXPECT_FALSE(read_yaw_deg(deg));
  EXPECT_EQ(closed_contacts(), 0);
}

TEST_F(Ev3SensorsTest, GyroCountsToTheLeftAndSaysNothingWhereItSticks) {
  const auto gyro = brick.add_sensor(0, "in3", "lego-ev3-gyro", "GYRO-ANG");
  open();
  std::int16_t deg = 0;
  BrickFolder::write(gyro / "value0", "90");
  EXPECT_TRUE(read_yaw_deg(deg));
  EXPECT_EQ(deg, -90);
  BrickFolder::write(gyro / "value0", "-32767");
  EXPECT_FALSE(read_yaw_deg(deg));
}

TEST_F(Ev3SensorsTest, TouchSensorsCloseTheirContacts) {
  const auto left = brick.add_sensor(0, "in1", "lego-ev3-touch", "TOUCH");
  brick.add_sensor(1, "in2", "lego-nxt-touch", "TOUCH");
  open();
  EXPECT_EQ(closed_contacts(), 0);
  BrickFolder::write(left / "value0", "1");
  EXPECT_EQ(closed_contacts(), kContactLeft);
}

TEST_F(Ev3SensorsTest, SingleTouchSensorIsBoth) {
  const auto right = brick.add_sensor(1, "in2", "lego-ev3-touch", "TOUCH");
  open();
  BrickFolder::write(right / "value0", "1");
  EXPECT_EQ(closed_contacts(), kContactLeft | kContactRight);
}

}  // namespace
}  // namespace echomap::hal
