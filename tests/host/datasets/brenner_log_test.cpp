// SPDX-License-Identifier: MIT
#include "host/datasets/brenner_log.hpp"

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/odometry.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class BrennerLogTest : public tests::LogTest {
 protected:
  BrennerLogTest() : LogTest("robot4_scan.txt", open_brenner_log) {
    put("robot4_motors.txt",
        "M 200 1000 0 0 0 500 0\r\nM 400 1100 0 0 0 600 0\r\nM 600 1090 0 0 0 600 0\r\n");
  }
};

TEST_F(BrennerLogTest, RecordsOfItsFilesComeInTheOrderOfTheirStamps) {
  put("robot4_reference.txt", "P 500 1850 1897\r\n");
  const auto records = read("S 300 2 1000 0\r\nS 700 1 5000\r\n");
  ASSERT_EQ(records.size(), 6U);
  EXPECT_EQ(std::get<WheelIncrement>(records[0]).left_m, 0.0) << "counts start anywhere";
  const auto& scan = std::get<sensors::RangeScan>(records[1]);
  EXPECT_EQ(scan.stamp_s, 0.3);
  EXPECT_EQ(scan.T_robot_sensor.x_m(), 0.030);
  EXPECT_EQ(scan.beams[0].range_m, 1.0);
  EXPECT_EQ(scan.beams[1].range_m, std::nullopt);
  EXPECT_DOUBLE_EQ(std::get<WheelIncrement>(records[2]).left_m, 100 * 0.000349);
  EXPECT_DOUBLE_EQ(std::get<GivenPosition>(records[3]).position_m.x(), 1.85);
  EXPECT_DOUBLE_EQ(std::get<WheelIncrement>(records[4]).left_m, -10 * 0.000349);
  EXPECT_EQ(std::get<sensors::RangeScan>(records[5]).beams[0].range_m, std::nullopt);
}

TEST_F(BrennerLogTest, Beam330LooksAlongTheAxisOfTheScannerThatIsTurnedToTheRight) {
  const auto scan =
      tests::only<sensors::RangeScan>(read("S 300 660" + tests::repeated(" 1", 660))).at(0);
  EXPECT_NEAR(scan.beams[330].bearing_rad, geometry::radians(-4.0), 1e-6);
  EXPECT_NEAR(scan.beams[331].bearing_rad - scan.beams[330].bearing_rad, 0.006135923, 1e-12);
}

TEST_F(BrennerLogTest, ErrorsNameTheFileThatIsWrong) {
  EXPECT_THAT(error_of("S 300 3 1 2\n"), HasSubstr("_scan.txt:1: the number of ranges is '3'"));
  EXPECT_THAT(error_of("M 300 1 1\n"), HasSubstr("_scan.txt:1: the kind of line is 'M', not S"));
  put("robot4_motors.txt", "M 200 1000 0 0\n");
  EXPECT_THAT(error_of("S 300 1 1\n"), HasSubstr("_motors.txt:1: a field is missing"));
}

TEST(RealBrennerLog, DeadReckoningMissesTheReferenceByAsMuchAsItsReadmeSays) {
  const auto path = tests::real_data("lego_brenner/robot4_scan.txt.gz");
  ECHOMAP_SKIP_WITHOUT(path);
  const auto log = open_brenner_log(path);
  const geometry::Pose2 T_map_start(1.850, 1.897, geometry::radians(213.0));
  geometry::Pose2 T_start_robot;
  double final_error_m = 0.0;
  std::size_t scans = 0;
  while (const auto record = log->next()) {
    if (const auto* wheels = std::get_if<WheelIncrement>(&*record)) {
      sensors::WheelOdometry step(wheels->track_m);
      T_start_robot = T_start_robot * step.update({wheels->left_m, wheels->right_m});
    }
    if (const auto* given = std::get_if<GivenPosition>(&*record)) {
      const auto T_map_robot = T_map_start * T_start_robot;
      final_error_m = (T_map_robot.position_m() - given->position_m).norm();
    }
    scans += std::holds_alternative<sensors::RangeScan>(*record) ? 1 : 0;
  }
  EXPECT_EQ(scans, 278U);
  EXPECT_NEAR(final_error_m, 1.050, 0.05);
}

}  // namespace
}  // namespace echomap::datasets
