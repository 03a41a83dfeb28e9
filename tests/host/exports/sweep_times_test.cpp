// SPDX-License-Identifier: MIT
#include "host/exports/sweep_times.hpp"

#include <memory>

#include <gtest/gtest.h>

#include "tests/support/panned_stops.hpp"

namespace echomap::exports {
namespace {

std::vector<std::size_t> poses_of(const pipeline::Snapshot& snapshot) {
  std::vector<std::size_t> poses;
  for (const TimedSweep& timed : timed_sweeps(snapshot)) {
    poses.push_back(timed.pose);
  }
  return poses;
}

void set_scans(pipeline::Snapshot& snapshot, std::vector<mapping::Scan> scans) {
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(std::move(scans));
}

mapping::Scan first_readings(mapping::Scan scan, std::size_t count) {
  scan.resize(count);
  return scan;
}

TEST(SweepTimes, AreTheEndsOfTheStays) {
  EXPECT_EQ(poses_of(tests::run_of_two_stops()), (std::vector<std::size_t>{101, 300}));
}

TEST(SweepTimes, OfOneStayAreSharedByReadings) {
  pipeline::Snapshot snapshot = tests::run_of_two_stops();
  const mapping::Scan whole = tests::half_circle_scan({}, 0.5);
  set_scans(snapshot, {whole, first_readings(whole, 9)});
  EXPECT_EQ(poses_of(snapshot), (std::vector<std::size_t>{101 * 19 / 28, 101}));
}

TEST(SweepTimes, OfShortSweepsLieBetweenTheStays) {
  pipeline::Snapshot snapshot = tests::run_of_two_stops();
  const mapping::Scan pair = first_readings(tests::half_circle_scan({0.3, 0.0, 0.0}, 0.5), 2);
  set_scans(snapshot, {snapshot.scans->at(0), pair, snapshot.scans->at(1), pair});
  EXPECT_EQ(poses_of(snapshot), (std::vector<std::size_t>{101, 200, 300, 300}));
}

TEST(SweepTimes, OfPlacesWhereTheRobotNeverStayedAreSpreadOverTheRun) {
  pipeline::Snapshot snapshot = tests::run_of_two_stops();
  const mapping::Scan elsewhere = tests::half_circle_scan({5.0, 5.0, 0.0}, 0.5);
  set_scans(snapshot, {elsewhere, elsewhere, elsewhere});
  EXPECT_EQ(poses_of(snapshot), (std::vector<std::size_t>{100, 200, 300}));
}

TEST(SweepTimes, OfARunWithoutATrajectoryAreNone) {
  pipeline::Snapshot snapshot = tests::run_of_two_stops();
  snapshot.trajectory = std::make_shared<const std::vector<pipeline::StampedPose>>();
  EXPECT_TRUE(timed_sweeps(snapshot).empty());
}

}  // namespace
}  // namespace echomap::exports
