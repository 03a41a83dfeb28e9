// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_alignment.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "host/localization/pose_gaussian.hpp"

namespace echomap::slam {
namespace {

/// Two walls at right angles, x = 2 and y = 1, as a robot at `T_map_begin` sees them.
std::vector<SurfacePatch> corner_seen_from(const geometry::Pose2& T_map_begin) {
  const double heading_rad = T_map_begin.heading_rad();
  const geometry::Pose2 T_begin_map = T_map_begin.inverse();
  std::vector<SurfacePatch> patches;
  for (const double along_m : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
    patches.push_back({T_begin_map * Eigen::Vector2d(2.0, along_m), 0.0 - heading_rad, 0.01, 0.02});
    patches.push_back(
        {T_begin_map * Eigen::Vector2d(1.0 + along_m, 1.0), 1.5708 - heading_rad, 0.01, 0.02});
  }
  return patches;
}

const geometry::Pose2 T_map_second(0.5, 0.0, 0.05);

/// The second multiscan is believed to stand elsewhere than it does.
MultiscanGraph displaced() {
  MultiscanGraph graph;
  const geometry::Pose2 believed(0.55, -0.04, 0.08);
  graph.multiscans = {{{}, corner_seen_from({}), Eigen::Matrix3d::Zero()},
                      {believed, corner_seen_from(T_map_second), Eigen::Matrix3d::Zero()}};
  graph.pieces = {{believed, 0.55, 0.08, 0.08, 0.0, 0.0}};
  return graph;
}

double error_of(const geometry::Pose2& pose) {
  const geometry::Pose2 off = T_map_second.inverse() * pose;
  return off.position_m().norm() + std::abs(off.heading_rad());
}

AlignmentStep align(MultiscanGraph& graph, int steps) {
  AlignmentStep step;
  for (int i = 0; i < steps; ++i) {
    step = align_multiscans(graph, match_patches(graph.multiscans, 1, {}), 1, 1, {});
  }
  return step;
}

TEST(MultiscanAlignment, MovesAMultiscanToWhereItsSurfacesAgree) {
  MultiscanGraph graph = displaced();
  graph.odometry_scale = 20.0;
  const double before = error_of(graph.multiscans[1].T_map_begin);
  align(graph, 6);
  EXPECT_LT(error_of(graph.multiscans[1].T_map_begin), 0.6 * before);
}

TEST(MultiscanAlignment, KeepsToOdometryWithoutMatches) {
  MultiscanGraph graph = displaced();
  align_multiscans(graph, {}, 1, 1, {});
  EXPECT_LT((graph.multiscans[1].T_map_begin.position_m() - Eigen::Vector2d(0.55, -0.04)).norm(),
            1e-9);
  EXPECT_LT(graph.calibration.values.norm(), 1e-9);
}

TEST(MultiscanAlignment, AnswersTheCovarianceOfTheLast) {
  MultiscanGraph with = displaced();
  MultiscanGraph without = displaced();
  const Eigen::Matrix3d seen = align(with, 2).last_covariance;
  const Eigen::Matrix3d unseen = align_multiscans(without, {}, 1, 1, {}).last_covariance;
  EXPECT_TRUE(localization::is_covariance(seen));
  EXPECT_LT(seen.trace(), unseen.trace());
}

constexpr double kDriftRadPerM = 0.05;

/// A way along the corner by an odometry that drifts.
MultiscanGraph drifted() {
  constexpr double kStepM = 0.25;
  MultiscanGraph graph;
  geometry::Pose2 believed;
  for (int i = 0; i <= 6; ++i) {
    const geometry::Pose2 truth(0.2 * i, 0.0, 0.0);
    graph.multiscans.push_back({believed, corner_seen_from(truth), Eigen::Matrix3d::Zero()});
    const geometry::Pose2 step(0.2, 0.0, -kDriftRadPerM * kStepM);
    graph.pieces.push_back({step, kStepM, -kDriftRadPerM * kStepM, 0.01, 0.0, 0.0});
    believed = believed * step;
  }
  graph.pieces.pop_back();
  return graph;
}

TEST(MultiscanAlignment, FindsTheSteadyErrorOfOdometry) {
  MultiscanGraph graph = drifted();
  align(graph, 10);
  EXPECT_GT(graph.calibration.drift_rad_per_m(), 0.3 * kDriftRadPerM);
  EXPECT_LT(graph.calibration.drift_rad_per_m(), 1.5 * kDriftRadPerM);
}

TEST(MultiscanAlignment, FindsLittleSteadyErrorWhereLittleIsBelieved) {
  MultiscanGraph graph = drifted();
  graph.steady_scale = 0.05;
  align(graph, 10);
  EXPECT_LT(graph.calibration.drift_rad_per_m(), 0.1 * kDriftRadPerM);
}

TEST(MultiscanAlignment, IsSurprisedByWallsThatDoNotAgree) {
  MultiscanGraph wrong = displaced();
  MultiscanGraph right = displaced();
  align(right, 6);
  const double before = align(wrong, 1).negative_log_evidence;
  EXPECT_LT(align(right, 1).negative_log_evidence, before);
}

TEST(MultiscanAlignment, IsSurprisedByPatchesWithoutMatch) {
  MultiscanGraph matched = displaced();
  align(matched, 6);
  MultiscanGraph alone = matched;
  EXPECT_LT(align(matched, 1).negative_log_evidence,
            align_multiscans(alone, {}, 1, 1, {}).negative_log_evidence);
}

TEST(MultiscanAlignment, RefusesParametersWithoutSense) {
  MultiscanAlignmentParams params;
  params.odometry.position_stddev_m = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::slam
