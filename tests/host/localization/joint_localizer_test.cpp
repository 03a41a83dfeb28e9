// SPDX-License-Identifier: MIT
#include "host/localization/joint_localizer.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;
using geometry::radians;

const PoseGaussian unsure{{1.0, 1.0, radians(90.0)},
                          Eigen::Vector3d(0.04, 0.04, 0.0004).asDiagonal()};
const PoseGaussian sure{{1.0, 3.0, 0.0}, Eigen::Vector3d(1e-4, 1e-4, 1e-4).asDiagonal()};

/// Looks at `unsure`, which looks at it.
const PoseGaussian opposite{{1.0, 3.0, radians(-90.0)}, unsure.covariance};

/// Sees it 2 m ahead.
const PeerSighting peer_ahead{1.0, 2.0, 0.0, 0.05, 0.02};

/// A localizer without slow errors, whose filter is that of the book.
JointLocalizerParams white() {
  JointLocalizerParams params;
  params.drive_scale_stddev = 0.0;
  params.turn_scale_stddev = 0.0;
  params.range_scale.stddev = 0.0;
  params.target_range_scale.stddev = 0.0;
  params.bearing_rad.stddev = 0.0;
  return params;
}

LandmarkObservation landmark_ahead(double stamp_s, double range_m) {
  return {stamp_s, {1.0, 3.0}, {}, range_m, 0.0, 0.05, 0.02};
}

double smallest_eigenvalue(const JointLocalizer& localizer) {
  Eigen::Matrix<double, 6, 6> both;
  both << localizer.belief(0).covariance, localizer.covariance_between(0, 1),
      localizer.covariance_between(1, 0), localizer.belief(1).covariance;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(both).eigenvalues().minCoeff();
}

TEST(JointLocalizer, IsTheFilterOfOneRobotWhereThereAreLandmarksAlone) {
  JointLocalizer localizer(white());
  localizer.add_robot(0.0, unsure);
  const auto seen = landmark_ahead(1.0, 2.1);
  EXPECT_EQ(localizer.see_landmark(0, 7, seen), EkfOutcome::kApplied);
  const PoseGaussian expected = corrected(unsure, *linearized(seen, unsure.T_map_robot));
  EXPECT_TRUE(localizer.belief(0).covariance.isApprox(expected.covariance, 1e-9));
  EXPECT_NEAR(localizer.belief(0).T_map_robot.y_m(), expected.T_map_robot.y_m(), 1e-12);
}

TEST(JointLocalizer, MovesAsOneRobotDoes) {
  JointLocalizer localizer(white());
  localizer.add_robot(0.0, unsure);
  const Pose2 T_before_after(0.3, 0.02, 0.2);
  EXPECT_EQ(localizer.move(0, 1.0, T_before_after), EkfOutcome::kApplied);
  const models::OdometryStep step = models::odometry_step({}, T_before_after);
  const PoseGaussian expected =
      moved(unsure,
            T_before_after,
            step,
            models::cut_step_spread(models::OdometryMotion(white().motion), step, {}));
  EXPECT_TRUE(localizer.belief(0).covariance.isApprox(expected.covariance, 1e-9));
  EXPECT_NEAR(localizer.belief(0).T_map_robot.x_m(), expected.T_map_robot.x_m(), 1e-12);
}

TEST(JointLocalizer, ASightingMakesTheUnsureRobotAsSureAsTheOther) {
  JointLocalizer localizer(white());
  localizer.add_robot(0.0, unsure);
  localizer.add_robot(0.0, sure);
  EXPECT_EQ(localizer.see_peer(0, 1, peer_ahead), EkfOutcome::kApplied);
  EXPECT_LT(position_stddev_m(localizer.belief(0)), 0.07);
  EXPECT_GT(localizer.covariance_between(0, 1)(1, 1), 0.0);
}

TEST(JointLocalizer, ASightingCorrectsTheRobotThatIsSeenToo) {
  JointLocalizer localizer(white());
  localizer.add_robot(0.0, {{1.0, 1.0, radians(90.0)}, 1e-4 * Eigen::Matrix3d::Identity()});
  localizer.add_robot(0.0, {{1.2, 3.1, 0.0}, 0.04 * Eigen::Matrix3d::Identity()});
  EXPECT_EQ(localizer.see_peer(0, 1, peer_ahead), EkfOutcome::kApplied);
  EXPECT_NEAR(localizer.belief(1).T_map_robot.x_m(), 1.0, 0.03);
  EXPECT_NEAR(localizer.belief(1).T_map_robot.y_m(), 3.0, 0.03);
  EXPECT_NEAR(localizer.belief(1).covariance(2, 2), 0.04, 1e-6) << "its heading is not seen";
}

TEST(JointLocalizer, TellingEachOtherTheSameAgainMakesNobodySurerThanTheyAre) {
  JointLocalizer localizer(white());
  localizer.add_robot(0.0, unsure);
  localizer.add_robot(0.0, opposite);
  for (std::size_t i = 1; i <= 200; ++i) {
    PeerSighting seen = peer_ahead;
    seen.stamp_s = static_cast<double>(i);
    EXPECT_EQ(localizer.see_peer(i % 2, 1 - i % 2, seen), EkfOutcome::kApplied);
  }
  const auto& first = localizer.belief(0).covariance;
  const auto& second = localizer.belief(1).covariance;
  const double between = localizer.covariance_between(0, 1)(1, 1);
  // How far they are from each other is known, and where both together are as badly as before.
  EXPECT_LT(first(1, 1) + second(1, 1) - 2.0 * between, 1e-4);
  EXPECT_NEAR(0.25 * (first(1, 1) + second(1, 1) + 2.0 * between), 0.02, 1e-4);
  EXPECT_NEAR(first(1, 1), 0.02, 1e-3);
  EXPECT_GT(smallest_eigenvalue(localizer), 0.0);
}

TEST(JointLocalizer, AMotionKeepsTheCorrelationWithOthers) {
  JointLocalizer localizer(white());
  localizer.add_robot(0.0, unsure);
  localizer.add_robot(0.0, opposite);
  EXPECT_EQ(localizer.see_peer(0, 1, peer_ahead), EkfOutcome::kApplied);
  const double before = localizer.covariance_between(0, 1)(1, 1);
  localizer.move(0, 2.0, {0.1, 0.0, 0.0});
  EXPECT_GT(before, 0.01);
  EXPECT_NEAR(localizer.covariance_between(0, 1)(1, 1), before, 0.05 * before);
  EXPECT_TRUE(
      localizer.covariance_between(0, 1).isApprox(localizer.covariance_between(1, 0).transpose()));
}

TEST(JointLocalizer, AFalseSightingIsGatedAndChangesNothing) {
  JointLocalizer localizer;
  localizer.add_robot(0.0, sure);
  localizer.add_robot(0.0, {{3.0, 3.0, 0.0}, sure.covariance});
  PeerSighting seen = peer_ahead;
  seen.bearing_rad = 1.0;
  EXPECT_EQ(localizer.see_peer(0, 1, seen), EkfOutcome::kGated);
  EXPECT_EQ(localizer.belief(0).T_map_robot.y_m(), sure.T_map_robot.y_m());
  EXPECT_TRUE(localizer.belief(0).covariance.isApprox(sure.covariance));
  EXPECT_EQ(localizer.belief(1).T_map_robot.x_m(), 3.0);
  EXPECT_EQ(localizer.count(EkfOutcome::kGated), 1U);
}

TEST(JointLocalizer, AnErrorThatPicturesShareIsNotAveragedAway) {
  JointLocalizer shared;
  JointLocalizer alone(white());
  for (JointLocalizer* localizer : {&shared, &alone}) {
    localizer->add_robot(0.0, unsure);
    for (int i = 1; i <= 50; ++i) {
      localizer->see_landmark(0, 7, landmark_ahead(0.1 * i, 2.0));
    }
  }
  EXPECT_LT(std::sqrt(alone.belief(0).covariance(1, 1)), 0.01);
  EXPECT_GT(std::sqrt(shared.belief(0).covariance(1, 1)), 0.05);
}

TEST(JointLocalizer, LearnsHowLongOdometryReads) {
  JointLocalizerParams params;
  params.motion.alpha3 = 1e-4;
  params.drive_scale_stddev = 0.1;
  JointLocalizer localizer(params);
  localizer.add_robot(0.0, {{0.0, 0.0, 0.0}, 1e-4 * Eigen::Matrix3d::Identity()});
  // It drives 10 m and reads 5 % too little; a metre ahead of each place is a landmark.
  for (int i = 1; i <= 100; ++i) {
    localizer.move(0, i, {0.1 / 1.05, 0.0, 0.0});
    localizer.see_landmark(0, i, {1.0 * i, {0.1 * i + 1.0, 0.0}, {}, 1.0, 0.0, 0.01, 0.01});
  }
  EXPECT_NEAR(localizer.odometry_scales(0).x(), 1.05, 0.01);
  EXPECT_NEAR(localizer.odometry_scales(0).y(), 1.0, 0.02);
}

TEST(JointLocalizer, ARobotThatIsLostIsFoundAgain) {
  JointLocalizer localizer;
  localizer.add_robot(0.0, {{1.0, 1.5, radians(90.0)}, 1e-6 * Eigen::Matrix3d::Identity()});
  int i = 0;
  for (; localizer.times_lost(0) == 0 && i < 20; ++i) {
    localizer.see_landmark(0, 7, landmark_ahead(i, 2.0));
  }
  EXPECT_EQ(i, 10);
  EXPECT_EQ(localizer.see_landmark(0, 7, landmark_ahead(i, 2.0)), EkfOutcome::kApplied);
  EXPECT_NEAR(localizer.belief(0).T_map_robot.y_m(), 1.0, 0.15);
}

TEST(JointLocalizer, StateStaysSmallHoweverManyTargetsAreSeen) {
  JointLocalizer localizer;
  localizer.add_robot(0.0, unsure);
  for (int i = 1; i <= 1000; ++i) {
    EXPECT_EQ(localizer.see_landmark(0, i, landmark_ahead(100.0 * i, 2.0)), EkfOutcome::kApplied);
  }
  EXPECT_TRUE(is_covariance(localizer.belief(0).covariance));
}

TEST(JointLocalizer, RefusesWhatCannotBeAndSaysWhy) {
  JointLocalizer localizer;
  localizer.add_robot(5.0, unsure);
  localizer.add_robot(5.0, sure);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(localizer.move(0, 5.0, {}), EkfOutcome::kTimeRanBack);
  EXPECT_EQ(localizer.move(0, 6.0, {nan, 0.0, 0.0}), EkfOutcome::kNotFinite);
  EXPECT_EQ(localizer.move(0, 6.0, {0.1, 0.0, 0.0}), EkfOutcome::kApplied);
  EXPECT_EQ(localizer.see_peer(0, 1, peer_ahead), EkfOutcome::kTooOld);
  EXPECT_EQ(localizer.see_peer(0, 1, {7.0, 0.0, 0.0, 0.1, 0.1}), EkfOutcome::kBadRange);
  EXPECT_EQ(localizer.see_peer(0, 1, {7.0, 1.0, 0.0, 0.0, 0.1}), EkfOutcome::kBadCovariance);
  EXPECT_EQ(localizer.see_peer(0, 1, {7.0, nan, 0.0, 0.1, 0.1}), EkfOutcome::kNotFinite);
  LandmarkObservation below = landmark_ahead(7.0, 1.0);
  below.landmark_m = localizer.belief(0).T_map_robot.position_m();
  EXPECT_EQ(localizer.see_landmark(0, 7, below), EkfOutcome::kAtLandmark);
  EXPECT_EQ(localizer.count(EkfOutcome::kApplied), 1U);
}

TEST(JointLocalizer, RefusesParametersAndStartsOutOfRange) {
  JointLocalizerParams params;
  params.bearing_rad.time_constant_s = 0.0;
  EXPECT_THROW(JointLocalizer{params}, std::invalid_argument);
  JointLocalizer localizer;
  EXPECT_THROW(localizer.add_robot(0.0, {}), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::localization
