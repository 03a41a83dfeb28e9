// SPDX-License-Identifier: MIT
#include "host/papers/laser_hall.hpp"

#include <gtest/gtest.h>

#include "host/papers/laser_log.hpp"

namespace echomap::papers {
namespace {

TEST(LaserHall, IsDrivenFarFromItsWalls) {
  const auto hall = laser_hall();
  const auto drive = drive_hall(hall, 1);
  EXPECT_EQ(drive.records.size(), 2 * drive.T_start_scans.size() - 1);
  EXPECT_GT(path_length_m(drive.T_start_scans), 100.0);
  for (const geometry::Pose2& pose : drive.T_start_scans) {
    EXPECT_GT(hall.clearance_m((hall.T_world_start() * pose).position_m()), 0.3);
  }
}

TEST(LaserHall, BeamsEndAtItsWallsFromTruePoses) {
  const auto hall = laser_hall();
  const auto drive = drive_hall(hall, 1);
  const auto ends_m = scanned_points_m(drive.records, drive.T_start_scans, 30.0);
  EXPECT_EQ(ends_m.size(), 180 * drive.T_start_scans.size()) << "each beam meets something";
  for (std::size_t i = 0; i < ends_m.size(); i += 97) {
    EXPECT_LT(hall.clearance_m(hall.T_world_start() * ends_m[i]), 0.1);
  }
}

TEST(LaserHall, OdometryDriftsByTheSeed) {
  const auto hall = laser_hall();
  const auto drive = drive_hall(hall, 1);
  const auto same = drive_hall(hall, 1);
  const auto other = drive_hall(hall, 2);
  const auto end_m = [](const LaserDrive& of) {
    return composed_odometry(of.records).back().position_m();
  };
  EXPECT_EQ(end_m(drive), end_m(same));
  EXPECT_NE(end_m(drive), end_m(other));
  EXPECT_EQ(drive.T_start_scans.back().position_m(), other.T_start_scans.back().position_m());
  EXPECT_GT((end_m(drive) - drive.T_start_scans.back().position_m()).norm(), 0.1);
}

}  // namespace
}  // namespace echomap::papers
