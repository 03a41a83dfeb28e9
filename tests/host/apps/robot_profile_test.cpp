// SPDX-License-Identifier: MIT
#include "host/apps/robot_profile.hpp"

#include <filesystem>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/files/atomic_file.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::apps {
namespace {

using ::testing::HasSubstr;

const std::string kProfiles = ECHOMAP_SOURCE_DIR "/host/profiles/";

/// Loads the bundled profile with `from` replaced by `to` and answers the error.
std::string error_with(const std::string& from, const std::string& to) {
  std::string text = files::read_text_file(kProfiles + "uno_2wd.toml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = ::testing::TempDir() + test->name() + ".toml";
  files::write_text_file(path, text);
  try {
    load_robot_profile(path);
  } catch (const files::ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(RobotProfile, EveryBundledOneLoads) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(kProfiles)) {
    const auto profile = load_robot_profile(file.path());
    EXPECT_EQ(profile.name, file.path().stem());
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST(RobotProfile, TurnsMetresIntoWhatTheBoardCounts) {
  const auto nxt = load_robot_profile("nxt_tribot");
  // Singh and Bedi 2013, section 2.4: 21 counts a centimetre; 360 counts a turn of 5.5 cm.
  EXPECT_NEAR(1.0 / nxt.geometry.metres_per_tick(), 2084.0, 1.0);
  EXPECT_NEAR(nxt.ticks_per_s(), 0.30 * 360.0 / (std::numbers::pi * 0.055), 1.0);
  EXPECT_NEAR(nxt.sonar.max_echo_us, 2.0 * 2.3 / 343.2 * 1e6, 1.0);
  EXPECT_EQ(nxt.pan.min_cdeg, -9000);
}

TEST(RobotProfile, PlacesAnUnknownKey) {
  EXPECT_THAT(error_with("track_m", "trak_m"), HasSubstr("'track_m' is missing"));
  EXPECT_THAT(error_with("x_m = 0.03", "x_m = 0.03\nz_mm = 1"), HasSubstr("unknown key 'z_mm'"));
  EXPECT_THAT(error_with("x_m = 0.03", "x_m = 0.03\nping_gap = 1"),
              HasSubstr("did you mean 'ping_gap_ms'?"));
}

TEST(RobotProfile, RefusesWhatNoRobotHas) {
  EXPECT_THAT(error_with("= 0.065", "= -0.065"), HasSubstr("must be greater than zero"));
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

}  // namespace
}  // namespace echomap::apps
