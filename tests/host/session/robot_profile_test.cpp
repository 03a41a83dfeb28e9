// SPDX-License-Identifier: MIT
#include "host/session/robot_profile.hpp"

#include <filesystem>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/boards/boards.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/toml_reader.hpp"
#include "protocol/config_digest.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::session {
namespace {

using ::testing::HasSubstr;

const std::string profiles = ECHOMAP_SOURCE_DIR "/host/profiles/";

/// Loads the bundled profile with `from` replaced by `to`.
RobotProfile profile_with(const std::string& from,
                          const std::string& to,
                          const std::string& profile = "uno_2wd") {
  std::string text = files::read_text_file(profiles + profile + ".toml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const tests::ScratchFolder folder;
  const auto path = folder / "profile.toml";
  files::write_text_file(path, text);
  return load_robot_profile(path);
}

/// Loads it in the same way and answers the error.
std::string error_with(const std::string& from,
                       const std::string& to,
                       const std::string& profile = "uno_2wd") {
  try {
    profile_with(from, to, profile);
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RobotProfile, EveryBundledOneLoads) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(profiles)) {
    const auto profile = load_robot_profile(file.path());
    EXPECT_EQ(profile.name, file.path().stem());
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(RobotProfile, OfABoardNamesAMotorDriverThatTheBoardCarries) {
  for (const boards::Board& board : boards::all_boards()) {
    const auto profile = load_robot_profile(std::string(board.robot));
    EXPECT_TRUE(boards::carries(
        board, static_cast<protocol::MotorBridgeKind>(profile.configuration.wiring.bridge)))
        << profile.name << " on " << board.name;
  }
}

/// So that runs on different boards can be compared.
TEST(RobotProfile, OfAPicoTellsTheBoardWhatThatOfAnUnoTells) {
  EXPECT_EQ(protocol::config_digest(load_robot_profile("pico_2wd").configuration),
            protocol::config_digest(load_robot_profile("uno_2wd").configuration));
}

TEST(RobotProfile, TurnsMetresIntoWhatTheBoardCounts) {
  const auto nxt = load_robot_profile("nxt_tribot");
  // Singh and Bedi 2013, section 2.4: 21 counts a centimetre; 360 counts a turn of 5.5 cm.
  EXPECT_NEAR(1.0 / nxt.geometry.metres_per_tick(), 2084.0, 1.0);
  EXPECT_NEAR(nxt.ticks_per_s(), 0.30 * 360.0 / (std::numbers::pi * 0.055), 1.0);
  EXPECT_NEAR(nxt.configuration.sonar.max_echo_us, 2.0 * 2.3 / 343.2 * 1e6, 1.0);
  EXPECT_EQ(nxt.configuration.pan.kind, static_cast<std::uint8_t>(protocol::PanKind::kStepper));
  EXPECT_EQ(nxt.configuration.pan.max_cdeg, 72000) << "720 degrees";
}

TEST(RobotProfile, MayScaleEachWheelAndTheSonarsRanges) {
  const auto plain = load_robot_profile("uno_2wd");
  EXPECT_EQ(plain.geometry.left_wheel_scale, 1.0);
  EXPECT_EQ(plain.geometry.right_wheel_scale, 1.0);
  EXPECT_EQ(plain.range_scale, 1.0);

  const std::string track = "track_m = 0.140";
  const auto uneven =
      profile_with(track, "left_wheel_scale = 1.08\nright_wheel_scale = 0.97\n" + track);
  EXPECT_EQ(uneven.geometry.left_wheel_scale, 1.08);
  EXPECT_EQ(uneven.geometry.right_wheel_scale, 0.97);

  const auto shorter = profile_with("x_m = 0.03", "range_scale = 0.9\nx_m = 0.03");
  EXPECT_EQ(shorter.range_scale, 0.9);
  EXPECT_NEAR(shorter.range.speed_of_sound_m_s, 0.9 * plain.range.speed_of_sound_m_s, 1e-9);
  EXPECT_NEAR(
      shorter.configuration.sonar.max_echo_us, plain.configuration.sonar.max_echo_us / 0.9, 1.5)
      << "it listens until the same range";
}

TEST(RobotProfile, NamesTheMotorDriverInItsDriveTable) {
  EXPECT_EQ(load_robot_profile("uno_2wd").configuration.wiring.bridge, 0);
  const std::string track = "track_m = 0.140";
  const auto kit = profile_with(track, "driver = \"l293d\"\nstop = \"brake\"\n" + track);
  EXPECT_EQ(kit.configuration.wiring.bridge,
            static_cast<int>(protocol::MotorBridgeKind::kIn1In2Pwm));
  EXPECT_EQ(kit.configuration.wiring.bridge_options, protocol::kSlowPwm | protocol::kBrakeAtZero);
  EXPECT_THAT(error_with(track, "drivr = \"l293d\"\n" + track),
              HasSubstr("did you mean 'driver'?"));
}

TEST(RobotProfile, GivesEachPaperItsSensors) {
  const auto create = load_robot_profile("create");
  EXPECT_FALSE(create.has_sonar);
  EXPECT_EQ(create.configuration.pins.pin_0, protocol::kPinCliffLeft | protocol::kPinActiveHigh);
  EXPECT_EQ(create.configuration.pins.pin_4, protocol::kPinWheelDrop);
  EXPECT_EQ(create.configuration.safety.hazard_stops, 0x1F) << "cliffs and wheel-drop";
  EXPECT_EQ(create.sensors.infrared.size(), 1U);
  EXPECT_TRUE(create.sensors.battery_full_scale_v);

  const auto epuck = load_robot_profile("epuck");
  EXPECT_EQ(epuck.sensors.infrared.size(), 8U);
  EXPECT_NEAR(epuck.sensors.infrared_curve->max_m(), 0.06, 1e-12);
  EXPECT_EQ(epuck.configuration.safety.hazard_stops, 0);

  const auto ev3 = load_robot_profile("ev3_mega");
  EXPECT_EQ(ev3.configuration.pan.kind, static_cast<int>(protocol::PanKind::kStepper));
  EXPECT_NEAR(ev3.pan_limit_rad, 2.0 * std::numbers::pi, 1e-12);
  EXPECT_EQ(ev3.configuration.sensors.gyro_range, 0);
  EXPECT_NEAR(ev3.sensors.gyro->full_scale_rad_per_s, 250.0 * std::numbers::pi / 180.0, 1e-12);
}

TEST(RobotProfile, TurnsSafetyIntoTheBoardsUnits) {
  const auto create = load_robot_profile("create");
  EXPECT_EQ(create.configuration.safety.stall_ms, 500);
  EXPECT_NEAR(create.configuration.safety.over_speed_ticks_per_s,
              0.6 * 508.8 / (std::numbers::pi * 0.065),
              1.0);
  EXPECT_EQ(create.configuration.safety.runaway_ticks, 0);
}

TEST(RobotProfile, PlacesAnUnknownKey) {
  EXPECT_THAT(error_with("track_m", "trak_m"), HasSubstr("'track_m' is missing"));
  EXPECT_THAT(error_with("x_m = 0.03", "x_m = 0.03\nz_mm = 1"), HasSubstr("unknown key 'z_mm'"));
  EXPECT_THAT(error_with("x_m = 0.03", "x_m = 0.03\nping_gap = 1"),
              HasSubstr("did you mean 'ping_gap_ms'?"));
}

TEST(RobotProfile, RefusesWhatNoRobotHas) {
  EXPECT_THAT(error_with("= 0.065", "= -0.065"), HasSubstr("must be greater than zero"));
  for (const char* const key : {"left_wheel_scale", "right_wheel_scale"}) {
    EXPECT_THAT(error_with("track_m = 0.140", std::string(key) + " = 0\ntrack_m = 0.140"),
                HasSubstr("'" + std::string(key) + "' must be greater than zero"));
  }
  EXPECT_THAT(error_with("x_m = 0.03", "range_scale = 0\nx_m = 0.03"),
              HasSubstr("'range_scale' must be greater than zero"));
  EXPECT_THAT(error_with("feed_forward = 19.5", "feed_forward = 1e9"),
              HasSubstr("'feed_forward' must lie from 0 to 32767"));
  EXPECT_THAT(error_with("settle_ms = 40", "settle_ms = -1"),
              HasSubstr("'settle_ms' must lie from 0 to 10000"));
  EXPECT_THAT(error_with("settle_ms = 40", "settle_ms = 10001"), HasSubstr("'settle_ms'"));
  EXPECT_THAT(error_with("odometry_period_ms = 20", "odometry_period_ms = 0"),
              HasSubstr("from 1 to 255"));
  EXPECT_THAT(error_with("acceleration_m_per_s2 = 0.6", "acceleration_m_per_s2 = 0"),
              HasSubstr("'acceleration_m_per_s2' must lie from"));
  EXPECT_THAT(error_with("beam_half_angle_deg = 13.0", "beam_half_angle_deg = 60"),
              HasSubstr("at most"));
  EXPECT_THAT(error_with("us_per_90deg = 900", "us_per_90deg = 1400"),
              HasSubstr("a servo pulse of 100 us"));
  EXPECT_THAT(error_with("max_deg = 90.0", "max_deg = 4.0"), HasSubstr("at least 6 degrees"));
  EXPECT_THAT(error_with("max_range_m = 4.0", "max_range_m = 0.01"), HasSubstr("greater than"));
  EXPECT_THAT(error_with("min_deg = -90.0", "min_deg = 10.0"),
              HasSubstr("at least 6 degrees to both sides"));
}

TEST(RobotProfile, PlacesWhatIsWrongWithWires) {
  EXPECT_THAT(error_with("\"wheel_drop\"", "\"weel_drop\"", "create"),
              HasSubstr("did you mean 'wheel_drop'?"));
  EXPECT_THAT(error_with("\"wheel_drop\"", "\"wall\"", "create"),
              HasSubstr("another pin is 'wall' already"));
  EXPECT_THAT(error_with("\"range_0\"", "\"range_0 high\"", "create"), HasSubstr("no level"));
  EXPECT_THAT(error_with("pin_9 = ", "pin_16 = ", "create"), HasSubstr("'battery'"));
  EXPECT_THAT(error_with("channel = 7", "channel = 8", "epuck"), HasSubstr("from 0 to 7"));
  EXPECT_THAT(error_with("pin_15 = \"range_7\"", "", "epuck"),
              HasSubstr("no pin of [wiring] is 'range_7'"));
  EXPECT_THAT(error_with("pin_3 = \"stepper_d\"", "", "ev3_mega"), HasSubstr("'stepper_d'"));
}

TEST(RobotProfile, PlacesWhatIsWrongWithSensors) {
  EXPECT_THAT(error_with("[512, 0.020]", "[512, 0.009]", "create"), HasSubstr("'curve' must hold"));
  EXPECT_THAT(error_with("full_scale_deg_per_s = 250", "full_scale_deg_per_s = 300", "ev3_mega"),
              HasSubstr("250, 500, 1000 and 2000"));
  EXPECT_THAT(error_with("half_steps_per_turn = 4076", "half_steps_per_turn = 0", "ev3_mega"),
              HasSubstr("must not be 0"));
  EXPECT_THAT(error_with("max_deg = 360.0", "max_deg = 721.0", "ev3_mega"),
              HasSubstr("from -720 to 720"));
  EXPECT_THAT(error_with("kind = \"stepper\"", "kind = \"motor\"", "ev3_mega"),
              HasSubstr("'kind' must"));
  EXPECT_THAT(error_with("stall_ms = 500", "stall_ms = 1001", "create"), HasSubstr("'stall_ms'"));
  EXPECT_THAT(error_with("period_ms = 50", "period_ms = 0", "epuck"), HasSubstr("from 1 to 255"));
}

}  // namespace
}  // namespace echomap::session
