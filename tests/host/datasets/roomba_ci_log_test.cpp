// SPDX-License-Identifier: MIT
#include "host/datasets/roomba_ci_log.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

constexpr double kMetresPerTick = std::numbers::pi * 0.072 / 508.8;

class RoombaCiLogTest : public tests::LogTest {
 protected:
  RoombaCiLogTest() : LogTest("log.txt", open_roomba_ci_log) {}

  static std::string row(const char* time, int left, int right, const char* bump = "00000000") {
    return std::string(time) + ", 0, 0, 0, 0, " + std::to_string(left) + ", " +
           std::to_string(right) + ", 0, 0, 0, 0, " + bump + ", 00000000\n";
  }
  std::string header_ = "Time Stamp, Total Distance Traveled\n";
};

TEST_F(RoombaCiLogTest, CountersWrapAt16BitsEitherWay) {
  const auto wheels = tests::only<WheelIncrement>(
      read(header_ + row("0.1", 32760, -32760) + row("0.2", -32760, 32760)));
  ASSERT_EQ(wheels.size(), 2U);
  EXPECT_EQ(wheels[0].left_m, 0.0);
  EXPECT_DOUBLE_EQ(wheels[1].left_m, 16 * kMetresPerTick);
  EXPECT_DOUBLE_EQ(wheels[1].right_m, -16 * kMetresPerTick);
  EXPECT_THAT(error_of(header_ + row("0.1", 32768, 0)), HasSubstr("more than 16 bits hold"));
}

TEST_F(RoombaCiLogTest, TheBumperByteIsBinary) {
  const auto contacts =
      tests::only<Contact>(read(header_ + row("0.1", 0, 0) + row("0.2", 0, 0, "00000001") +
                                row("0.3", 0, 0, "00000010") + row("0.4", 0, 0, "00000011")));
  ASSERT_EQ(contacts.size(), 4U);
  EXPECT_FALSE(contacts[0].bump_left || contacts[0].bump_right);
  EXPECT_TRUE(contacts[1].bump_right && !contacts[1].bump_left);
  EXPECT_TRUE(contacts[2].bump_left && !contacts[2].bump_right);
  EXPECT_TRUE(contacts[3].bump_left && contacts[3].bump_right);
}

TEST_F(RoombaCiLogTest, TheHeadingOf2021IsTurnedFromClockwise) {
  const auto records = read(
      "0.024547, 12428, -13485, 62.5, 00000001, 00111111, 1988, 1832, 414, 296, 2083, 1156;\n");
  ASSERT_EQ(records.size(), 3U);
  EXPECT_DOUBLE_EQ(std::get<Heading>(records[0]).heading_rad, geometry::radians(-62.5));
  EXPECT_EQ(std::get<WheelIncrement>(records[1]).stamp_s, 0.024547);
  EXPECT_TRUE(std::get<Contact>(records[2]).bump_right);
}

TEST_F(RoombaCiLogTest, ErrorsNameTheLine) {
  EXPECT_THAT(error_of(header_ + row("0.1", 0, 0, "00000002")),
              HasSubstr("log.txt:2: the bumper byte is '00000002', not eight binary digits"));
  EXPECT_THAT(error_of("0.1, 1, 2, 3\n"), HasSubstr("log.txt:1: the bumper byte is missing"));
}

TEST(RealRoombaCiLogs, DriveAndBumpAsTheirReadmeSays) {
  struct Case {
    const char* file;
    double distance_m;
    std::size_t bumps;
  };
  for (const auto& [file, distance_m, bumps] : {Case{"2018_Summer_DataTest1a.txt.gz", 6.56, 105},
                                                Case{"2018_Summer_DataTest2a.txt.gz", 8.09, 217}}) {
    const auto path = tests::real_data("roomba_ci_clemson") / file;
    ECHOMAP_SKIP_WITHOUT(path);
    const auto records = tests::records_of(*open_roomba_ci_log(path));
    double found_m = 0.0;
    for (const auto& increment : tests::only<WheelIncrement>(records)) {
      found_m += (increment.left_m + increment.right_m) / 2.0;
    }
    std::size_t found = 0;
    for (const auto& contact : tests::only<Contact>(records)) {
      found += contact.bump_left || contact.bump_right ? 1 : 0;
    }
    EXPECT_NEAR(found_m, distance_m, 0.01) << file;
    EXPECT_EQ(found, bumps) << file;
  }
}

TEST(RealRoombaCiLogs, WheelsAndGyroTurnTheSameWay) {
  const auto path = tests::real_data("roomba_ci_clemson/2021_Fall_LightBump_R3_corner_1.txt.gz");
  ECHOMAP_SKIP_WITHOUT(path);
  double by_wheels_rad = 0.0;
  double by_gyro_rad = 0.0;
  std::optional<double> last_rad;
  for (const auto& record : tests::records_of(*open_roomba_ci_log(path))) {
    if (const auto* wheels = std::get_if<WheelIncrement>(&record)) {
      by_wheels_rad += (wheels->right_m - wheels->left_m) / wheels->track_m;
    } else if (const auto* heading = std::get_if<Heading>(&record)) {
      by_gyro_rad += last_rad ? geometry::angle_between(*last_rad, heading->heading_rad) : 0.0;
      last_rad = heading->heading_rad;
    }
  }
  EXPECT_LT(by_wheels_rad, -20.0);
  EXPECT_NEAR(by_gyro_rad / by_wheels_rad, 1.0, 0.06);
}

}  // namespace
}  // namespace echomap::datasets
