// SPDX-License-Identifier: MIT
#include "host/slam/loop_closing.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "tests/host/slam/laser_building.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

LoopClosing loop_closing() { return {{}, {}, {}, {}}; }

/// Key frames that a robot has added, and where it truly was.
struct KeyFrameDrive {
  std::mt19937 random{1};
  KeyFrames frames;
  Pose2 T_world_robot;

  void see(const tests::LaserBuilding& building, const Pose2& T_map_robot) {
    KeyFrame frame{{}, {{{}, building.scan(T_world_robot, 180, random)}}};
    frame.points_m = sensors::end_points_m(frame.scans[0].scan, 20.0);
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
    const Eigen::Vector2d offset_m = corners_m[(side + 1) % 4] - corners_m[side];
    if (left_m < offset_m.norm()) {
      const Eigen::Vector2d at_m = corners_m[side] + left_m * offset_m.normalized();
      return {at_m.x(), at_m.y(), side * std::numbers::pi / 2};
    }
    left_m -= offset_m.norm();
  }
}

/// How far a robot has drifted on the ring, 50 m after the start 0.47 m.
Pose2 drift_on_ring(int step) {
  const double share = step / 100.0;
  return {0.4 * share, -0.25 * share, 0.03 * share};
}

TEST(LoopClosing, SaysHowFarTheRobotHasDriftedAroundARing) {
  const auto building = tests::LaserBuilding::ring();
  LoopClosing closing = loop_closing();
  KeyFrameDrive drive;
  std::vector<PoseEdge> edges;
  for (int step = 0; step < 110 && edges.empty(); ++step) {
    drive.T_world_robot = on_ring(step);
    drive.see(building, drive.T_world_robot * drift_on_ring(step));
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

/// What the frame of a step on the ring proves if only that of one before has looked for loops.
std::vector<PoseEdge> proved_after(int first, int second, bool is_put_right) {
  const auto building = tests::LaserBuilding::ring();
  LoopClosing closing = loop_closing();
  KeyFrameDrive drive;
  Pose2 T_right_map;
  for (int step = 0; step <= second; ++step) {
    drive.T_world_robot = on_ring(step);
    drive.see(building, T_right_map * drive.T_world_robot * drift_on_ring(step));
    if (step != first) {
      continue;
    }
    EXPECT_TRUE(closing.close(drive.frames).empty()) << "one searched loop proves nothing";
    if (is_put_right) {
      const std::size_t newest = drive.frames.size() - 1;
      const Pose2 T_map_before = drive.frames.T_map_frame(newest);
      const Pose2 truth = on_ring(50).inverse() * drive.T_world_robot;
      const PoseEdge known{50, newest, truth, 1e6 * Eigen::Matrix3d::Identity(), false};
      EXPECT_TRUE(drive.frames.close_loops(std::vector{known}));
      T_right_map = drive.frames.T_map_frame(newest) * T_map_before.inverse();
    }
  }
  return closing.close(drive.frames);
}

TEST(LoopClosing, ALoopThatWaitsIsComparedInTheMapAsItIsNow) {
  EXPECT_EQ(proved_after(105, 111, false).size(), 2U);
  EXPECT_EQ(proved_after(105, 111, true).size(), 2U);
}

TEST(LoopClosing, ALoopThatHasWaitedForLongIsForgotten) {
  EXPECT_EQ(proved_after(105, 111, false).size(), 2U);
  EXPECT_TRUE(proved_after(104, 111, false).empty());
}

TEST(LoopClosing, LooksAsFarFromThePlaceAsItSearches) {
  const auto building = tests::LaserBuilding::hall();
  LoopClosingParams params;
  params.drift_m = 0.5;
  LoopClosing closing(params, {}, {}, {});
  KeyFrameDrive drive;
  std::vector<PoseEdge> edges;
  for (int step = 0; step < 16; ++step) {
    drive.T_world_robot = {2.0 + 0.5 * step, 1.2, 0.0};
    drive.see(building, drive.T_world_robot);
  }
  for (int step = 0; step < 12 && edges.empty(); ++step) {
    drive.T_world_robot = {9.0 - 0.5 * step, 3.0, std::numbers::pi};
    const Pose2 drifted(drive.T_world_robot.x_m(), 4.0, std::numbers::pi);
    drive.see(building, drifted);
    edges = closing.close(drive.frames);
  }
  EXPECT_FALSE(edges.empty()) << "2.8 m from the frames: as far as places are seen, and 1.5 sigma";
}

TEST(LoopClosing, IsNotTakenInByAnotherPlaceWhereAnOldOneShouldBe) {
  const auto ring = tests::LaserBuilding::ring();
  const auto hall = tests::LaserBuilding::hall();
  LoopClosing closing = loop_closing();
  KeyFrameDrive drive;
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
  KeyFrameDrive drive;
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
