// SPDX-License-Identifier: MIT
// Properties of the joint localizer over simulated drives of a team.
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"
#include "host/localization/joint_localizer.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;
using geometry::square;

constexpr std::size_t kRobots = 3;
constexpr int kSteps = 1200;
constexpr double kStepS = 0.25;
constexpr int kSightingEvery = 2;
constexpr double kRangeStddevM = 0.05;
constexpr double kBearingStddevRad = 0.02;
constexpr double kMaxRangeM = 4.0;

/// Landmarks stand around the first robot's circle; the others pass them now and then.
const std::vector<Eigen::Vector2d> team_landmarks_m{{-1.0, 0.0}, {0.0, 1.5}, {1.0, -1.0}};

/// Errors of the simulation and of the filter are the same.
JointLocalizerParams simulated() {
  JointLocalizerParams params;
  params.motion = {.alpha1 = 0.01, .alpha2_rad2_per_m2 = 0.01, .alpha3 = 0.01, .side_slip = 1e-4};
  params.motion.alpha4_m2_per_rad2 = 0.0;
  params.drive_scale_stddev = 0.03;
  params.turn_scale_stddev = 0.03;
  params.range_scale = {0.02, 10.0};
  params.target_range_scale = {0.03, 10.0};
  params.bearing_rad = {0.01, 10.0};
  return params;
}

struct TeamErrors {
  double rmse_m = 0.0;
  double nees = 0.0;
  std::size_t gated = 0;
};

/// Robots that drive circles in one room and see landmarks and each other within four metres.
class SimulatedTeam {
 public:
  explicit SimulatedTeam(std::uint32_t seed) : generator_(seed) {
    for (std::size_t i = 0; i < kRobots; ++i) {
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / kRobots;
      true_[i] = Pose2(1.5 * std::cos(turn) + 2.0 * static_cast<double>(i), std::sin(turn), turn);
      drive_scale_[i] = 1.0 + normal(params_.drive_scale_stddev);
      turn_scale_[i] = 1.0 + normal(params_.turn_scale_stddev);
      range_scale_[i] = normal(params_.range_scale.stddev);
      bearing_rad_[i] = normal(params_.bearing_rad.stddev);
      for (double& error : target_scale_[i]) {
        error = normal(params_.target_range_scale.stddev);
      }
    }
  }

  /// `false_share` of the sightings of peers are of something else.
  TeamErrors run(bool with_peers, double false_share = 0.0) {
    JointLocalizer localizer(params_);
    for (const Pose2& T_map_robot : true_) {
      localizer.add_robot(0.0, {T_map_robot, 1e-4 * Eigen::Matrix3d::Identity()});
    }
    TeamErrors errors;
    for (int step = 1; step <= kSteps; ++step) {
      const double stamp_s = step * kStepS;
      for (std::size_t i = 0; i < kRobots; ++i) {
        move(i, stamp_s, localizer);
      }
      if (step % kSightingEvery == 0) {
        carry_errors_on();
        for (std::size_t i = 0; i < kRobots; ++i) {
          look(i, stamp_s, with_peers, false_share, localizer);
        }
      }
      count(localizer, errors);
    }
    const double poses = static_cast<double>(kSteps) * kRobots;
    errors.rmse_m = std::sqrt(errors.rmse_m / poses);
    errors.nees /= poses;
    errors.gated = localizer.count(EkfOutcome::kGated);
    return errors;
  }

 private:
  double normal(double stddev) { return stddev * normal_(generator_); }

  /// A chord of a circle of each robot's own; the odometry reads it by its scales and noise.
  void move(std::size_t i, double stamp_s, JointLocalizer& localizer) {
    const Pose2 reported(0.05, 0.0, 0.03 + 0.01 * static_cast<double>(i));
    const Pose2 scaled(
        drive_scale_[i] * reported.x_m(), 0.0, turn_scale_[i] * reported.heading_rad());
    const models::OdometryStep step = models::odometry_step({}, scaled);
    const models::MotionSpread spread =
        models::cut_step_spread(models::OdometryMotion(params_.motion), step, params_.whole_step);
    true_[i] = true_[i] * Pose2(0.0, 0.0, step.turn_before_rad + normal(spread.turn_before_rad)) *
               Pose2(step.drive_m + normal(spread.drive_m), normal(spread.side_m), 0.0) *
               Pose2(0.0, 0.0, step.turn_after_rad + normal(spread.turn_after_rad));
    EXPECT_EQ(localizer.move(i, stamp_s, reported), EkfOutcome::kApplied);
  }

  void carry_on(double& error, const SlowError& slow) {
    const double left = std::exp(-kSightingEvery * kStepS / slow.time_constant_s);
    error = left * error + normal(slow.stddev * std::sqrt(1.0 - square(left)));
  }
  void carry_errors_on() {
    for (std::size_t i = 0; i < kRobots; ++i) {
      carry_on(range_scale_[i], params_.range_scale);
      carry_on(bearing_rad_[i], params_.bearing_rad);
      for (double& error : target_scale_[i]) {
        carry_on(error, params_.target_range_scale);
      }
    }
  }

  /// Range and bearing of a place; empty beyond what is seen.
  std::optional<PeerSighting> sighting(std::size_t i,
                                       std::size_t target,
                                       const Eigen::Vector2d& place_m,
                                       double stamp_s) {
    const Eigen::Vector2d seen_m = true_[i].inverse() * place_m;
    const double range_m = seen_m.norm();
    if (range_m > kMaxRangeM || range_m < 0.3) {
      return std::nullopt;
    }
    return PeerSighting{
        stamp_s,
        range_m * (1.0 + range_scale_[i] + target_scale_[i][target]) + normal(kRangeStddevM),
        std::atan2(seen_m.y(), seen_m.x()) + bearing_rad_[i] + normal(kBearingStddevRad),
        kRangeStddevM,
        kBearingStddevRad};
  }

  /// Only the first robot sees landmarks that are far; the others those within 1.5 m.
  void look(std::size_t i,
            double stamp_s,
            bool with_peers,
            double false_share,
            JointLocalizer& localizer) {
    for (std::size_t k = 0; k < team_landmarks_m.size(); ++k) {
      const auto seen = sighting(i, k, team_landmarks_m[k], stamp_s);
      if (seen && (i == 0 || seen->range_m < 1.5)) {
        localizer.see_landmark(i,
                               static_cast<std::int64_t>(k),
                               {stamp_s,
                                team_landmarks_m[k],
                                {},
                                seen->range_m,
                                seen->bearing_rad,
                                kRangeStddevM,
                                kBearingStddevRad});
      }
    }
    for (std::size_t peer = 0; peer < kRobots; ++peer) {
      auto seen = sighting(i, team_landmarks_m.size() + peer, true_[peer].position_m(), stamp_s);
      if (peer == i || !seen) {
        continue;
      }
      if (std::uniform_real_distribution<>()(generator_) < false_share) {
        seen->range_m = std::uniform_real_distribution<>(0.5, kMaxRangeM)(generator_);
        seen->bearing_rad = std::uniform_real_distribution<>(-3.0, 3.0)(generator_);
      }
      if (with_peers) {
        localizer.see_peer(i, peer, *seen);
      }
    }
  }

  void count(const JointLocalizer& localizer, TeamErrors& errors) const {
    for (std::size_t i = 0; i < kRobots; ++i) {
      const PoseGaussian belief = localizer.belief(i);
      const Eigen::Vector2d off_m = belief.T_map_robot.position_m() - true_[i].position_m();
      const Eigen::Vector3d off(
          off_m.x(),
          off_m.y(),
          geometry::angle_between(true_[i].heading_rad(), belief.T_map_robot.heading_rad()));
      errors.rmse_m += off_m.squaredNorm();
      errors.nees += off.dot(belief.covariance.llt().solve(off));
    }
  }

  JointLocalizerParams params_ = simulated();
  std::mt19937 generator_;
  std::normal_distribution<> normal_;
  std::array<Pose2, kRobots> true_;
  std::array<double, kRobots> drive_scale_{};
  std::array<double, kRobots> turn_scale_{};
  std::array<double, kRobots> range_scale_{};
  std::array<double, kRobots> bearing_rad_{};
  std::array<std::array<double, 6>, kRobots> target_scale_{};
};

constexpr int kSeeds = 30;

TEST(JointTeam, IsBetterThanEachAloneInNearlyAllSeeds) {
  int better = 0;
  double squares_alone = 0.0;
  double squares_joint = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const double alone_m = SimulatedTeam(seed).run(false).rmse_m;
    const double joint_m = SimulatedTeam(seed).run(true).rmse_m;
    better += joint_m < alone_m ? 1 : 0;
    squares_alone += square(alone_m);
    squares_joint += square(joint_m);
  }
  EXPECT_GE(better, kSeeds - 1);
  EXPECT_LT(std::sqrt(squares_joint), 0.3 * std::sqrt(squares_alone));
}

TEST(JointTeam, IsAsCertainAsItIsRight) {
  double nees = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    nees += SimulatedTeam(seed).run(true).nees / kSeeds;
  }
  // Three numbers each. The mean of one run has a standard deviation of 0.2 over seeds, that of
  // thirty runs of 0.04.
  EXPECT_NEAR(nees, 3.0, 0.15);
}

TEST(JointTeam, FalseSightingsAreGated) {
  double squares_clean = 0.0;
  double squares_false = 0.0;
  std::size_t gated = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    squares_clean += square(SimulatedTeam(seed).run(true).rmse_m);
    const TeamErrors errors = SimulatedTeam(seed).run(true, 0.1);
    squares_false += square(errors.rmse_m);
    gated += errors.gated;
  }
  EXPECT_GT(gated, 50U * kSeeds);
  EXPECT_LT(std::sqrt(squares_false), 1.2 * std::sqrt(squares_clean));
}

}  // namespace
}  // namespace echomap::localization
