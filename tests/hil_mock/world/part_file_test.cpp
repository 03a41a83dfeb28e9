// SPDX-License-Identifier: MIT
#include "hil_mock/world/part_file.hpp"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::world {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string parts_text = R"([[range]]
channel = 3
kind = "epuck"
x_m = 0.03
y_m = -0.01
heading_deg = -90
[[cliff]]
place = "front_left"
x_m = 0.1
y_m = 0.05
[wall_sensor]
x_m = 0.0
y_m = -0.1
heading_deg = -90
reach_m = 0.1
[virtual_wall_sensor]
x_m = 0.1
y_m = 0.0
own_beam_reach_m = 0.5
own_beam_half_angle_deg = 5
[gyro]
bias_stddev_deg_per_s = 1.5
[battery]
full_v = 16.0
empty_v = 12.0
capacity_ah = 3.0
[stepper]
half_steps_per_turn = -4076
max_half_steps_per_s = 600
[wiring.mega]
pin_0 = "cliff_front_left high"
pin_1 = "wheel_drop"
pin_8 = "range_3"
)";

PartParams parsed() { return read_parts(files::TomlReader::parse(parts_text, "r.toml")); }

std::string parts_error_after(const std::string& from, const std::string& to) {
  std::string text = parts_text;
  text.replace(text.find(from), from.size(), to);
  try {
    const auto file = files::TomlReader::parse(text, "r.toml");
    read_wiring(file, read_parts(file));
    file.reject_unknown_keys();
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PartFile, ReadsEveryPart) {
  const PartParams parts = parsed();
  ASSERT_EQ(parts.ranges.size(), 1U);
  EXPECT_EQ(parts.ranges[0].channel, 3);
  EXPECT_EQ(parts.ranges[0].kind, IrKind::kEpuck);
  EXPECT_NEAR(parts.ranges[0].T_robot_sensor.heading_rad(), -0.5 * std::numbers::pi, 1e-12);
  ASSERT_EQ(parts.cliffs.size(), 1U);
  EXPECT_EQ(parts.cliffs[0].place, CliffPlace::kFrontLeft);
  EXPECT_DOUBLE_EQ(parts.wall.value().reach_m, 0.1);
  EXPECT_DOUBLE_EQ(parts.beam_detector.value().own_beam_reach_m, 0.5);
  EXPECT_DOUBLE_EQ(parts.gyro.value().bias_stddev_deg_per_s, 1.5);
  EXPECT_DOUBLE_EQ(parts.gyro.value().scale_stddev, GyroParams{}.scale_stddev);
  EXPECT_DOUBLE_EQ(parts.battery.value().full_v, 16.0);
  EXPECT_DOUBLE_EQ(parts.stepper.value().half_steps_per_turn, -4076.0);
}

TEST(PartFile, AnEmptyFileHasNone) {
  const auto file = files::TomlReader::parse("", "r.toml");
  const PartParams parts = read_parts(file);
  EXPECT_TRUE(parts.ranges.empty() && parts.cliffs.empty());
  EXPECT_FALSE(parts.wall || parts.beam_detector || parts.gyro || parts.battery || parts.stepper);
  EXPECT_TRUE(read_wiring(file, parts).empty());
}

TEST(PartFile, ReadsTheWiresOfEachBoard) {
  const auto file = files::TomlReader::parse(parts_text, "r.toml");
  const Wiring wiring = read_wiring(file, read_parts(file));
  ASSERT_EQ(wiring.size(), 1U);
  const PinWires& wires = wiring.at("mega");
  EXPECT_EQ(wires[0].value().part, PinPart::kCliffFrontLeft);
  EXPECT_TRUE(wires[0].value().active_high);
  EXPECT_FALSE(wires[1].value().active_high);
  EXPECT_EQ(wires[8].value().part, static_cast<PinPart>(static_cast<int>(PinPart::kRange0) + 3));
  EXPECT_FALSE(wires[2]);
}

TEST(PartFile, ReadsATubeAndALightSensorAndTheirWires) {
  const auto tube = files::TomlReader::parse(
      "[scalar_sensor]\nkind = \"geiger\"\nx_m = 0.02\ny_m = 0\nsensitivity = 1.5\n"
      "dead_time_us = 100\npulse_us = 80\n[wiring.uno]\npin_0 = \"scalar_pulses\"\n",
      "r.toml");
  const PartParams parts = read_parts(tube);
  EXPECT_EQ(parts.scalar.value().kind, ScalarSensorKind::kGeiger);
  EXPECT_EQ(parts.scalar->mount_m.x(), 0.02);
  EXPECT_EQ(parts.scalar->sensitivity, 1.5);
  EXPECT_NEAR(parts.scalar->dead_time_s, 100e-6, 1e-12);
  EXPECT_EQ(read_wiring(tube, parts).at("uno")[0].value().part, PinPart::kScalarPulses);
  const auto light = files::TomlReader::parse(
      "[scalar_sensor]\nkind = \"light\"\nx_m = 0\ny_m = 0\nsensitivity = 3\n"
      "dark_millivolts = 20\nnoise_millivolts = 4\n[wiring.uno]\npin_5 = \"scalar_level\"\n",
      "r.toml");
  EXPECT_EQ(read_parts(light).scalar.value().dark_millivolts, 20.0);
  EXPECT_EQ(read_wiring(light, read_parts(light)).at("uno")[5].value().part, PinPart::kScalarLevel);
  EXPECT_THROW(read_wiring(light, parts), files::ConfigError) << "a tube has no voltage";
  const auto too_long = files::TomlReader::parse(
      "[scalar_sensor]\nkind = \"geiger\"\nx_m = 0\ny_m = 0\nsensitivity = 1\npulse_us = 200\n",
      "r.toml");
  EXPECT_THROW(read_parts(too_long), files::ConfigError) << "longer than the dead time";
}

TEST(PartFile, NamesThePlaceOfABadPart) {
  EXPECT_EQ(parts_error_after("x_m = 0.03", "x_m = 0.04"), "no error");
  EXPECT_THAT(parts_error_after("channel = 3", "channel = 8"), StartsWith("r.toml:2:11: "));
  EXPECT_THAT(parts_error_after("\"epuck\"", "\"epuk\""), HasSubstr("did you mean 'epuck'"));
  EXPECT_THAT(parts_error_after("x_m = 0.03", "x_m = 30"), StartsWith("r.toml:4:7: "));
  EXPECT_THAT(parts_error_after("\"front_left\"", "\"fore\""),
              StartsWith("r.toml:8:9: unknown word"));
  EXPECT_THAT(parts_error_after("reach_m = 0.1", "reach_m = 0"), StartsWith("r.toml:15:11: "));
  EXPECT_THAT(parts_error_after("bias_stddev_deg", "bias_stddev_rad"), HasSubstr("unknown key"));
  EXPECT_THAT(parts_error_after("empty_v = 12.0", "empty_v = 17.0"), StartsWith("r.toml:25:11: "));
  EXPECT_THAT(parts_error_after("= -4076", "= 0"), StartsWith("r.toml:28:23: "));
}

TEST(PartFile, NamesThePlaceOfABadWire) {
  EXPECT_THAT(parts_error_after("\"wheel_drop\"", "\"wheel_dorp\""),
              HasSubstr("did you mean 'wheel_drop'"));
  EXPECT_THAT(parts_error_after("\"range_3\"", "\"range_4\""),
              StartsWith("r.toml:33:9: the robot has no range_4"));
  EXPECT_THAT(parts_error_after("\"wheel_drop\"", "\"cliff_left\""),
              HasSubstr("has no cliff_left"));
  EXPECT_THAT(parts_error_after("pin_8", "pin_16"), HasSubstr("unknown key 'pin_16'"));
  EXPECT_THAT(parts_error_after("wiring.mega", "wiring.mego"), HasSubstr("did you mean 'mega'"));
  EXPECT_THAT(parts_error_after("\"range_3\"", "\"range_3 high\""), HasSubstr("yes or no"));
  EXPECT_THAT(parts_error_after("pin_8 = \"range_3\"", "pin_8 = \"wheel_drop\""),
              HasSubstr("wired to another pin"));
}

TEST(PartFile, RefusesTwoOfOnePlaceOrChannel) {
  EXPECT_THAT(
      parts_error_after("[wall_sensor]",
                        "[[cliff]]\nplace = \"front_left\"\nx_m = 0\ny_m = 0\n[wall_sensor]"),
      HasSubstr("another one at this place"));
  EXPECT_THAT(parts_error_after(
                  "[[cliff]]",
                  "[[range]]\nchannel = 3\nkind = \"epuck\"\nx_m = 0\ny_m = 0\nheading_deg = 0\n"
                  "[[cliff]]"),
              HasSubstr("each once"));
}

}  // namespace
}  // namespace echomap::world
