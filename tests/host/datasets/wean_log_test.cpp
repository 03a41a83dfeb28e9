// SPDX-License-Identifier: MIT
#include "host/datasets/wean_log.hpp"

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class WeanLogTest : public tests::LogTest {
 protected:
  WeanLogTest() : LogTest("robotdata1.log", open_wean_log) {}
};

TEST_F(WeanLogTest, LengthsAreCentimetres) {
  const auto poses = tests::only<OdometryPose>(read("O -94.5 250 1.5 0.025\n"));
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_DOUBLE_EQ(poses[0].T_odom_robot.x_m(), -0.945);
  EXPECT_DOUBLE_EQ(poses[0].T_odom_robot.y_m(), 2.5);
  EXPECT_EQ(poses[0].T_odom_robot.heading_rad(), 1.5);
  EXPECT_EQ(poses[0].stamp_s, 0.025);
}

TEST_F(WeanLogTest, TheLaserIsWhereItsPoseSaysAndLooksFromRightToLeft) {
  const auto records =
      read("L 100 0 0 125 0 0 66 8183 8191 8179" + tests::repeated(" 100", 176) + " 3.5\n");
  ASSERT_EQ(records.size(), 2U);
  EXPECT_DOUBLE_EQ(std::get<OdometryPose>(records[0]).T_odom_robot.x_m(), 1.0);
  const auto& scan = std::get<sensors::RangeScan>(records[1]);
  EXPECT_DOUBLE_EQ(scan.T_robot_sensor.x_m(), 0.25);
  EXPECT_EQ(scan.stamp_s, 3.5);
  ASSERT_EQ(scan.beams.size(), 180U);
  EXPECT_EQ(scan.beams[0].bearing_rad, geometry::radians(-90.0));
  EXPECT_DOUBLE_EQ(*scan.beams[0].range_m, 0.66);
  EXPECT_EQ(scan.beams[179].bearing_rad, geometry::radians(89.0));
}

TEST_F(WeanLogTest, From81Point8MetresOnNothingReturned) {
  const auto scan = tests::only<sensors::RangeScan>(
                        read("L 0 0 0 0 0 0 8183 8191 8179" + tests::repeated(" 1", 177) + " 3\n"))
                        .at(0);
  EXPECT_EQ(scan.beams[0].range_m, std::nullopt);
  EXPECT_EQ(scan.beams[1].range_m, std::nullopt);
  EXPECT_DOUBLE_EQ(*scan.beams[2].range_m, 81.79);
}

TEST_F(WeanLogTest, ErrorsNameTheLine) {
  EXPECT_THAT(error_of("O 1 2 3 4\nX 1 2\n"), HasSubstr("log:2: the kind of line is 'X'"));
  EXPECT_THAT(error_of("O 1 2 3\n"), HasSubstr("log:1: the time is missing"));
}

TEST(RealWeanLogs, HaveTheLinesOfTheirReadme) {
  struct Case {
    const char* file;
    std::size_t odometry;
    std::size_t scans;
  };
  for (const auto& [file, odometry, scans] : {Case{"robotdata1.log.gz", 1505, 713},
                                              Case{"robotdata3.log.gz", 1735, 1241},
                                              Case{"robotdata4.log.gz", 823, 600}}) {
    const auto path = tests::real_data("wean_mcl") / file;
    ECHOMAP_SKIP_WITHOUT(path);
    const auto records = tests::records_of(*open_wean_log(path));
    const auto found = tests::only<sensors::RangeScan>(records);
    EXPECT_EQ(found.size(), scans) << file;
    EXPECT_EQ(tests::only<OdometryPose>(records).size(), odometry + scans) << file;
    for (const auto& scan : found) {
      ASSERT_NEAR(scan.T_robot_sensor.x_m(), 0.25, 0.001) << file;
      ASSERT_NEAR(scan.T_robot_sensor.y_m(), 0.0, 0.001) << file;
    }
  }
}

}  // namespace
}  // namespace echomap::datasets
