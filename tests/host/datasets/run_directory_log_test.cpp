// SPDX-License-Identifier: MIT
#include "host/datasets/run_directory_log.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "host/datasets/line_reader.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"

namespace echomap::datasets {
namespace {

using ::testing::HasSubstr;

class RunDirectoryLogTest : public tests::LogTest {
 protected:
  RunDirectoryLogTest() : LogTest("poses.csv", open_run_directory_log) {
    put("points.csv", "x_m,y_m,pose_index\n1,0,0\n0,2,0\n1,3,2\n");
  }

  std::string poses_ = "x_m,y_m,heading_rad\n0,0,0\n5,5,0\n1,1,1.5707963267948966\n";
};

TEST_F(RunDirectoryLogTest, EachPoseIsFollowedByTheEchoesItSaw) {
  const auto records = read(poses_);
  ASSERT_EQ(records.size(), 8U);
  EXPECT_EQ(std::get<OdometryPose>(records[0]).T_odom_robot.x_m(), 0.0);
  EXPECT_EQ(std::get<GivenPose>(records[1]).T_map_robot.x_m(), 0.0);
  const auto& first = std::get<sensors::RangeScan>(records[2]);
  EXPECT_EQ(first.beams, (std::vector<sensors::Beam>{{0.0, 1.0}, {std::numbers::pi / 2.0, 2.0}}));
  EXPECT_EQ(std::get<OdometryPose>(records[3]).T_odom_robot.x_m(), 5.0);
  EXPECT_EQ(std::get<GivenPose>(records[4]).T_map_robot.x_m(), 5.0);
  EXPECT_EQ(std::get<GivenPose>(records[6]).T_map_robot.x_m(), 1.0);
  const auto& last = std::get<sensors::RangeScan>(records[7]);
  ASSERT_EQ(last.beams.size(), 1U);
  EXPECT_NEAR(last.beams[0].bearing_rad, 0.0, 1e-12);
  EXPECT_NEAR(*last.beams[0].range_m, 2.0, 1e-12);
}

TEST_F(RunDirectoryLogTest, TheFolderIsTheLogToo) {
  put("poses.csv", poses_);
  EXPECT_EQ(tests::records_of(*open_run_directory_log(folder_.path())).size(), 8U);
}

TEST_F(RunDirectoryLogTest, PointsWithoutTheirPoseAreErrors) {
  EXPECT_THAT(error_of("x_m,y_m,heading_rad\n0,0,0\n"),
              HasSubstr("points.csv:4: no pose of poses.csv has this index"));
  put("points.csv", "x_m,y_m,pose_index\n1,0,1\n1,0,0\n");
  EXPECT_THAT(error_of(poses_), HasSubstr("points.csv:3: the index of the pose falls"));
  put("points.csv", "x_m,y_m,pose_index\n1,0,0\n1,");
  try {
    read(poses_);
    ADD_FAILURE() << "half an echo, and two poses are still to come";
  } catch (const CutOffLine&) {
    ADD_FAILURE() << "that would say that all is read";
  } catch (const files::FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("points.csv:3: "));
  }
  put("points.csv", "a,b\n");
  EXPECT_THAT(error_of(poses_),
              HasSubstr("points.csv:1: expected the header 'x_m,y_m,pose_index'"));
}

}  // namespace
}  // namespace echomap::datasets
