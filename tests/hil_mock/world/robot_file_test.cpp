// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

using testing::HasSubstr;

std::string uno_text() {
  return files::read_text_file(files::bundled_file("uno_2wd", "hil_mock/robots", "robot"));
}

std::string robot_error_after(const std::string& from, const std::string& to) {
  std::string text = uno_text();
  text.replace(text.find(from), from.size(), to);
  try {
    read_robot(files::TomlReader::parse(text, "uno.toml"));
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RobotFile, TheUnoIsWhatTheDefaultsSay) {
  const RobotParams robot = read_robot(files::TomlReader::parse(uno_text(), "uno.toml"));
  const RobotParams defaults;
  EXPECT_EQ(robot.name, defaults.name);
  EXPECT_DOUBLE_EQ(robot.drive.wheel_diameter_m, defaults.drive.wheel_diameter_m);
  EXPECT_DOUBLE_EQ(robot.drive.track_m, defaults.drive.track_m);
  EXPECT_DOUBLE_EQ(robot.drive.counts_per_turn, defaults.drive.counts_per_turn);
  EXPECT_DOUBLE_EQ(robot.drive.slip_m_per_sqrt_m, defaults.drive.slip_m_per_sqrt_m);
  EXPECT_DOUBLE_EQ(robot.body.radius_m, defaults.body.radius_m);
  EXPECT_NEAR(robot.pan.limit_rad, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(robot.sonar.beam_half_angle_rad, defaults.sonar.beam_half_angle_rad, 1e-3);
  EXPECT_NEAR(robot.sonar.smooth_limit_rad, defaults.sonar.smooth_limit_rad, 1e-3);
  EXPECT_DOUBLE_EQ(robot.sonar.range_noise_m, defaults.sonar.range_noise_m);
}

TEST(RobotFile, TheTriBotIsThatOfThePaper) {
  const auto path = files::bundled_file("nxt_tribot", "hil_mock/robots", "robot");
  const RobotParams robot = read_robot(files::TomlReader::load(path));
  const double metres_per_count =
      std::numbers::pi * robot.drive.wheel_diameter_m / robot.drive.counts_per_turn;
  EXPECT_NEAR(0.01 / metres_per_count, 21.0, 0.5) << "counts for one centimetre";
  EXPECT_NEAR(robot.drive.no_load_speed_m_per_s / metres_per_count, 1000.0, 5.0);
  EXPECT_DOUBLE_EQ(robot.sonar.max_range_m, 2.3);
}

RobotParams bundled(const std::string& name) {
  return read_robot(files::TomlReader::load(files::bundled_file(name, "hil_mock/robots", "robot")));
}

TEST(RobotFile, TheUnoCarriesNothingButAGyro) {
  const RobotParams robot = bundled("uno_2wd");
  EXPECT_TRUE(robot.parts.ranges.empty() && robot.parts.cliffs.empty() && robot.wiring.empty());
  EXPECT_TRUE(robot.parts.gyro);
  EXPECT_FALSE(robot.parts.stepper || robot.parts.battery);
}

TEST(RobotFile, TheCreateHasTheSensorsOfItsPaperAndNoSonar) {
  const RobotParams robot = bundled("create");
  EXPECT_FALSE(robot.has_sonar);
  EXPECT_EQ(robot.parts.cliffs.size(), 4U);
  EXPECT_TRUE(robot.parts.wall && robot.parts.beam_detector);
  EXPECT_LT(robot.parts.wall.value().T_robot_sensor.heading_rad(), 0.0) << "on the right side";
  EXPECT_GT(robot.parts.beam_detector.value().own_beam_reach_m, 0.0);
  EXPECT_EQ(robot.wiring.count("uno"), 0U) << "it has too few pins";
}

TEST(RobotFile, TheEpuckHasARingOfEight) {
  const RobotParams robot = bundled("epuck");
  ASSERT_EQ(robot.parts.ranges.size(), 8U);
  for (const IrRangeParams& range : robot.parts.ranges) {
    const Eigen::Vector2d mount_m = range.T_robot_sensor.position_m();
    EXPECT_NEAR(mount_m.norm(), 0.035, 1e-4) << range.channel;
    EXPECT_NEAR(std::atan2(mount_m.y(), mount_m.x()), range.T_robot_sensor.heading_rad(), 2e-3);
  }
  EXPECT_FALSE(robot.has_sonar || robot.body.has_bumpers);
}

TEST(RobotFile, TheEv3TurnsItsSonarAllTheWayRoundByAStepperOnTheMega) {
  const RobotParams robot = bundled("ev3_mega");
  EXPECT_TRUE(robot.parts.stepper && robot.parts.gyro);
  EXPECT_NEAR(2.0 * robot.sonar.beam_half_angle_rad, geometry::radians(32.8), 1e-9);
}

TEST(RobotFile, EveryPartOfABundledRobotIsWiredOnEachOfItsBoards) {
  for (const std::string name : {"nxt_tribot", "create", "epuck", "ev3_mega"}) {
    const RobotParams robot = bundled(name);
    const PartParams& parts = robot.parts;
    const std::size_t expected = parts.ranges.size() + parts.cliffs.size() + (parts.wall ? 1 : 0) +
                                 (parts.beam_detector ? 1 : 0) + (parts.battery ? 1 : 0) +
                                 (parts.stepper ? 4 : 0) +
                                 (parts.cliffs.empty() ? 0 : 1);  // and the wheel-drop
    for (const auto& [board, wires] : robot.wiring) {
      const auto wired = std::count_if(
          wires.begin(), wires.end(), [](const auto& wire) { return wire.has_value(); });
      EXPECT_EQ(static_cast<std::size_t>(wired), expected) << name << " on " << board;
    }
  }
}

RobotParams uno_with(const std::string& line) {
  std::string text = uno_text();
  const std::string drive = "[drive]\n";
  text.insert(text.find(drive) + drive.size(), line + "\n");
  return read_robot(files::TomlReader::parse(text, "uno.toml"));
}

TEST(RobotFile, NamesTheMotorDriver) {
  EXPECT_EQ(bundled("uno_2wd").drive.driver, DriverChip::kPhaseEnable);
  const RobotParams robot = uno_with("driver = \"l298n\"\npull_downs = false");
  EXPECT_EQ(robot.drive.driver, DriverChip::kL298n);
  EXPECT_FALSE(robot.drive.pull_downs);
  EXPECT_TRUE(uno_with("driver = \"servo\"").drive.pull_downs);
  EXPECT_THAT(robot_error_after("[drive]", "[drive]\ndriver = \"l298\""),
              HasSubstr("uno.toml:6:10: unknown motor driver 'l298'; did you mean"));
}

TEST(RobotFile, CoastsThreeTimesAsLongAsItBrakesUnlessItIsToldOtherwise) {
  EXPECT_DOUBLE_EQ(uno_with("").drive.coast_time_constant_s, 0.24);
  EXPECT_DOUBLE_EQ(uno_with("coast_time_constant_s = 0.5").drive.coast_time_constant_s, 0.5);
}

TEST(RobotFile, ARobotHasOnePanDrive) {
  EXPECT_THAT(
      robot_error_after("[gyro]",
                        "[stepper]\nhalf_steps_per_turn = 4076\nmax_half_steps_per_s = 600\n"
                        "[gyro]"),
      HasSubstr("one pan drive"));
}

TEST(RobotFile, NamesThePlaceOfEveryFault) {
  EXPECT_EQ(robot_error_after("track_m", "track_m"), "no error");
  EXPECT_THAT(robot_error_after("track_m = 0.140", "track_m = -0.140"),
              HasSubstr("uno.toml:7:11: "));
  EXPECT_THAT(robot_error_after("track_stddev", "trak_stddev"),
              HasSubstr("did you mean 'track_stddev'"));
  EXPECT_THAT(robot_error_after("max_range_m = 4.0", "max_range_m = 0.01"),
              HasSubstr("min_range_m"));
  EXPECT_THAT(robot_error_after("edge_strength = 0.4", "edge_strength = 1.4"),
              HasSubstr("between"));
}

}  // namespace
}  // namespace echomap::world
