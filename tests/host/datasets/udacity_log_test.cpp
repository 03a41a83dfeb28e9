// SPDX-License-Identifier: MIT
#include "host/datasets/udacity_log.hpp"

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;
using ::testing::HasSubstr;

class UdacityLogTest : public tests::LogTest {
 protected:
  UdacityLogTest() : LogTest("measurement.txt", open_udacity_log) {
    put("poses.txt", "1000 2000 -500 900\n1500 0 0 0\n");
  }
};

TEST_F(UdacityLogTest, PosesAreInMillimetresAndTenthsOfADegree) {
  const auto records = read("1000 1 2 3 4 5 6 7 8\n");
  ASSERT_EQ(records.size(), 2U);
  const auto& given = std::get<GivenPose>(records[0]);
  EXPECT_EQ(given.stamp_s, 1.0);
  EXPECT_EQ(given.T_map_robot.x_m(), 2.0);
  EXPECT_EQ(given.T_map_robot.y_m(), -0.5);
  EXPECT_DOUBLE_EQ(given.T_map_robot.heading_rad(), radians(90.0));
}

TEST_F(UdacityLogTest, SonarsGoFromRightToLeftAnd5110IsNoReturn) {
  const auto beams =
      tests::only<sensors::RangeScan>(read("1000 5110 5109 3 4 5 6 7 400\n")).at(0).beams;
  ASSERT_EQ(beams.size(), 8U);
  EXPECT_EQ(beams[0], (sensors::Beam{radians(-90.0), std::nullopt}));
  EXPECT_EQ(beams[1], (sensors::Beam{radians(-37.5), 5.109}));
  EXPECT_EQ(beams[7], (sensors::Beam{radians(90.0), 0.4}));
}

TEST_F(UdacityLogTest, APoseOfAnotherTimeIsAnError) {
  EXPECT_THAT(error_of("1000 1 1 1 1 1 1 1 1\n1400 1 1 1 1 1 1 1 1\n"),
              HasSubstr("measurement.txt:2: the pose of this line has another time"));
  EXPECT_THAT(error_of("1000 1 1 1 1 1 1 1\n"), HasSubstr("measurement.txt:1: a range is missing"));
}

TEST(RealUdacityLog, HasTheReadingsOfItsReadme) {
  const auto path = tests::real_data("udacity_8sonar/measurement.txt");
  ECHOMAP_SKIP_WITHOUT(path);
  const auto records = tests::records_of(*open_udacity_log(path));
  const auto scans = tests::only<sensors::RangeScan>(records);
  ASSERT_EQ(scans.size(), 413U);
  std::size_t silent = 0;
  for (const auto& scan : scans) {
    for (const auto& beam : scan.beams) {
      silent += beam.range_m ? 0 : 1;
    }
  }
  EXPECT_NEAR(static_cast<double>(silent) / (413.0 * 8.0), 0.33, 0.01);
  const auto poses = tests::only<GivenPose>(records);
  EXPECT_NEAR(*poses.back().stamp_s - *poses.front().stamp_s, 92.8, 0.05);
}

}  // namespace
}  // namespace echomap::datasets
