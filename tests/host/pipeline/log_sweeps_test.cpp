// SPDX-License-Identifier: MIT
#include "host/pipeline/log_sweeps.hpp"

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::pipeline {
namespace {

using geometry::degrees;
using geometry::radians;

sensors::RangeScan scan_of(const std::vector<double>& bearings_deg) {
  sensors::RangeScan scan;
  for (const double bearing_deg : bearings_deg) {
    scan.beams.push_back({radians(bearing_deg), 1.0});
  }
  return scan;
}

sensors::RangeScan ping_at(double pan_deg) {
  sensors::RangeScan scan = scan_of({0.0});
  scan.T_robot_sensor = {0.03, 0.0, radians(pan_deg)};
  return scan;
}

std::vector<std::size_t> sizes(const LogSweeps& sweeps) {
  std::vector<std::size_t> sizes;
  for (const auto& sweep : sweeps.sweeps()) {
    sizes.push_back(sweep.size());
  }
  return sizes;
}

TEST(LogSweeps, HasAScanForASweepAndCutsItWhereTheSonarTurnsBack) {
  LogSweeps sweeps;
  sweeps.add(scan_of({-10.0, 0.0, 10.0, 20.0}));
  sweeps.add(scan_of({-10.0, 0.0, 10.0, 10.0, 0.0, -10.0}));
  sweeps.finish();
  EXPECT_EQ(sizes(sweeps), (std::vector<std::size_t>{4, 3, 3}));
}

TEST(LogSweeps, CollectsPingsUntilTheRobotMoves) {
  LogSweeps sweeps;
  for (const double pan_deg : {-20.0, -10.0, 0.0}) {
    sweeps.add(datasets::OdometryPose{});
    sweeps.add(ping_at(pan_deg));
  }
  sweeps.add(datasets::OdometryPose{std::nullopt, {0.3, 0.0, 0.0}});
  for (const double pan_deg : {10.0, 20.0, 30.0, 40.0}) {
    sweeps.add(ping_at(pan_deg));
    sweeps.add(datasets::WheelIncrement{});
  }
  sweeps.add(datasets::WheelIncrement{std::nullopt, 0.1, -0.1, 0.14});
  sweeps.add(ping_at(50.0));
  sweeps.finish();
  EXPECT_EQ(sizes(sweeps), (std::vector<std::size_t>{3, 4}));
  EXPECT_NEAR(degrees(sweeps.sweeps()[1].back().bearing_rad), 40.0, 1e-9);
}

TEST(LogSweeps, HasSilenceInAGapOfBearings) {
  LogSweeps sweeps;
  sweeps.add(scan_of({0.0, 10.0, 20.0, 40.0, 50.0}));
  sweeps.finish();
  ASSERT_EQ(sizes(sweeps), (std::vector<std::size_t>{6}));
  EXPECT_FALSE(sweeps.sweeps()[0][3].range_m);
  EXPECT_NEAR(degrees(sweeps.sweeps()[0][3].bearing_rad), 30.0, 1e-9);
}

TEST(LogSweeps, LeavesOutLasersAndSingleReadings) {
  LogSweeps sweeps;
  auto laser = scan_of({0.0, 1.0, 2.0});
  laser.is_light = true;
  sweeps.add(laser);
  sweeps.add(ping_at(0.0));
  sweeps.add(datasets::OdometryStep{std::nullopt, {0.1, 0.0, 0.0}});
  sweeps.add(ping_at(0.0));
  sweeps.finish();
  EXPECT_TRUE(sweeps.sweeps().empty());
  EXPECT_EQ(sweeps.laser_scans(), 1U);
}

}  // namespace
}  // namespace echomap::pipeline
