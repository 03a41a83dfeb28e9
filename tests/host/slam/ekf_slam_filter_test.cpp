// SPDX-License-Identifier: MIT
#include "host/slam/ekf_slam_filter.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::slam {
namespace {

using geometry::Pose2;
using localization::PoseGaussian;

constexpr double kRangeStddevM = 0.1;
constexpr double kBearingStddevRad = 0.02;

LandmarkSighting sighting(LandmarkKind kind, double length, double angle) {
  LandmarkSighting seen;
  seen.kind = kind;
  seen.value = {length, angle};
  seen.noise = Eigen::Vector2d(kRangeStddevM * kRangeStddevM, kBearingStddevRad * kBearingStddevRad)
                   .asDiagonal();
  return seen;
}

PoseGaussian unsure_start() {
  const Eigen::Vector3d variance(0.04, 0.09, 0.01);
  return {{1.0, 2.0, 0.5}, variance.asDiagonal()};
}

EkfSlamFilter unsure_filter(bool is_invariant) {
  const std::vector<PoseGaussian> starts{unsure_start()};
  EkfSlamFilter filter(starts, {.is_invariant = is_invariant});
  filter.add(sighting(LandmarkKind::kPoint, 3.0, 0.4));
  filter.add(sighting(LandmarkKind::kWall, 2.0, -0.8));
  filter.add(sighting(LandmarkKind::kPoint, 5.0, -1.4));
  return filter;
}

/// Table 10.1 with full matrices.
Eigen::MatrixXd book_covariance(const EkfSlamFilter& filter, const LinearSighting& linear) {
  const Eigen::MatrixXd before = filter.covariance();
  Eigen::MatrixXd by_state = Eigen::MatrixXd::Zero(2, before.rows());
  by_state.middleCols<3>(linear.pose_at) = linear.jacobian_pose;
  by_state.middleCols<2>(linear.target_at) = linear.jacobian_target;
  const Eigen::Matrix2d innovation = by_state * before * by_state.transpose() + linear.noise;
  const Eigen::MatrixXd gain = before * by_state.transpose() * innovation.inverse();
  return before - gain * by_state * before;
}

TEST(EkfSlamFilter, RefusesAStartThatIsNone) {
  const PoseGaussian bad{{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, {}};
  EXPECT_THROW(EkfSlamFilter(std::vector<PoseGaussian>{}), std::invalid_argument);
  EXPECT_THROW(EkfSlamFilter(std::vector<PoseGaussian>{bad}), std::invalid_argument);
}

TEST(EkfSlamFilter, IsAsUnsureOfANewLandmarkAsOfItsPoseAndTheSighting) {
  const EkfSlamFilter filter = unsure_filter(true);
  const PlacedLandmark placed =
      placed_landmark(sighting(LandmarkKind::kPoint, 3.0, 0.4), unsure_start().T_map_robot);

  const Eigen::Matrix2d expected =
      placed.jacobian_pose * unsure_start().covariance * placed.jacobian_pose.transpose() +
      placed.by_value * sighting(LandmarkKind::kPoint, 1.0, 0.0).noise *
          placed.by_value.transpose();
  EXPECT_TRUE(filter.landmark_covariance(0).isApprox(expected));
  EXPECT_TRUE(filter.covariance()
                  .block(3, 0, 2, 3)
                  .isApprox(placed.jacobian_pose * unsure_start().covariance));
}

TEST(EkfSlamFilter, UpdatesTheCovarianceAsTheBookDoes) {
  EkfSlamFilter filter = unsure_filter(false);
  const auto linear = filter.linearized(sighting(LandmarkKind::kWall, 2.1, -0.75), 1);
  const Eigen::MatrixXd expected = book_covariance(filter, *linear);
  filter.update({&*linear, 1});

  EXPECT_TRUE(filter.covariance().isApprox(expected, 1e-9));
}

TEST(EkfSlamFilter, TakesTwoSightingsAtOnceAsOneAfterTheOther) {
  EkfSlamFilter together = unsure_filter(false);
  EkfSlamFilter in_turn = together;
  const LandmarkSighting first = sighting(LandmarkKind::kPoint, 3.0, 0.4);
  const LandmarkSighting second = sighting(LandmarkKind::kWall, 2.0, -0.8);
  const std::vector<LinearSighting> both{*together.linearized(first, 0),
                                         *together.linearized(second, 1)};
  together.update(both);
  for (const auto& linear : both) {
    in_turn.update({&linear, 1});
  }

  EXPECT_TRUE(together.covariance().isApprox(in_turn.covariance(), 1e-9));
}

TEST(EkfSlamFilter, MovesAsTheMotionModelOfPosesSays) {
  EkfSlamFilter filter = unsure_filter(true);
  const Eigen::MatrixXd before = filter.covariance();
  const Pose2 T_before_after(0.5, 0.1, 0.3);
  const auto step = models::odometry_step({}, T_before_after);
  const models::MotionSpread spread{0.01, 0.02, 0.03, 0.004};
  filter.move(0, T_before_after, step, spread);

  const PoseGaussian moved = localization::moved(unsure_start(), T_before_after, step, spread);
  EXPECT_TRUE(filter.belief().covariance.isApprox(moved.covariance));
  EXPECT_TRUE(filter.covariance().bottomRightCorner(6, 6).isApprox(before.bottomRightCorner(6, 6)));
  const auto jacobian_pose =
      localization::motion_jacobians(unsure_start().T_map_robot, T_before_after, step)
          .jacobian_pose;
  EXPECT_TRUE(filter.covariance().topRightCorner(3, 6).isApprox(jacobian_pose *
                                                                before.topRightCorner(3, 6)));
}

TEST(EkfSlamFilter, SaysHowSightingsVaryTogether) {
  const EkfSlamFilter filter = unsure_filter(true);
  const auto first = filter.linearized(sighting(LandmarkKind::kPoint, 3.1, 0.4), 0);
  const auto second = filter.linearized(sighting(LandmarkKind::kWall, 2.0, -0.7), 1);
  const Eigen::MatrixXd covariance = filter.covariance();
  const auto by_state = [&](const LinearSighting& linear) {
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(2, covariance.rows());
    jacobian.middleCols<3>(linear.pose_at) = linear.jacobian_pose;
    jacobian.middleCols<2>(linear.target_at) = linear.jacobian_target;
    return jacobian;
  };

  EXPECT_TRUE(filter.covariance_between(*first, *second)
                  .isApprox(by_state(*first) * covariance * by_state(*second).transpose()));
}

TEST(EkfSlamFilter, IsNotChangedByALandmarkThatCameAndWent) {
  EkfSlamFilter filter = unsure_filter(true);
  const Eigen::MatrixXd before = filter.covariance();
  filter.add(sighting(LandmarkKind::kPoint, 7.0, 1.0));
  filter.remove(3);

  EXPECT_EQ(filter.covariance(), before);
  EXPECT_EQ(filter.landmarks().size(), 3U);
}

TEST(EkfSlamFilter, CorrectsAPoseOfThePastByWhatIsLearntLater) {
  for (const bool is_invariant : {true, false}) {
    EkfSlamFilter filter(EkfSlamFilterParams{.is_invariant = is_invariant});
    filter.add(sighting(LandmarkKind::kPoint, 2.0, 0.0));
    const auto drive = [&](double travelled_m) {
      filter.move(0,
                  {travelled_m, 0.0, 0.0},
                  models::odometry_step({}, {travelled_m, 0.0, 0.0}),
                  {0.0, 0.3, 0.0, 0.3});
    };
    drive(1.0);
    filter.store_pose();
    drive(-1.0);
    const double before = filter.covariance().block(5, 5, 2, 2).trace();
    // Back where it began, it sees to have driven 0.2 m less.
    const auto seen = filter.linearized(sighting(LandmarkKind::kPoint, 2.2, 0.0), 0);
    filter.update({&*seen, 1});

    EXPECT_NEAR(filter.T_map_stored(0).x_m(), 0.91, 0.03);
    EXPECT_LT(filter.covariance().block(5, 5, 2, 2).trace(), before);
  }
}

TEST(EkfSlamFilter, IsTheSameWithoutTheKeptPosesAndLandmarksThatWent) {
  EkfSlamFilter filter = unsure_filter(true);
  const Eigen::MatrixXd before = filter.covariance();
  filter.store_pose();
  filter.add(sighting(LandmarkKind::kPoint, 7.0, 1.0));
  filter.store_pose();
  filter.forget_pose(0);
  const auto seen = filter.linearized(sighting(LandmarkKind::kPoint, 7.0, 1.0), 3);
  EXPECT_LT(seen->innovation.norm(), 1e-12);
  EXPECT_NEAR(filter.covariance_between(*seen, *seen)(0, 0),
              sighting(LandmarkKind::kPoint, 7.0, 1.0).noise(0, 0),
              1e-9)
      << "it is known but for the noise it was seen with";
  filter.remove(3);
  filter.forget_pose(0);

  EXPECT_EQ(filter.covariance(), before);
}

/// Headings that go to and fro have a lever of as far as the origin is.
TEST(EkfSlamFilter, LeavesWallsFarFromTheOriginWhereTheyAre) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const PoseGaussian start{{60.0, 40.0, 0.0}, 1e-6 * Eigen::Matrix3d::Identity()};
  EkfSlamFilter filter({&start, 1});
  const auto wall_at = [&](double offset_m, double normal_rad) {
    return sighting(
        LandmarkKind::kWall, offset_m + 0.02 * normal(random), normal_rad + 0.005 * normal(random));
  };
  filter.add(wall_at(3.0, 0.0));
  filter.add(wall_at(4.0, std::numbers::pi / 2.0));
  for (int i = 0; i < 2000; ++i) {
    filter.move(0, {}, {}, {0.02, 0.0, 0.0, 0.0});
    const std::vector<LinearSighting> seen{
        *filter.linearized(wall_at(3.0, 0.0), 0),
        *filter.linearized(wall_at(4.0, std::numbers::pi / 2.0), 1)};
    filter.update(seen);
  }
  const Eigen::Vector2d position_m = filter.belief().T_map_robot.position_m();

  EXPECT_LT((position_m - Eigen::Vector2d(60.0, 40.0)).norm(), 0.1);
  EXPECT_NEAR(filter.landmarks()[0].value.x(), 63.0, 1.0);
  EXPECT_NEAR(
      filter.linearized(sighting(LandmarkKind::kWall, 3.0, 0.0), 0)->innovation.x(), 0.0, 0.1);
}

TEST(EkfSlamFilter, LengthensAWallByWhatIsSeenOfIt) {
  EkfSlamFilter filter;
  LandmarkSighting wall = sighting(LandmarkKind::kWall, 2.0, std::numbers::pi / 2.0);
  wall.along_from_m = -1.0;
  wall.along_to_m = 0.5;
  filter.add(wall);
  filter.move(0, {3.0, 0.0, 0.0}, models::odometry_step({}, {3.0, 0.0, 0.0}), {});
  filter.note(wall, 0);

  // A quarter turn from the wall's normal is -x.
  EXPECT_NEAR(filter.landmarks()[0].along_from_m, -4.0, 1e-12);
  EXPECT_NEAR(filter.landmarks()[0].along_to_m, 0.5, 1e-12);
  EXPECT_EQ(filter.landmarks()[0].sightings, 2U);
}

/// A landmark that is seen again and again by a robot that stands: nothing can be learnt of the
/// heading, which a landmark's own place is unsure with.
double heading_stddev_after_standing(bool is_invariant) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const std::vector<PoseGaussian> starts{unsure_start()};
  EkfSlamFilter filter(starts, {.is_invariant = is_invariant});
  filter.add(sighting(LandmarkKind::kPoint, 10.0, 0.4));
  filter.add(sighting(LandmarkKind::kWall, 8.0, -0.4));
  const auto noisy = [&](LandmarkKind kind, double length, double angle) {
    return sighting(
        kind, length + kRangeStddevM * normal(random), angle + kBearingStddevRad * normal(random));
  };
  for (int i = 0; i < 300; ++i) {
    const std::vector<LinearSighting> seen{
        *filter.linearized(noisy(LandmarkKind::kPoint, 10.0, 0.4), 0),
        *filter.linearized(noisy(LandmarkKind::kWall, 8.0, -0.4), 1)};
    filter.update(seen);
  }
  return std::sqrt(filter.belief().covariance(2, 2));
}

TEST(EkfSlamFilter, LearnsNothingOfItsHeadingFromLandmarksThatWereNotKnown) {
  const double before = std::sqrt(unsure_start().covariance(2, 2));

  EXPECT_NEAR(heading_stddev_after_standing(true), before, 1e-6);
  EXPECT_LT(heading_stddev_after_standing(false), 0.99 * before) << "the book's filter believes so";
}

/// A robot drives a circle twice among landmarks; answers its mean NEES over many worlds.
double mean_nees(bool is_invariant) {
  double sum = 0.0;
  int count = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    EkfSlamFilter filter(EkfSlamFilterParams{.is_invariant = is_invariant});
    const Pose2 T_before_after(0.5, 0.0, 0.05);
    const models::MotionSpread spread{0.02, 0.05, 0.02, 0.01};
    const auto step = models::odometry_step({}, T_before_after);
    Pose2 truth;
    std::vector<Eigen::Vector2d> landmarks_m;
    std::uniform_real_distribution<double> place_m(-14.0, 14.0);
    for (int i = 0; i < 12; ++i) {
      landmarks_m.emplace_back(place_m(random), 10.0 + place_m(random));
    }
    std::vector<int> indices(landmarks_m.size(), -1);
    for (int i = 0; i < 250; ++i) {
      filter.move(0, T_before_after, step, spread);
      const double drive_m = step.drive_m + spread.drive_m * normal(random);
      const double side_m = spread.side_m * normal(random);
      truth = truth * Pose2(0, 0, step.turn_before_rad + spread.turn_before_rad * normal(random)) *
              Pose2(drive_m, side_m, 0) *
              Pose2(0, 0, step.turn_after_rad + spread.turn_after_rad * normal(random));
      for (std::size_t k = 0; k < landmarks_m.size(); ++k) {
        const auto view = expected_sighting(LandmarkKind::kPoint, landmarks_m[k], truth, {})->value;
        if (view.x() > 6.0 || view.x() < 0.5) {
          continue;
        }
        const auto seen = sighting(LandmarkKind::kPoint,
                                   view.x() + kRangeStddevM * normal(random),
                                   view.y() + kBearingStddevRad * normal(random));
        if (indices[k] < 0) {
          indices[k] = static_cast<int>(filter.add(seen));
        } else if (const auto linear =
                       filter.linearized(seen, static_cast<std::size_t>(indices[k]))) {
          filter.update({&*linear, 1});
        }
      }
      const PoseGaussian belief = filter.belief();
      const Eigen::Vector2d off_m = belief.T_map_robot.position_m() - truth.position_m();
      const Eigen::Vector3d off(
          off_m.x(),
          off_m.y(),
          geometry::angle_between(truth.heading_rad(), belief.T_map_robot.heading_rad()));
      sum += off.dot(belief.covariance.llt().solve(off));
      ++count;
    }
  }
  return sum / count;
}

TEST(EkfSlamFilter, IsAsSureAsItMayBe) {
  const double invariant = mean_nees(true);

  EXPECT_NEAR(invariant, 3.0, 1.2);
  EXPECT_GT(mean_nees(false), invariant) << "the book's filter is too sure";
}

TEST(EkfSlamFilter, StaysPositiveDefinite) {
  EkfSlamFilter filter = unsure_filter(true);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 500; ++i) {
    const Pose2 T_before_after(0.05, 0.0, 0.02 * normal(random));
    filter.move(
        0, T_before_after, models::odometry_step({}, T_before_after), {0.01, 0.01, 0.01, 0});
    for (std::size_t k = 0; k < 3; ++k) {
      const Landmark& landmark = filter.landmarks()[k];
      const auto expected =
          expected_sighting(landmark.kind, landmark.value, filter.belief().T_map_robot, {});
      const auto linear = filter.linearized(
          sighting(landmark.kind, expected->value.x() + 0.05 * normal(random), expected->value.y()),
          k);
      filter.update({&*linear, 1});
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(filter.covariance());
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0.0);
}

TEST(EkfSlamFilter, TellsBothRobotsWhatOneSeesOfTheOther) {
  const Eigen::Matrix3d unsure = Eigen::Vector3d(0.25, 0.25, 1e-4).asDiagonal();
  const Eigen::Matrix3d sure = 1e-6 * Eigen::Matrix3d::Identity();
  const std::vector<PoseGaussian> starts{{{0, 0, 0}, sure}, {{3.4, 0.3, 0}, unsure}};
  EkfSlamFilter team(starts);
  const auto linear = team.linearized_peer(sighting(LandmarkKind::kPoint, 3.0, 0.0), 1);
  ASSERT_TRUE(linear);
  team.update({&*linear, 1});

  EXPECT_LT((team.belief(1).T_map_robot.position_m() - Eigen::Vector2d(3.0, 0.0)).norm(), 0.05);
  EXPECT_LT(team.belief(1).covariance(0, 0), 0.02);
}

TEST(EkfSlamFilter, LearnsHowOdometryIsOffAllTheTime) {
  EkfSlamFilter filter;
  filter.add_calibration(1e-2 * Eigen::Matrix3d::Identity());
  LandmarkSighting wall;
  wall.kind = LandmarkKind::kWall;
  wall.value = {10.0, 0.0};
  wall.noise = 1e-6 * Eigen::Matrix2d::Identity();
  filter.add(wall);
  CalibratedMotion motion;
  motion.T_before_after = {1.0, 0.0, 0.0};
  motion.by_calibration(0, 2) = 1.0;  // The third number is a share of the drive.
  motion.variances.setConstant(1e-6);
  const auto foreseen = filter.belief_after(0, motion);
  filter.move(0, motion);
  EXPECT_TRUE(foreseen.covariance.isApprox(filter.belief().covariance));
  EXPECT_NEAR(filter.belief().covariance(0, 0), 1e-2, 1e-4);
  wall.value.x() = 8.95;  // It has driven 1.05 m.
  filter.update(std::vector<LinearSighting>{*filter.linearized(wall, 0)});
  EXPECT_NEAR(filter.calibration()[2], 0.05, 1e-3);
  EXPECT_NEAR(filter.belief().T_map_robot.x_m(), 1.05, 1e-3);
}

}  // namespace
}  // namespace echomap::slam
