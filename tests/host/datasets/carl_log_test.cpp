// SPDX-License-Identifier: MIT
#include "host/datasets/carl_log.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;
using ::testing::HasSubstr;

class CarlLogTest : public tests::LogTest {
 protected:
  CarlLogTest() : LogTest("carl.txt", open_carl_log) {}

  std::string header_ = "timestr                l_enc    r_enc   imu_hdg  pan_ang  ds_mm\n";
};

TEST_F(CarlLogTest, HeadingAndPanAreTurnedFromClockwise) {
  const auto records = read(header_ + "20200705-092618.125, 0, 0, 10.0, 12.5, 1500\n");
  ASSERT_EQ(records.size(), 3U);
  EXPECT_DOUBLE_EQ(std::get<Heading>(records[0]).heading_rad, radians(-10.0));
  const auto& scan = std::get<sensors::RangeScan>(records[2]);
  EXPECT_EQ(scan.beams, (std::vector<sensors::Beam>{{radians(-12.5), 1.5}}));
  EXPECT_DOUBLE_EQ(scan.beam_width_rad, radians(25.0));
  EXPECT_TRUE(scan.is_light);
}

TEST_F(CarlLogTest, ThreeMetresAreNoReturn) {
  const auto records = read("20200705-092618.125,0,0,0,0,3000\n20200705-092618.500,0,0,0,0,1\n");
  EXPECT_EQ(tests::only<sensors::RangeScan>(records).at(0).beams.at(0).range_m, std::nullopt);
}

TEST_F(CarlLogTest, ATurnOfTheWheelIs360Counts) {
  const auto wheels = tests::only<WheelIncrement>(
      read("20200705-092618.125,100,0,0,0,1\n20200705-092618.376,460,-180,0,0,1\n"));
  ASSERT_EQ(wheels.size(), 2U);
  EXPECT_EQ(wheels[0].left_m, 0.0);
  EXPECT_DOUBLE_EQ(wheels[1].left_m, std::numbers::pi * 0.064);
  EXPECT_DOUBLE_EQ(wheels[1].right_m, -std::numbers::pi * 0.032);
  EXPECT_EQ(wheels[1].track_m, 0.11405);
  EXPECT_NEAR(*wheels[1].stamp_s - *wheels[0].stamp_s, 0.251, 1e-6);
}

TEST_F(CarlLogTest, StampsAreSecondsSince1970) {
  const auto scans = tests::only<sensors::RangeScan>(read("20200705-092618.125,0,0,0,0,1\n"));
  EXPECT_EQ(scans.at(0).stamp_s, 1593941178.125);
}

TEST_F(CarlLogTest, ErrorsNameTheLine) {
  for (const char* time : {"20200705-09261.8125", "20201305-092618.125", "20200230-092618.125"}) {
    EXPECT_THAT(error_of(header_ + time + ",0,0,0,0,1\n"), HasSubstr("carl.txt:2: the time is '"))
        << time;
  }
  EXPECT_THAT(error_of("20200705-092618.125,0,,0,0,1\n"),
              HasSubstr("the right encoder is missing"));
}

TEST(RealCarlLog, PansOverElevenPlacesAndDrivesAlmostTenMetres) {
  const auto path = tests::real_data("carl_gopigo3_panrange/20200705-092613.txt");
  ECHOMAP_SKIP_WITHOUT(path);
  const auto records = tests::records_of(*open_carl_log(path));
  std::set<double> bearings_rad;
  std::size_t returns = 0;
  const auto scans = tests::only<sensors::RangeScan>(records);
  for (const auto& scan : scans) {
    bearings_rad.insert(scan.beams.at(0).bearing_rad);
    returns += scan.beams[0].range_m ? 1 : 0;
  }
  EXPECT_EQ(scans.size(), 3010U);
  EXPECT_EQ(bearings_rad.size(), 11U);
  EXPECT_NEAR(static_cast<double>(returns) / 3010.0, 0.62, 0.005);
  double path_m = 0.0;
  for (const auto& wheels : tests::only<WheelIncrement>(records)) {
    path_m += std::abs(wheels.left_m + wheels.right_m) / 2.0;
  }
  EXPECT_NEAR(path_m, 9.85, 0.05);
}

}  // namespace
}  // namespace echomap::datasets
