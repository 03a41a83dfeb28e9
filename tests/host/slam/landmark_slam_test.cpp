// SPDX-License-Identifier: MIT
#include "host/slam/landmark_slam.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;
using geometry::Segment;

constexpr int kSteps = 240;

/// A room of 8 m x 6 m with a cupboard in it.
const std::vector<Segment> room{{{-4.0, -3.0}, {4.0, -3.0}},
                                {{4.0, -3.0}, {4.0, 3.0}},
                                {{4.0, 3.0}, {-4.0, 3.0}},
                                {{-4.0, 3.0}, {-4.0, -3.0}},
                                {{-0.6, -0.5}, {0.6, -0.5}},
                                {{0.6, -0.5}, {0.6, 0.5}},
                                {{0.6, 0.5}, {-0.6, 0.5}},
                                {{-0.6, 0.5}, {-0.6, -0.5}}};

sensors::RangeScan scan_from(const Pose2& T_map_robot, const std::vector<Segment>& walls) {
  sensors::RangeScan scan;
  scan.max_range_m = 30.0;
  for (int i = 0; i < 360; ++i) {
    const double bearing_rad = geometry::radians(-180.0 + i);
    std::optional<double> nearest_m;
    for (const Segment& wall : walls) {
      const auto range_m =
          geometry::ray_distance_m(T_map_robot.position_m(),
                                   geometry::unit_vector(T_map_robot.heading_rad() + bearing_rad),
                                   wall);
      if (range_m && (!nearest_m || *range_m < *nearest_m)) {
        nearest_m = range_m;
      }
    }
    scan.beams.push_back({bearing_rad, nearest_m});
  }
  return scan;
}

/// Around the cupboard.
Pose2 pose_at(int step) {
  const double along_rad = 2.0 * std::numbers::pi * step / 120.0;
  return {2.5 * std::cos(along_rad), 2.0 * std::sin(along_rad), along_rad + std::numbers::pi / 2.0};
}

struct DriveErrors {
  double odometry_off_m = 0.0;
  double off_m = 0.0;
};

/// Twice around, with odometry that turns too far.
DriveErrors drive(LandmarkSlam& slam) {
  Pose2 T_odom_robot = pose_at(0);
  DriveErrors result;
  for (int step = 0; step <= kSteps; ++step) {
    if (step > 0) {
      const Pose2 moved = pose_at(step - 1).inverse() * pose_at(step);
      T_odom_robot =
          T_odom_robot * Pose2(1.02 * moved.x_m(), moved.y_m(), 1.03 * moved.heading_rad());
    }
    slam.add(T_odom_robot, scan_from(pose_at(step), room));
    const Eigen::Vector2d truth_m = pose_at(step).position_m();
    result.odometry_off_m =
        std::max(result.odometry_off_m, (T_odom_robot.position_m() - truth_m).norm());
    result.off_m =
        std::max(result.off_m, (slam.belief().T_map_robot.position_m() - truth_m).norm());
  }
  return result;
}

TEST(LandmarkSlam, RefusesGatesThatAreNone) {
  LandmarkSlamParams params;
  params.update.association.gate_of_new = 1.0;
  EXPECT_THROW(LandmarkSlam{params}, std::invalid_argument);
}

TEST(LandmarkSlam, KnowsWhereItIsInARoomThatItDidNotKnow) {
  for (const auto method :
       {AssociationMethod::kNearestNeighbour, AssociationMethod::kJointCompatibility}) {
    LandmarkSlamParams params;
    params.update.method = method;
    LandmarkSlam slam(params);
    const DriveErrors result = drive(slam);

    EXPECT_GT(result.odometry_off_m, 0.4);
    EXPECT_LT(result.off_m, 0.1);
    EXPECT_EQ(slam.trajectory().size(), static_cast<std::size_t>(kSteps) + 1);
  }
}

TEST(LandmarkSlam, KnowsItsWholeWayHoweverFewPosesItKeeps) {
  for (const std::size_t max_poses : {2U, 5U, 100U}) {
    LandmarkSlamParams params;
    params.pose_history.max_poses = max_poses;
    LandmarkSlam slam(params);
    drive(slam);
    const auto trajectory = slam.trajectory();

    EXPECT_LE(slam.filter().stored_poses(), max_poses);
    for (int step = 0; step <= kSteps; ++step) {
      const Eigen::Vector2d off_m =
          trajectory[static_cast<std::size_t>(step)].position_m() - pose_at(step).position_m();
      ASSERT_LT(off_m.norm(), 0.15) << "step " << step << ", " << max_poses << " kept";
    }
  }
}

TEST(LandmarkSlam, MapsEachWallOnce) {
  LandmarkSlam slam;
  drive(slam);
  const auto& landmarks = slam.filter().landmarks();
  const auto walls =
      std::count_if(landmarks.begin(), landmarks.end(), [](const Landmark& landmark) {
        return landmark.kind == LandmarkKind::kWall;
      });

  EXPECT_GE(walls, 4);
  EXPECT_LE(walls, 9);
}

TEST(LandmarkSlam, ItsGraphHoldsWhatTheFilterKnowsOfEachPose) {
  LandmarkSlam slam;
  drive(slam);
  const EkfSlamFilter& filter = slam.filter();
  const FactorGraph graph = slam.factor_graph();
  ASSERT_EQ(graph.T_map_nodes.size(), filter.stored_poses() + 1);
  ASSERT_EQ(graph.edges.size(), filter.stored_poses());
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const Eigen::Matrix3d covariance =
        i + 1 < graph.edges.size() ? filter.stored_covariance(i + 1) : filter.belief().covariance;
    const PoseEdge& edge = graph.edges[i];
    const EdgeError off = edge_error(edge, graph.T_map_nodes.front(), graph.T_map_nodes[edge.to]);
    EXPECT_LT(off.error.norm(), 1e-9);
    const Eigen::Matrix3d in_map = off.by_to.transpose() * edge.information * off.by_to;
    EXPECT_LT((in_map * covariance - Eigen::Matrix3d::Identity()).norm(), 1e-6) << i;
  }
}

TEST(LandmarkSlam, ItsGraphHoldsWhatTheFilterKnowsOfEachPoint) {
  LandmarkSlam slam;
  drive(slam);
  const FactorGraph graph = slam.factor_graph();
  const Pose2& T_map_first = graph.T_map_nodes.front();
  const Eigen::Matrix2d to_map = Eigen::Rotation2Dd(T_map_first.heading_rad()).toRotationMatrix();
  std::size_t points = 0;
  for (std::size_t i = 0; i < slam.filter().landmarks().size(); ++i) {
    const Landmark& landmark = slam.filter().landmarks()[i];
    if (landmark.kind != LandmarkKind::kPoint) {
      continue;
    }
    const LandmarkEdge& edge = graph.landmark_edges.at(points++);
    EXPECT_EQ(graph.landmarks_m.at(edge.landmark), landmark.value);
    EXPECT_LT((T_map_first * edge.place_m - landmark.value).norm(), 1e-9);
    const Eigen::Matrix2d in_map = to_map * edge.information * to_map.transpose();
    const Eigen::Matrix2d one = in_map * slam.filter().landmark_covariance(i);
    EXPECT_LT((one - Eigen::Matrix2d::Identity()).norm(), 1e-6) << i;
  }
  EXPECT_GT(points, 2U);
  EXPECT_EQ(graph.landmark_edges.size(), points);
}

TEST(LandmarkSlam, TakesOutWhatBeamsPassThrough) {
  LandmarkSlam slam;
  std::vector<Segment> with_screen = room;
  with_screen.push_back({{2.0, 1.4}, {3.5, 1.4}});
  const Pose2 T_map_robot(2.5, 0.0, 0.0);
  for (int i = 0; i < 6; ++i) {
    slam.add(T_map_robot, scan_from(T_map_robot, with_screen));
  }
  const std::size_t before = slam.filter().landmarks().size();
  for (int i = 0; i < 12; ++i) {
    slam.add(T_map_robot, scan_from(T_map_robot, room));
  }
  const auto& landmarks = slam.filter().landmarks();

  EXPECT_GT(before, 0U);
  EXPECT_TRUE(std::none_of(landmarks.begin(), landmarks.end(), [](const Landmark& landmark) {
    return landmark.kind == LandmarkKind::kWall && std::abs(landmark.value.x() - 1.4) < 0.1 &&
           std::abs(landmark.value.y() - std::numbers::pi / 2.0) < 0.1;
  }));
}

TEST(LandmarkSlam, GoesOnByOdometryWhereThereIsNothingToSee) {
  LandmarkSlam slam;
  slam.add({1.0, 2.0, 0.5}, sensors::RangeScan{});
  slam.add({1.5, 2.0, 0.4}, sensors::RangeScan{});

  EXPECT_NEAR(slam.belief().T_map_robot.x_m(), 1.5, 1e-12);
  EXPECT_NEAR(slam.belief().T_map_robot.heading_rad(), 0.4, 1e-12);
  EXPECT_GT(slam.belief().covariance(0, 0), 0.0);
}

}  // namespace
}  // namespace echomap::slam
