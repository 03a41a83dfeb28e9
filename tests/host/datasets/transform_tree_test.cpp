// SPDX-License-Identifier: MIT
#include "host/datasets/transform_tree.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;

/// A pose in the plane.
SpatialPose flat(double x_m, double y_m, double yaw_deg) {
  return {{x_m, y_m, 0.0},
          Eigen::Quaterniond(Eigen::AngleAxisd(radians(yaw_deg), Eigen::Vector3d::UnitZ()))};
}

double yaw_deg(const SpatialPose& pose) {
  const Eigen::Vector3d forward = pose.rotation * Eigen::Vector3d::UnitX();
  return geometry::degrees(std::atan2(forward.y(), forward.x()));
}

TEST(TransformTree, ComposesTheChainFromTheTargetDown) {
  TransformTree tree;
  tree.add_static("base", "mast", flat(0.1, 0.0, 90.0));
  tree.add_static("mast", "sonar", flat(0.2, 0.0, 30.0));
  const auto T_base_sonar = tree.find("base", "sonar", 5.0);
  ASSERT_TRUE(T_base_sonar);
  EXPECT_TRUE(T_base_sonar->position_m.isApprox(Eigen::Vector3d(0.1, 0.2, 0.0)));
  EXPECT_NEAR(yaw_deg(*T_base_sonar), 120.0, 1e-9);
}

TEST(TransformTree, PlacesAFrameInItself) {
  EXPECT_TRUE(TransformTree().find("base", "base", 0.0));
}

TEST(TransformTree, FindsNothingThatIsNotBelowTheTarget) {
  TransformTree tree;
  tree.add_static("base", "sonar", flat(0.1, 0.0, 0.0));
  EXPECT_FALSE(tree.find("base", "laser", 0.0));
  EXPECT_FALSE(tree.find("sonar", "base", 0.0));
  EXPECT_TRUE(tree.has("sonar"));
  EXPECT_FALSE(tree.has("base"));
}

TEST(TransformTree, EndsInACircle) {
  TransformTree tree;
  tree.add_static("a", "b", flat(0.1, 0.0, 0.0));
  tree.add_static("b", "a", flat(0.1, 0.0, 0.0));
  EXPECT_FALSE(tree.find("base", "a", 0.0));
}

TEST(TransformTree, InterpolatesAMovingFrame) {
  TransformTree tree;
  tree.add("base", "pan", 2.0, flat(0.0, 0.2, 60.0));
  tree.add("base", "pan", 1.0, flat(0.0, 0.0, -20.0));
  const auto between = tree.find("base", "pan", 1.25);
  ASSERT_TRUE(between);
  EXPECT_NEAR(yaw_deg(*between), 0.0, 1e-9);
  EXPECT_NEAR(between->position_m.y(), 0.05, 1e-12);
}

TEST(TransformTree, HoldsTheLastPoseAndForAShortTimeTheFirst) {
  TransformTree tree;
  tree.add("base", "pan", 1.0, flat(0.0, 0.0, -20.0));
  tree.add("base", "pan", 2.0, flat(0.0, 0.0, 60.0));
  EXPECT_NEAR(yaw_deg(*tree.find("base", "pan", 0.6)), -20.0, 1e-9);
  EXPECT_FALSE(tree.find("base", "pan", 0.4));
  EXPECT_NEAR(yaw_deg(*tree.find("base", "pan", 9.0)), 60.0, 1e-9);
}

TEST(TransformTree, ForgetsWhatIsLongPast) {
  TransformTree tree;
  tree.add("base", "pan", 0.0, flat(0.0, 0.0, 10.0));
  tree.add("base", "pan", 1.0, flat(0.0, 0.0, 20.0));
  tree.add("base", "pan", TransformTree::kHistoryS + 0.5, flat(0.0, 0.0, 30.0));
  EXPECT_NEAR(yaw_deg(*tree.find("base", "pan", 0.9)), 20.0, 1e-9);
}

TEST(TransformTree, BeginsAFrameAgainThatChangesItsParent) {
  TransformTree tree;
  tree.add_static("mast", "sonar", flat(1.0, 0.0, 0.0));
  tree.add("base", "sonar", 1.0, flat(2.0, 0.0, 0.0));
  EXPECT_FALSE(tree.find("mast", "sonar", 0.0));
  ASSERT_TRUE(tree.find("base", "sonar", 1.0));
  EXPECT_NEAR(tree.find("base", "sonar", 1.0)->position_m.x(), 2.0, 1e-12);
}

TEST(TransformTree, InterpolatesBetweenTwoPosesOfOneStamp) {
  TransformTree tree;
  tree.add("base", "pan", 1.0, flat(0.0, 0.0, 10.0));
  tree.add("base", "pan", 1.0, flat(0.0, 0.0, 20.0));
  EXPECT_NEAR(yaw_deg(*tree.find("base", "pan", 1.0)), 20.0, 1e-9);
}

}  // namespace
}  // namespace echomap::datasets
