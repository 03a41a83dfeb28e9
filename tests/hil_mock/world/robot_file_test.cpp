// SPDX-License-Identifier: MIT
#include "hil_mock/world/robot_file.hpp"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"

namespace echomap::world {
namespace {

using testing::HasSubstr;

std::string uno_text() {
  return files::read_text_file(files::bundled_file("uno_2wd", "hil_mock/robots", "robot"));
}

std::string error_after(const std::string& from, const std::string& to) {
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
  EXPECT_NEAR(robot.sonar.cone_half_angle_rad, defaults.sonar.cone_half_angle_rad, 1e-3);
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

TEST(RobotFile, NamesThePlaceOfEveryFault) {
  EXPECT_EQ(error_after("track_m", "track_m"), "no error");
  EXPECT_THAT(error_after("track_m = 0.140", "track_m = -0.140"), HasSubstr("uno.toml:7:11: "));
  EXPECT_THAT(error_after("track_sd", "trak_sd"), HasSubstr("did you mean 'track_sd'"));
  EXPECT_THAT(error_after("max_range_m = 4.0", "max_range_m = 0.01"), HasSubstr("min_range_m"));
  EXPECT_THAT(error_after("edge_strength = 0.4", "edge_strength = 1.4"), HasSubstr("between"));
}

}  // namespace
}  // namespace echomap::world
