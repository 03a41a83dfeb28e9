// SPDX-License-Identifier: MIT
#include "host/datasets/edmonton_log.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class EdmontonLogTest : public tests::LogTest {
 protected:
  EdmontonLogTest() : LogTest("log_LASER.txt", open_edmonton_log) {
    put("log_ODO.txt", "1 0 0.5\n2 0.25 0\n");
  }

  std::string scan_ = tests::repeated("7.5 ", 180) + "\n";
};

TEST_F(EdmontonLogTest, AScanStandsBeforeTheIncrementOfTheSameIndex) {
  const auto records = read(scan_ + scan_);
  ASSERT_EQ(records.size(), 3U);
  EXPECT_TRUE(std::holds_alternative<sensors::RangeScan>(records[0]));
  EXPECT_EQ(std::get<OdometryStep>(records[1]).T_last_now.heading_rad(), 0.5);
  EXPECT_TRUE(std::holds_alternative<sensors::RangeScan>(records[2]));
}

TEST_F(EdmontonLogTest, BeamsGoFromRightToLeftAndThirtyMetresAreNoReturn) {
  const auto scan =
      tests::only<sensors::RangeScan>(read("1 29.9 30 51.15" + tests::repeated(" 2", 176) + "\n"))
          .at(0);
  ASSERT_EQ(scan.beams.size(), 180U);
  EXPECT_EQ(scan.beams[0], (sensors::Beam{geometry::radians(-90.0), 1.0}));
  EXPECT_EQ(scan.beams[1].range_m, 29.9);
  EXPECT_EQ(scan.beams[2].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[3].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[179], (sensors::Beam{geometry::radians(89.0), 2.0}));
}

TEST_F(EdmontonLogTest, TimesAndReferencesAreTakenFromTheirFilesWhereTheyAreThere) {
  put("log_TIME_interp.txt", "# time\n21.5\n21.5\n");
  put("log_REF.txt", "# scan x y theta t\n1 10 20 0.25 3\n");
  const auto records = read(scan_ + scan_);
  const auto scans = tests::only<sensors::RangeScan>(records);
  EXPECT_EQ(scans[0].stamp_s, 21.5);
  EXPECT_EQ(scans[1].stamp_s, std::nullopt) << "a clamped time does not rise";
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(std::get<GivenPose>(records[2]).T_map_robot.y_m(), 20.0);
}

TEST_F(EdmontonLogTest, WhatIsMissingIsNamed) {
  EXPECT_THAT(error_of(scan_ + scan_ + scan_), HasSubstr("_LASER.txt:3: no line of"));
  EXPECT_THAT(error_of("1 2 3\n"), HasSubstr("_LASER.txt:1: a range is missing"));
  EXPECT_THAT(error_of(tests::repeated("1 ", 181)), HasSubstr("_LASER.txt:1: '1 ' follows"));
  put("log_ODO.txt", "1 0\n");
  EXPECT_THAT(error_of(scan_), HasSubstr("_ODO.txt:1: the increment is missing"));
  std::filesystem::remove(folder_ / "log_ODO.txt");
  EXPECT_THAT(error_of(scan_), HasSubstr("the log lacks its file"));
}

TEST(RealEdmontonLog, HasThePathOfItsReadme) {
  const auto path = tests::real_data("edmonton/dataset_edmonton.rawlog_LASER.txt.gz");
  ECHOMAP_SKIP_WITHOUT(path);
  const auto records = tests::records_of(*open_edmonton_log(path));
  EXPECT_EQ(tests::only<sensors::RangeScan>(records).size(), 3005U);
  EXPECT_EQ(tests::only<GivenPose>(records).size(), 175U);
  double path_m = 0.0;
  double turn_rad = 0.0;
  for (const auto& step : tests::only<OdometryStep>(records)) {
    path_m += step.T_last_now.position_m().norm();
    turn_rad += std::abs(step.T_last_now.heading_rad());
  }
  EXPECT_NEAR(path_m, 326.7, 0.05);
  EXPECT_NEAR(turn_rad, 77.6, 0.05);
}

}  // namespace
}  // namespace echomap::datasets
