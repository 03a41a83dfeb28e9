// SPDX-License-Identifier: MIT
#include "host/datasets/carmen_log.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_files.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;
using ::testing::HasSubstr;

class CarmenLogTest : public tests::LogTest {
 protected:
  CarmenLogTest() : LogTest("a.log", open_carmen_log) {}
};

TEST_F(CarmenLogTest, AFrontLaserLineIsTwoPosesAndAScan) {
  const auto records = read("FLASER 4 1 2 3 4.5 10 20 0.5 11 21 0.25 7.5 host 7.6\n");
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(std::get<OdometryPose>(records[0]).T_odom_robot.y_m(), 21.0);
  const auto& given = std::get<GivenPose>(records[1]);
  EXPECT_EQ(given.T_map_robot.x_m(), 10.0);
  EXPECT_EQ(given.T_map_robot.heading_rad(), 0.5);
  EXPECT_EQ(given.stamp_s, 7.5);
  const auto& scan = std::get<sensors::RangeScan>(records[2]);
  EXPECT_EQ(scan.stamp_s, 7.5);
  EXPECT_EQ(scan.beam_width_rad, 0.0);
  ASSERT_EQ(scan.beams.size(), 4U);
  EXPECT_EQ(scan.beams[3].range_m, 4.5);
}

TEST_F(CarmenLogTest, BeamsGoFromRightToLeftOverHalfACircle) {
  struct Case {
    int beams;
    double step_deg;
    double last_deg;
  };
  for (const auto& [beams, step_deg, last_deg] : {Case{180, 1.0, 89.0},
                                                  Case{181, 1.0, 90.0},
                                                  Case{360, 0.5, 89.5},
                                                  Case{361, 0.5, 90.0},
                                                  Case{12, 15.0, 75.0}}) {
    std::string line = "FLASER " + std::to_string(beams);
    for (int i = 0; i < beams; ++i) {
      line += " 1";
    }
    const auto scan = tests::only<sensors::RangeScan>(read(line + " 0 0 0 0 0 0 1 h 1\n")).at(0);
    EXPECT_NEAR(scan.beams[0].bearing_rad, radians(-90.0), 1e-12) << beams;
    EXPECT_NEAR(scan.beams[1].bearing_rad, radians(step_deg - 90.0), 1e-12) << beams;
    EXPECT_NEAR(scan.beams.back().bearing_rad, radians(last_deg), 1e-12) << beams;
  }
}

TEST_F(CarmenLogTest, FiftyMetresAndMoreAndZeroAreNoReturn) {
  const auto records = read("FLASER 6 50 51.15 81.8 81.91 0 49.9 0 0 0 0 0 0 1 h 1\n");
  const auto scan = tests::only<sensors::RangeScan>(records).at(0);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(scan.beams[i].range_m, std::nullopt) << i;
  }
  EXPECT_EQ(scan.beams[5].range_m, 49.9);
}

TEST_F(CarmenLogTest, ARobotLaserLineSaysItsOwnBearingsAndRange) {
  const auto records = read(
      "ROBOTLASER1 0 -1.5 3 0.5 80 0.01 0 3 1 80 79 2 9 9 1.25 2 0.5 1 2 0.5 0 0 0 0 0 12.5 b21 "
      "1\n");
  ASSERT_EQ(records.size(), 3U);
  const auto& scan = std::get<sensors::RangeScan>(records[2]);
  EXPECT_EQ(scan.stamp_s, 12.5);
  ASSERT_EQ(scan.beams.size(), 3U);
  EXPECT_EQ(scan.beams[0], (sensors::Beam{-1.5, 1.0}));
  EXPECT_EQ(scan.beams[1], (sensors::Beam{-1.0, std::nullopt}));
  EXPECT_EQ(scan.beams[2], (sensors::Beam{-0.5, 79.0}));
  EXPECT_EQ(std::get<OdometryPose>(records[0]).T_odom_robot.x_m(), 1.0);
  EXPECT_NEAR(scan.T_robot_sensor.x_m(), 0.25 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(scan.T_robot_sensor.y_m(), -0.25 * std::sin(0.5), 1e-12);
}

TEST_F(CarmenLogTest, CommentsThatHoldTheWordFlaserAreSkipped) {
  EXPECT_TRUE(read("# message formats defined: PARAM SYNC ODOM FLASER RLASER TRUEPOS\n"
                   "# FLASER num_readings [range_readings] x y theta odom_x odom_y\n"
                   "PARAM robot_frontlaser_offset 0.0 nohost 0\nNEFF 30\n")
                  .empty());
}

TEST_F(CarmenLogTest, StampsBrokenBySinglePrecisionAreAbsent) {
  const auto poses =
      tests::only<OdometryPose>(read("ODOM 0 0 0 0 0 0 1.13486e+09 pippo 1.13486e+09\n"
                                     "ODOM 1 0 0 0 0 0 1.13486e+09 pippo 1.13486e+09\n"
                                     "ODOM 2 0 0 0 0 0 1.13487e+09 pippo 1.13487e+09\n"));
  EXPECT_EQ(poses.at(0).stamp_s, 1.13486e9);
  EXPECT_EQ(poses.at(1).stamp_s, std::nullopt);
  EXPECT_EQ(poses.at(2).stamp_s, 1.13487e9);
}

TEST_F(CarmenLogTest, ErrorsNameFileLineAndField) {
  EXPECT_THAT(error_of("ODOM 0 0 0 0 0 0 1 h 1\r\nODOM 0 0 nan 0 0 0 1 h 1\r\n"),
              HasSubstr("a.log:2: the pose is 'nan', not a finite number"));
  EXPECT_THAT(error_of("FLASER 4000000000 1 2\n"), HasSubstr("a.log:1: the number of ranges is"));
  EXPECT_THAT(error_of("FLASER 2 1 2 0 0 0 0 0 0 1 h 1 1\n"), HasSubstr("a.log:1: '1' follows"));
  EXPECT_THAT(error_of("FLASER 2 1 2 0 0"), HasSubstr("a.log:1: the pose is missing"));
}

TEST(RealCarmenLogs, HaveAsManyScansAsTheirReadmeSays) {
  struct Case {
    const char* file;
    std::size_t scans;
    std::size_t beams;
  };
  for (const auto& [file, scans, beams] :
       {Case{"carmen_corrected/aces-corrected.log.gz", 440, 180},
        Case{"carmen_corrected/belgioioso-corrected.log.gz", 395, 361},
        Case{"carmen_corrected/csail-corrected.log.gz", 406, 361},
        Case{"carmen_corrected/freiburg-079-corrected.log.gz", 4791, 360},
        Case{"carmen_raw/csail.log.gz", 686, 361},
        Case{"edmonton/edmonton-corrected.log.gz", 340, 180}}) {
    const auto path = tests::real_data(file);
    ECHOMAP_SKIP_WITHOUT(path);
    const auto found = tests::only<sensors::RangeScan>(tests::records_of(*open_carmen_log(path)));
    ASSERT_EQ(found.size(), scans) << file;
    for (const auto& scan : found) {
      ASSERT_EQ(scan.beams.size(), beams) << file;
    }
  }
}

TEST(RealCarmenLogs, TheStampsOfCsailAreBrokenAndThoseOfAcesAreNot) {
  const auto stamped = [](const std::filesystem::path& path) {
    std::size_t count = 0;
    for (const auto& scan :
         tests::only<sensors::RangeScan>(tests::records_of(*open_carmen_log(path)))) {
      count += scan.stamp_s ? 1 : 0;
    }
    return count;
  };
  const auto broken = tests::real_data("carmen_corrected/csail-corrected.log.gz");
  const auto right = tests::real_data("carmen_corrected/aces-corrected.log.gz");
  ECHOMAP_SKIP_WITHOUT(broken);
  EXPECT_EQ(stamped(broken), 2U);
  EXPECT_EQ(stamped(right), 440U);
}

}  // namespace
}  // namespace echomap::datasets
