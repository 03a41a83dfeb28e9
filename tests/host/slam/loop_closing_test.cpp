// SPDX-License-Identifier: MIT
#include "host/slam/loop_closing.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/slam/laser_building.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

LoopClosing loop_closing() { return {{}, {}, {}, {}}; }

/// Key frames that a robot has added, and where it truly was.
struct Drive {
  std::mt19937 random{1};
  KeyFrames frames;
  Pose2 T_world_robot;

  void see(const tests::LaserBuilding& building, const Pose2& T_map_robot) {
    KeyFrame frame{{}, {{{}, building.scan(T_world_robot, 180, random)}}};
    frame.points_m = end_points_m(frame.scans[0].scan, 20.0);
    const std::size_t newest = frames.add(T_map_robot, std::move(frame));
    if (newest > 0) {
      frames.join({newest - 1,
                   newest,
                   frames.T_map_frame(newest - 1).inverse() * T_map_robot,
                   1e4 * Eigen::Matrix3d::Identity(),
                   false});
    }
  }
};

/// Half a metre a step along the middle of the ring's corridors, from a corner on.
Pose2 on_ring(int step) {
  constexpr double kStepM = 0.5;
  const Eigen::Vector2d corners_m[] = {{1.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}, {1.0, 11.0}};
  double left_m = kStepM * step;
  for (int side = 0;; side = (side + 1) % 4) {
    const Eigen::Vector2d way_m = corners_m[(side + 1) % 4] - corners_m[side];
    if (left_m < way_m.norm()) {
      const Eigen::Vector2d at_m = corners_m[side] + left_m * way_m.normalized();
      return {at_m.x(), at_m.y(), side * std::numbers::pi / 2};
    }
    left_m -= way_m.norm();
  }
}

TEST(LoopClosing, SaysHowFarTheRobotHasDriftedAroundARing) {
  const auto building = tests::LaserBuilding::ring();
  const Pose2 drift_at_end(0.4, -0.25, 0.03);
  LoopClosing closing = loop_closing();
  Drive drive;
  std::vector<PoseEdge> edges;
  for (int step = 0; step < 110 && edges.empty(); ++step) {
    drive.T_world_robot = on_ring(step);
    const double share = step / 100.0;
    const Pose2 drift(
        share * drift_at_end.x_m(), share * drift_at_end.y_m(), share * drift_at_end.heading_rad());
    drive.see(building, drive.T_world_robot * drift);
    edges = closing.close(drive.frames);
  }
  ASSERT_FALSE(edges.empty());
  for (const PoseEdge& edge : edges) {
    const Pose2 truth =
        on_ring(static_cast<int>(edge.from)).inverse() * on_ring(static_cast<int>(edge.to));
    EXPECT_LT((edge.T_from_to.position_m() - truth.position_m()).norm(), 0.1);
    EXPECT_NEAR(edge.T_from_to.heading_rad(), truth.heading_rad(), 0.02);
    EXPECT_TRUE(edge.is_doubtful);
  }
}

TEST(LoopClosing, IsNotTakenInByAnotherPlaceWhereAnOldOneShouldBe) {
  const auto ring = tests::LaserBuilding::ring();
  const auto hall = tests::LaserBuilding::hall();
  LoopClosing closing = loop_closing();
  Drive drive;
  for (int step = 0; step < 40; ++step) {
    drive.T_world_robot = on_ring(step);
    drive.see(ring, drive.T_world_robot);
  }
  for (int step = 0; step < 20; ++step) {
    drive.T_world_robot = {2.0 + 0.3 * step, 4.0, 0.0};
    drive.see(hall, on_ring(step));
    EXPECT_TRUE(closing.close(drive.frames).empty()) << step;
  }
}

TEST(LoopClosing, LooksForNothingNearAlongTheWay) {
  const auto building = tests::LaserBuilding::hall();
  LoopClosing closing = loop_closing();
  Drive drive;
  for (int step = 0; step < 12; ++step) {
    drive.T_world_robot = {3.0 + 0.5 * step, 2.0, 0.0};
    drive.see(building, drive.T_world_robot);
    EXPECT_TRUE(closing.close(drive.frames).empty());
  }
}

TEST(LoopClosing, RefusesParametersWithoutSense) {
  LoopClosingParams params;
  params.patch_m = 0.0;
  EXPECT_THROW(LoopClosing(params, {}, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
