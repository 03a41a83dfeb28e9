// SPDX-License-Identifier: MIT
#include "host/datasets/breezyslam_log.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class BreezyslamLogTest : public tests::LogTest {
 protected:
  BreezyslamLogTest() : LogTest("exp1.dat", open_breezyslam_log) {}

  static std::string line(const char* begin, const std::string& ranges) {
    return begin + tests::repeated(" 0", 20) + ranges + "\n";
  }
};

TEST_F(BreezyslamLogTest, TicksAreTheThirdAndFourthField) {
  const std::string ranges = tests::repeated(" 1000", 683);
  const auto wheels = tests::only<WheelIncrement>(
      read(line("1000000 99 29221 25178", ranges) + line("1500000 99 31221 24178", ranges)));
  ASSERT_EQ(wheels.size(), 2U);
  EXPECT_EQ(wheels[0].left_m, 0.0);
  EXPECT_DOUBLE_EQ(wheels[1].left_m, 2.0 * std::numbers::pi * 0.077);
  EXPECT_DOUBLE_EQ(wheels[1].right_m, -std::numbers::pi * 0.077);
  EXPECT_EQ(wheels[1].stamp_s, 1.5);
}

TEST_F(BreezyslamLogTest, TheMiddleBeamLooksAheadAndTheOuterOnesAreLeftOut) {
  const std::string ranges =
      tests::repeated(" 200", 70) + tests::repeated(" 1500", 543) + tests::repeated(" 200", 70);
  const auto scan = tests::only<sensors::RangeScan>(read(line("1 0 0 0", ranges))).at(0);
  EXPECT_EQ(scan.T_robot_sensor.x_m(), 0.145);
  ASSERT_EQ(scan.beams.size(), 543U);
  EXPECT_EQ(scan.beams[271], (sensors::Beam{0.0, 1.5}));
  EXPECT_NEAR(scan.beams[272].bearing_rad, std::numbers::pi / 512.0, 1e-12);
  EXPECT_EQ(scan.beams[0].range_m, 1.5);
  EXPECT_EQ(scan.beams[542].range_m, 1.5);
}

TEST_F(BreezyslamLogTest, ZeroAndErrorCodesAreNoReturn) {
  const std::string ranges =
      tests::repeated(" 1", 70) + " 0 19 20 5600" + tests::repeated(" 1", 609);
  const auto scan = tests::only<sensors::RangeScan>(read(line("1 0 0 0", ranges))).at(0);
  EXPECT_EQ(scan.beams[0].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[1].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[2].range_m, 0.020);
  EXPECT_EQ(scan.beams[3].range_m, std::nullopt);
}

TEST_F(BreezyslamLogTest, ErrorsNameTheLine) {
  EXPECT_THAT(error_of(line("1 0 0 0", " 1 2 3")), HasSubstr("exp1.dat:1: a range is missing"));
}

TEST(RealBreezyslamLog, HasThePathOfItsReadme) {
  const auto path = tests::real_data("breezyslam_mines/exp1.dat.gz");
  ECHOMAP_SKIP_WITHOUT(path);
  const auto records = tests::records_of(*open_breezyslam_log(path));
  EXPECT_EQ(tests::only<sensors::RangeScan>(records).size(), 756U);
  double path_m = 0.0;
  const auto wheels = tests::only<WheelIncrement>(records);
  for (const auto& increment : wheels) {
    path_m += std::abs(increment.left_m + increment.right_m) / 2.0;
  }
  EXPECT_NEAR(path_m, 46.0, 0.5);
  EXPECT_NEAR(*wheels.back().stamp_s - *wheels.front().stamp_s, 74.6, 0.2);
}

}  // namespace
}  // namespace echomap::datasets
