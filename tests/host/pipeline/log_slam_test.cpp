// SPDX-License-Identifier: MIT
#include "host/pipeline/log_slam.hpp"

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "tests/host/pipeline/moved_aside.hpp"

namespace echomap::pipeline {
namespace {

datasets::LogRecord at(double x_m) { return datasets::OdometryPose{{}, {x_m, 0.0, 0.0}}; }

const datasets::LogRecord scan = sensors::RangeScan{{}, {}, {{0.0, 1.0}, {0.1, {}}}, 0.0, 5.0};

TEST(LogSlam, GivesEachScanItsOdometryAndBeams) {
  MovedAside method;
  LogSlam slam(method);
  for (const auto& record : {at(1.0), scan, at(2.0), scan}) {
    slam.add(record);
  }
  EXPECT_EQ(slam.scans(), 2U);
  EXPECT_EQ(method.beams, 4U);
  EXPECT_DOUBLE_EQ(method.poses[1].x_m(), 1.0);
}

TEST(LogSlam, GoesOnByOdometryFromTheScanBefore) {
  MovedAside method;
  LogSlam slam(method);
  for (const auto& record : {at(0.5), at(1.0), scan, at(1.5), at(2.0), scan}) {
    slam.add(record);
  }
  const auto trajectory = slam.trajectory();
  ASSERT_EQ(trajectory.size(), 4U);
  EXPECT_DOUBLE_EQ(trajectory[0].y_m(), 0.0) << "before any scan";
  EXPECT_DOUBLE_EQ(trajectory[1].y_m(), 1.0) << "a scan belongs to the pose before it";
  EXPECT_DOUBLE_EQ(trajectory[2].x_m(), 1.5);
  EXPECT_DOUBLE_EQ(trajectory[2].y_m(), 1.0);
  EXPECT_DOUBLE_EQ(trajectory[3].x_m(), 2.0);
}

TEST(LogSlam, BeginsAtTheOriginWhereverTheLogBegins) {
  MovedAside method;
  LogSlam slam(method);
  for (const auto& record : {scan, at(5e6), at(5e6 + 1.0), scan}) {
    slam.add(record);
  }
  EXPECT_DOUBLE_EQ(method.poses[0].x_m(), 0.0) << "before any odometry";
  EXPECT_DOUBLE_EQ(method.poses[1].x_m(), 1.0);
  EXPECT_DOUBLE_EQ(slam.trajectory()[1].x_m(), 5e6 + 1.0);
  EXPECT_DOUBLE_EQ(slam.trajectory()[1].y_m(), 1.0);
}

TEST(LogSlam, TakesTheFirstStepToBeDrivenAfterTheScansBeforeIt) {
  MovedAside method;
  LogSlam slam(method);
  const datasets::LogRecord step = datasets::OdometryStep{{}, {0.5, 0.0, 0.0}};
  for (const auto& record : {scan, step, scan}) {
    slam.add(record);
  }
  EXPECT_DOUBLE_EQ(method.poses[1].x_m() - method.poses[0].x_m(), 0.5);
}

TEST(LogSlam, HasNoTrajectoryOfALogWithoutOdometry) {
  MovedAside method;
  LogSlam slam(method);
  slam.add(scan);
  EXPECT_TRUE(slam.trajectory().empty());
}

TEST(LogSlam, LooksAtNoPoseThatTheLogGives) {
  MovedAside method;
  LogSlam slam(method);
  for (const auto& record :
       {at(1.0), datasets::LogRecord(datasets::GivenPose{{}, {7.0, 7.0, 1.0}}), scan}) {
    slam.add(record);
  }
  EXPECT_DOUBLE_EQ(method.poses[0].x_m(), 0.0);
}

}  // namespace
}  // namespace echomap::pipeline
