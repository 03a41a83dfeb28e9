// SPDX-License-Identifier: MIT
#include "host/slam/scan_slam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/sensors/range_scan.hpp"
#include "tests/host/slam/laser_building.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;

/// Drives by true steps, tells the method worse ones, and keeps both ways.
class Robot {
 public:
  Robot(tests::LaserBuilding building, int beams, const Pose2& start)
      : building_(std::move(building)), beams_(beams), truth_{start}, odometry_{start} {}

  void see(SlamMethod& method) {
    const sensors::RangeScan scan = building_.scan(truth_.back(), beams_, random_);
    method.add(odometry_.back(), is_blind ? silent(scan) : scan);
  }
  /// Odometry tells 4 % too much of a drive, turns 0.02 rad a metre to the left and shakes.
  void go(const Pose2& step) {
    std::normal_distribution<double> shake(0.0, 1.0);
    truth_.push_back(truth_.back() * step);
    const double travelled_m = step.position_m().norm();
    const Pose2 told(1.04 * step.x_m() + 0.02 * travelled_m * shake(random_),
                     step.y_m(),
                     1.02 * step.heading_rad() + travelled_m * (0.02 + 0.02 * shake(random_)));
    odometry_.push_back(odometry_.back() * told);
  }
  void jump(const Pose2& by) { odometry_.back() = odometry_.back() * by; }

  const Pose2& truth() const { return truth_.back(); }
  const Pose2& odometry() const { return odometry_.back(); }
  const std::vector<Pose2>& true_path() const { return truth_; }
  double worst_m(const std::vector<Pose2>& path) const {
    double worst = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      worst = std::max(worst, (path[i].position_m() - truth_[i].position_m()).norm());
    }
    return worst;
  }
  double odometry_worst_m() const { return worst_m(odometry_); }

  bool is_blind = false;

 private:
  static sensors::RangeScan silent(sensors::RangeScan scan) {
    for (sensors::Beam& beam : scan.beams) {
      beam.range_m.reset();
    }
    return scan;
  }

  tests::LaserBuilding building_;
  int beams_;
  std::mt19937 random_{1};
  std::vector<Pose2> truth_;
  std::vector<Pose2> odometry_;
};

/// Once around the hall's pillar.
void drive_hall(Robot& robot, SlamMethod& method, double step_m) {
  robot.see(method);
  const int steps = static_cast<int>(20.0 / step_m);
  for (int i = 0; i < steps; ++i) {
    robot.go({step_m, 0.0, 2.0 * std::numbers::pi / steps});
    robot.see(method);
  }
}

Robot hall_robot(int beams) { return {tests::LaserBuilding::hall(), beams, {8.0, 0.8, 0.1}}; }

TEST(ScanSlam, BeginsWhereOdometryDoes) {
  ScanSlam slam;
  Robot robot = hall_robot(180);
  robot.see(slam);
  EXPECT_EQ(slam.belief().T_map_robot.position_m(), robot.truth().position_m());
  ASSERT_EQ(slam.trajectory().size(), 1U);
}

TEST(ScanSlam, FollowsADenseLaserAtAnyRate) {
  for (const double step_m : {0.02, 0.1, 0.4}) {
    ScanSlam slam;
    Robot robot = hall_robot(180);
    drive_hall(robot, slam, step_m);
    ASSERT_EQ(slam.trajectory().size(), robot.true_path().size());
    EXPECT_LT(robot.worst_m(slam.trajectory()), 0.05) << step_m;
    EXPECT_GT(robot.odometry_worst_m(), 0.5);
  }
}

TEST(ScanSlam, FollowsAThinLaserByGatheringScans) {
  ScanSlam slam;
  Robot robot = hall_robot(12);
  drive_hall(robot, slam, 0.1);
  ASSERT_EQ(slam.trajectory().size(), robot.true_path().size());
  EXPECT_LT(robot.worst_m(slam.trajectory()), 0.25 * robot.odometry_worst_m());
}

/// A lap and a little of the ring; how far the trajectory is off then.
double drive_ring(SlamMethod& method) {
  Robot robot(tests::LaserBuilding::ring(), 180, {1.0, 1.0, 0.0});
  robot.see(method);
  for (const double side_m : {14.0, 10.0, 14.0, 10.0, 5.0}) {
    for (int i = 0; i < static_cast<int>(side_m / 0.25); ++i) {
      robot.go({0.25, 0.0, 0.0});
      robot.see(method);
    }
    for (int i = 0; i < 8; ++i) {
      robot.go({0.0, 0.0, std::numbers::pi / 16});
      robot.see(method);
    }
  }
  return robot.worst_m(method.trajectory());
}

bool has_loops(const ScanSlam& slam) {
  const auto& edges = slam.graph().edges();
  return std::any_of(
      edges.begin(), edges.end(), [](const PoseEdge& edge) { return edge.is_doubtful; });
}

TEST(ScanSlam, ClosesALoopAndMovesThePast) {
  ScanSlam slam;
  EXPECT_LT(drive_ring(slam), 0.15);
  EXPECT_TRUE(has_loops(slam));
}

TEST(ScanSlam, DoesNotTakeALoopThatCannotBeSolvedFor) {
  ScanSlamParams params;
  params.loops.spread_m = std::numeric_limits<double>::quiet_NaN();
  ScanSlam unsolvable(params);
  const double worst_m = drive_ring(unsolvable);
  EXPECT_FALSE(has_loops(unsolvable));
  params.closes_loops = false;
  ScanSlam open(params);
  EXPECT_EQ(worst_m, drive_ring(open));
}

TEST(ScanSlam, NeedsNoMoreKeyFramesInARoomThatItKnows) {
  ScanSlam slam;
  Robot robot(tests::LaserBuilding::room(), 180, {2.0, 0.8, 0.0});
  std::vector<std::size_t> frames;
  for (int lap = 0; lap < 20; ++lap) {
    for (int i = 0; i < 80; ++i) {
      robot.see(slam);
      robot.go({0.1, 0.0, 2.0 * std::numbers::pi / 80});
    }
    frames.push_back(slam.graph().nodes().size());
  }
  EXPECT_EQ(frames.back(), frames[2]);
  EXPECT_LT(robot.worst_m(slam.trajectory()), 0.1);
  EXPECT_GT(robot.odometry_worst_m(), 1.0);
}

TEST(ScanSlam, IsOdometryWhereNothingAnswers) {
  ScanSlam slam;
  Robot robot = hall_robot(180);
  robot.is_blind = true;
  drive_hall(robot, slam, 0.1);
  const Pose2& believed = slam.belief().T_map_robot;
  EXPECT_LT((believed.position_m() - robot.odometry().position_m()).norm(), 1e-9);
  EXPECT_EQ(slam.trajectory().size(), robot.true_path().size());
  EXPECT_GT(std::sqrt(slam.belief().covariance(0, 0)), 0.1) << "and says how little it knows";
}

TEST(ScanSlam, KeepsOdometryAlongAFeaturelessCorridor) {
  ScanSlam slam;
  Robot robot(tests::LaserBuilding::corridor(), 180, {0.0, 0.2, 0.0});
  robot.see(slam);
  for (int i = 0; i < 200; ++i) {
    robot.go({0.1, 0.0, 0.0});
    robot.see(slam);
  }
  const auto& believed = slam.belief();
  EXPECT_NEAR(believed.T_map_robot.y_m(), 0.2, 0.05) << "the walls tell";
  EXPECT_NEAR(believed.T_map_robot.heading_rad(), 0.0, 0.01);
  EXPECT_NEAR(believed.T_map_robot.x_m(), 1.04 * 20.0, 0.25) << "the drive that odometry tells";
  EXPECT_GT(believed.covariance(0, 0), 20.0 * believed.covariance(1, 1));
}

TEST(ScanSlam, IsNotHeldBackInACorridorByTheBeamsThatGrazeIt) {
  for (const int beams : {36, 12}) {
    ScanSlam slam;
    Robot robot(tests::LaserBuilding::corridor(), beams, {0.0, 0.2, 0.0});
    robot.see(slam);
    for (int i = 0; i < 200; ++i) {
      robot.go({0.1, 0.0, 0.0});
      robot.see(slam);
    }
    EXPECT_NEAR(slam.belief().T_map_robot.x_m(), 1.04 * 20.0, 0.5) << beams;
  }
}

TEST(ScanSlam, GetsOverAJumpOfTheOdometry) {
  ScanSlam slam;
  Robot robot = hall_robot(180);
  drive_hall(robot, slam, 0.1);
  robot.jump({3.0, -2.0, 1.0});
  for (int i = 0; i < 20; ++i) {
    robot.see(slam);
    robot.go({0.1, 0.0, 0.0});
  }
  EXPECT_LT(
      (slam.trajectory().back().position_m() - robot.true_path().end()[-2].position_m()).norm(),
      0.05);
}

TEST(ScanSlam, GoesOnAfterAWhileWithoutScans) {
  ScanSlam slam;
  Robot robot = hall_robot(180);
  drive_hall(robot, slam, 0.1);
  for (int i = 0; i < 10; ++i) {
    robot.go({0.1, 0.0, 0.03});
  }
  robot.see(slam);
  EXPECT_LT((slam.belief().T_map_robot.position_m() - robot.truth().position_m()).norm(), 0.05);
}

TEST(ScanSlam, RefusesParametersWithoutSense) {
  ScanSlamParams params;
  params.key_frame_m = 0.0;
  EXPECT_THROW(ScanSlam{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
