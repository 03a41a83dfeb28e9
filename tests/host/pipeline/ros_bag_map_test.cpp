// SPDX-License-Identifier: MIT
// A bag of a robot with a panned sonar becomes a map as `echomap replay` makes it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/datasets/open_log.hpp"
#include "host/geometry/angle.hpp"
#include "host/pipeline/log_player.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "tests/support/bag_writer.hpp"
#include "tests/support/nearest_points.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::pipeline {
namespace {

using geometry::Pose2;
using geometry::radians;
using mapping::CellState;

/// The inner edges of the room; the robot begins at the origin.
constexpr double kLeftM = -1.0;
constexpr double kRightM = 3.0;
constexpr double kBottomM = -1.2;
constexpr double kTopM = 1.3;
constexpr double kConeRad = 0.26;

/// From a point within the room to its wall.
double distance_to_wall_m(const Eigen::Vector2d& from_m, double direction_rad) {
  const double x = std::cos(direction_rad);
  const double y = std::sin(direction_rad);
  const double along_x_m =
      std::abs(x) < 1e-9 ? 1e9 : ((x > 0.0 ? kRightM : kLeftM) - from_m.x()) / x;
  const double along_y_m =
      std::abs(y) < 1e-9 ? 1e9 : ((y > 0.0 ? kTopM : kBottomM) - from_m.y()) / y;
  return std::min(along_x_m, along_y_m);
}

/// What an ideal sonar measures: the nearest wall within its cone.
double echo_m(const Pose2& T_room_sonar) {
  double nearest_m = 1e9;
  for (int ray = -10; ray <= 10; ++ray) {
    const double direction_rad = T_room_sonar.heading_rad() + kConeRad / 2.0 * ray / 10.0;
    nearest_m = std::min(nearest_m, distance_to_wall_m(T_room_sonar.position_m(), direction_rad));
  }
  return nearest_m;
}

/// Writes the drive of a robot along the room's middle that pans its sonar all the time.
class PannedDrive {
 public:
  explicit PannedDrive(const std::filesystem::path& path) : bag_(path) {
    bag_.write("/tf_static", tests::ros_transform(0.0, "base_link", "mast", {0.05, 0.0, 0.0}), 1.0);
    while (x_m_ < 2.0) {
      step(x_m_, 0.0);
      x_m_ += 0.002;
    }
    for (int turn_deg = 0; turn_deg < 180; turn_deg += 2) {
      step(x_m_, radians(turn_deg));
    }
    bag_.finish();
  }

 private:
  void step(double x_m, double heading_rad) {
    constexpr double kStepS = 0.05;
    constexpr double kSweepRad = radians(90.0);
    time_s_ += kStepS;
    const Pose2 T_odom_robot(x_m, 0.0, heading_rad);
    const Pose2 T_mast_sonar(0.02, 0.0, kSweepRad * std::sin(time_s_));
    const double range_m = echo_m(T_odom_robot * Pose2(0.05, 0.0, 0.0) * T_mast_sonar);
    bag_.write("/odom", tests::ros_odometry(time_s_, T_odom_robot), time_s_ + 0.001);
    // The transform comes after the reading that needs it.
    bag_.write("/sonar", tests::ros_range(time_s_, "sonar", range_m), time_s_ + 0.002);
    bag_.write("/tf", tests::ros_transform(time_s_, "mast", "sonar", T_mast_sonar), time_s_ + 0.02);
  }

  tests::BagWriter bag_;
  double time_s_ = 100.0;
  double x_m_ = 0.0;
};

class RosBagMap : public testing::Test {
 protected:
  RosBagMap() {
    const PannedDrive drive(folder_ / "drive.mcap");
    RobotPipeline pipeline(sensors::RobotGeometry{});
    LogPlayer player(pipeline, PoseSource::kOdometry);
    const auto log = datasets::open_log(folder_ / "drive.mcap", "");
    while (const auto record = log->next()) {
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the loop's condition has checked it
      player.play(*record);
    }
    counts_ = player.counts();
    snapshot_ = pipeline.snapshot();
  }

  std::vector<Eigen::Vector2d> cells_m(CellState state) const {
    const mapping::OccupancyGrid& grid = *snapshot_.grid;
    const auto& bounds = grid.bounds();
    std::vector<Eigen::Vector2d> cells_m;
    for (std::int32_t y = bounds.min.y; y <= bounds.max.y; ++y) {
      for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
        if (grid.state({x, y}) == state) {
          cells_m.push_back(grid.center_m({x, y}));
        }
      }
    }
    return cells_m;
  }

  tests::ScratchFolder folder_;
  LogCounts counts_;
  Snapshot snapshot_;
};

/// Distance of a point from the outline of the room, also from without.
double distance_from_outline_m(const Eigen::Vector2d& point_m) {
  const double x_m = std::min(std::abs(point_m.x() - kLeftM), std::abs(point_m.x() - kRightM));
  const double y_m = std::min(std::abs(point_m.y() - kBottomM), std::abs(point_m.y() - kTopM));
  return std::min(x_m, y_m);
}

TEST_F(RosBagMap, HasWallsWhereTheRoomHasThem) {
  const auto walls_m = cells_m(CellState::kOccupied);
  ASSERT_GT(walls_m.size(), 100U);
  const auto near = std::count_if(walls_m.begin(), walls_m.end(), [](const auto& cell_m) {
    return distance_from_outline_m(cell_m) < 0.08;
  });
  EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(walls_m.size()));
  const tests::NearestPoints walls(walls_m);
  // The sides along the drive, and the wall ahead.
  for (double x_m = 0.2; x_m < 2.6; x_m += 0.1) {
    EXPECT_LT(walls.nearest({x_m, kTopM})->distance_m, 0.1) << x_m;
    EXPECT_LT(walls.nearest({x_m, kBottomM})->distance_m, 0.1) << x_m;
  }
  for (double y_m = -0.9; y_m < 1.0; y_m += 0.1) {
    EXPECT_LT(walls.nearest({kRightM, y_m})->distance_m, 0.1) << y_m;
  }
}

TEST_F(RosBagMap, HasFreeFloorWithinTheRoomOnly) {
  const auto floor_m = cells_m(CellState::kFree);
  const auto within = std::count_if(floor_m.begin(), floor_m.end(), [](const auto& cell_m) {
    return cell_m.x() > kLeftM && cell_m.x() < kRightM && cell_m.y() > kBottomM &&
           cell_m.y() < kTopM;
  });
  EXPECT_GT(static_cast<double>(within), 0.99 * static_cast<double>(floor_m.size()));
  constexpr double kRoomCells = (kRightM - kLeftM) * (kTopM - kBottomM) / (0.05 * 0.05);
  EXPECT_GT(static_cast<double>(within), 0.7 * kRoomCells);
}

TEST_F(RosBagMap, UsesEveryMessage) {
  EXPECT_EQ(counts_.scans, counts_.odometry_poses);
  EXPECT_EQ(counts_.scans, 1090U);
  EXPECT_EQ(counts_.poses_without_stamp, 0U);
}

}  // namespace
}  // namespace echomap::pipeline
