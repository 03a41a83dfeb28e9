// SPDX-License-Identifier: MIT
#include "host/slam/landmark_sighting.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

using geometry::Pose2;

constexpr double kStep = 1e-6;
const Pose2 T_map_robot(1.3, -0.7, 0.6);
const Pose2 T_robot_sensor(0.2, -0.1, 0.4);

struct Case {
  LandmarkKind kind;
  Eigen::Vector2d landmark;
};

class Sightings : public testing::TestWithParam<Case> {};

Pose2 nudged(const Pose2& pose, int axis) {
  return {pose.x_m() + (axis == 0 ? kStep : 0.0),
          pose.y_m() + (axis == 1 ? kStep : 0.0),
          pose.heading_rad() + (axis == 2 ? kStep : 0.0)};
}

TEST_P(Sightings, ChangeWithThePoseAsTheirJacobianSays) {
  const auto& [kind, landmark] = GetParam();
  const auto expected = expected_sighting(kind, landmark, T_map_robot, T_robot_sensor);
  ASSERT_TRUE(expected);
  for (int axis = 0; axis < 3; ++axis) {
    const auto after = expected_sighting(kind, landmark, nudged(T_map_robot, axis), T_robot_sensor);
    const Eigen::Vector2d slope = innovation(after->value, expected->value) / kStep;
    EXPECT_LT((slope - expected->jacobian_pose.col(axis)).norm(), 1e-4) << "axis " << axis;
  }
}

TEST_P(Sightings, ChangeWithTheLandmarkAsTheirJacobianSays) {
  const auto& [kind, landmark] = GetParam();
  const auto expected = expected_sighting(kind, landmark, T_map_robot, T_robot_sensor);
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d nudge = kStep * Eigen::Vector2d::Unit(axis);
    const auto after = expected_sighting(kind, landmark + nudge, T_map_robot, T_robot_sensor);
    const Eigen::Vector2d slope = innovation(after->value, expected->value) / kStep;
    EXPECT_LT((slope - expected->jacobian_landmark.col(axis)).norm(), 1e-4) << "axis " << axis;
  }
}

LandmarkSighting sighting_of(const Case& of) {
  LandmarkSighting sighting;
  sighting.kind = of.kind;
  sighting.T_robot_sensor = T_robot_sensor;
  sighting.value = expected_sighting(of.kind, of.landmark, T_map_robot, T_robot_sensor)->value;
  return sighting;
}

TEST_P(Sightings, PlaceTheLandmarkWhereItWasSeen) {
  const PlacedLandmark placed = placed_landmark(sighting_of(GetParam()), T_map_robot);

  EXPECT_LT((placed.landmark - GetParam().landmark).norm(), 1e-12);
}

TEST_P(Sightings, PlaceALandmarkWithTrueJacobians) {
  const LandmarkSighting sighting = sighting_of(GetParam());
  const PlacedLandmark placed = placed_landmark(sighting, T_map_robot);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector2d after = placed_landmark(sighting, nudged(T_map_robot, axis)).landmark;
    EXPECT_LT(((after - placed.landmark) / kStep - placed.jacobian_pose.col(axis)).norm(), 1e-4)
        << "axis " << axis;
  }
  for (int axis = 0; axis < 2; ++axis) {
    LandmarkSighting other = sighting;
    other.value += kStep * Eigen::Vector2d::Unit(axis);
    const Eigen::Vector2d after = placed_landmark(other, T_map_robot).landmark;
    EXPECT_LT(((after - placed.landmark) / kStep - placed.by_value.col(axis)).norm(), 1e-4)
        << "axis " << axis;
  }
}

INSTANTIATE_TEST_SUITE_P(OfPointsAndWalls,
                         Sightings,
                         testing::Values(Case{LandmarkKind::kPoint, {4.0, 2.5}},
                                         Case{LandmarkKind::kPoint, {-3.0, -2.0}},
                                         Case{LandmarkKind::kWall, {5.0, 0.3}},
                                         Case{LandmarkKind::kWall, {2.0, -2.4}}));

TEST(Sighting, OfAPointUnderTheSensorIsNone) {
  EXPECT_FALSE(expected_sighting(LandmarkKind::kPoint, {1.0, 2.0}, {1.0, 2.0, 0.3}, {}));
}

TEST(Sighting, OfAWallFromItsBackHasANegativeOffset) {
  const auto from_front = expected_sighting(LandmarkKind::kWall, {2.0, 0.0}, {}, {});
  const auto from_back = expected_sighting(LandmarkKind::kWall, {2.0, 0.0}, {3.0, 1.0, 0.0}, {});

  EXPECT_DOUBLE_EQ(from_front->value.x(), 2.0);
  EXPECT_DOUBLE_EQ(from_back->value.x(), -1.0);
}

TEST(Innovation, TurnsTheShortWay) {
  EXPECT_NEAR(innovation({2.0, 3.1}, {1.5, -3.1}).y(), 6.2 - 2 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace echomap::slam
