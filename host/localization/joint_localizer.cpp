// SPDX-License-Identifier: MIT
#include "host/localization/joint_localizer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Cholesky>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"

namespace echomap::localization {

namespace {

using geometry::square;

/// Numbers of one robot in the state: pose, then what it errs by slowly.
constexpr Eigen::Index kPoseSize = 3;
constexpr Eigen::Index kDriveScale = 3;
constexpr Eigen::Index kTurnScale = 4;
constexpr Eigen::Index kRangeScale = 5;
constexpr Eigen::Index kBearing = 6;
constexpr Eigen::Index kMovingSize = 5;

/// After so many time constants nothing of a slow error is left.
constexpr double kForgottenAfter = 5.0;

void validate(const JointLocalizerParams& params) {
  geometry::ParameterValidator("joint localizer")
      .positive("whole_step.drive_m", params.whole_step.drive_m)
      .positive("whole_step.turn_rad", params.whole_step.turn_rad)
      .nonnegative_finite("drive_scale_stddev", params.drive_scale_stddev)
      .nonnegative_finite("turn_scale_stddev", params.turn_scale_stddev)
      .nonnegative_finite("range_scale.stddev", params.range_scale.stddev)
      .positive("range_scale.time_constant_s", params.range_scale.time_constant_s)
      .nonnegative_finite("target_range_scale.stddev", params.target_range_scale.stddev)
      .positive("target_range_scale.time_constant_s", params.target_range_scale.time_constant_s)
      .nonnegative_finite("bearing_rad.stddev", params.bearing_rad.stddev)
      .positive("bearing_rad.time_constant_s", params.bearing_rad.time_constant_s)
      .positive("gate", params.gate)
      .nonnegative_finite("lost_stddev_m", params.lost_stddev_m)
      .nonnegative_finite("lost_stddev_rad", params.lost_stddev_rad);
}

}  // namespace

JointLocalizer::JointLocalizer(const JointLocalizerParams& params)
    : params_(params), motion_(params.motion), now_s_(-std::numeric_limits<double>::infinity()) {
  validate(params);
}

std::size_t JointLocalizer::add_robot(double stamp_s, const PoseGaussian& start) {
  if (!std::isfinite(stamp_s) || !is_finite(start.T_map_robot) ||
      !is_covariance(start.covariance)) {
    throw std::invalid_argument(
        "joint localizer: a start is finite, its covariance positive definite");
  }
  const Eigen::Index at = mean_.size();
  for (Eigen::Index i = 0; i < kPoseSize; ++i) {
    append(0.0);
  }
  append(square(params_.drive_scale_stddev));
  append(square(params_.turn_scale_stddev));
  append(square(params_.range_scale.stddev));
  append(square(params_.bearing_rad.stddev));
  const geometry::Pose2& T_map_robot = start.T_map_robot;
  mean_.segment<kPoseSize>(at) << T_map_robot.x_m(), T_map_robot.y_m(), T_map_robot.heading_rad();
  covariance_.block<kPoseSize, kPoseSize>(at, at) = start.covariance;
  robots_.push_back({at, stamp_s, stamp_s});
  return robots_.size() - 1;
}

EkfOutcome JointLocalizer::move(std::size_t robot,
                                double stamp_s,
                                const geometry::Pose2& T_before_after) {
  Robot& member = robots_[robot];
  if (!std::isfinite(stamp_s) || !is_finite(T_before_after)) {
    return counted(EkfOutcome::kNotFinite);
  }
  if (stamp_s <= member.moved_s) {
    return counted(EkfOutcome::kTimeRanBack);
  }
  member.moved_s = stamp_s;
  now_s_ = std::max(now_s_, stamp_s);
  const Eigen::Vector2d scales = odometry_scales(robot);
  const geometry::Pose2 T_scaled(scales.x() * T_before_after.x_m(),
                                 scales.x() * T_before_after.y_m(),
                                 scales.y() * T_before_after.heading_rad());
  const geometry::Pose2 T_map_before = belief(robot).T_map_robot;
  const models::OdometryStep step = models::odometry_step({}, T_scaled);
  const PoseGaussian after = moved({T_map_before, Eigen::Matrix3d::Zero()},
                                   T_scaled,
                                   step,
                                   models::cut_step_spread(motion_, step, params_.whole_step));
  Eigen::Matrix<double, kPoseSize, kMovingSize> by_before;
  by_before << motion_jacobians(T_map_before, T_scaled, step).jacobian_pose,
      Eigen::Vector3d::Zero(), Eigen::Vector3d(0.0, 0.0, T_before_after.heading_rad());
  by_before.block<2, 1>(0, kDriveScale) =
      T_map_before * T_before_after.position_m() - T_map_before.position_m();
  const Eigen::Index at = member.at;
  const Eigen::MatrixXd rows = by_before * covariance_.middleRows<kMovingSize>(at);
  covariance_.middleRows<kPoseSize>(at) = rows;
  covariance_.middleCols<kPoseSize>(at) = rows.transpose();
  covariance_.block<kPoseSize, kPoseSize>(at, at) =
      rows.middleCols<kMovingSize>(at) * by_before.transpose() + after.covariance;
  mean_.segment<kPoseSize>(at) << after.T_map_robot.x_m(), after.T_map_robot.y_m(),
      after.T_map_robot.heading_rad();
  return counted(EkfOutcome::kApplied);
}

EkfOutcome JointLocalizer::see_landmark(std::size_t robot,
                                        std::int64_t number,
                                        const LandmarkObservation& seen) {
  const EkfOutcome outcome = see({robot, number}, seen, nullptr);
  note_landmark(robots_[robot], outcome);
  return counted(outcome);
}

EkfOutcome JointLocalizer::see_peer(std::size_t observer,
                                    std::size_t peer,
                                    const PeerSighting& seen) {
  const LandmarkObservation as_landmark{seen.stamp_s,
                                        belief(peer).T_map_robot.position_m(),
                                        {},
                                        seen.range_m,
                                        seen.bearing_rad,
                                        seen.range_stddev_m,
                                        seen.bearing_stddev_rad};
  return counted(
      see({observer, -1 - static_cast<std::int64_t>(peer)}, as_landmark, &robots_[peer]));
}

PoseGaussian JointLocalizer::belief(std::size_t robot) const {
  const Eigen::Index at = robots_[robot].at;
  return {geometry::Pose2(mean_(at), mean_(at + 1), mean_(at + 2)),
          covariance_.block<kPoseSize, kPoseSize>(at, at)};
}

Eigen::Matrix3d JointLocalizer::covariance_between(std::size_t robot, std::size_t other) const {
  return covariance_.block<kPoseSize, kPoseSize>(robots_[robot].at, robots_[other].at);
}

Eigen::Vector2d JointLocalizer::odometry_scales(std::size_t robot) const {
  return Eigen::Vector2d::Ones() + mean_.segment<2>(robots_[robot].at + kDriveScale);
}

EkfOutcome JointLocalizer::counted(EkfOutcome outcome) {
  ++counts_[static_cast<std::size_t>(outcome)];
  return outcome;
}

/// A sighting of what the observation takes for a landmark: of a peer, whose place is in the state.
EkfOutcome JointLocalizer::see(const Pair& pair,
                               const LandmarkObservation& seen,
                               const Robot* peer) {
  if (const auto fault = fault_of(seen)) {
    return outcome_of(*fault);
  }
  if (seen.stamp_s < now_s_) {
    return EkfOutcome::kTooOld;
  }
  Robot& robot = robots_[pair.first];
  const auto linear = linearized(seen, belief(pair.first).T_map_robot);
  if (!linear) {
    return EkfOutcome::kAtLandmark;
  }
  now_s_ = seen.stamp_s;
  const double passed_s = seen.stamp_s - robot.sighted_s;
  decay(robot.at + kRangeScale, params_.range_scale, passed_s);
  decay(robot.at + kBearing, params_.bearing_rad, passed_s);
  robot.sighted_s = seen.stamp_s;
  const Eigen::Index target_at = target_error(pair, seen.stamp_s);
  const double expected_m = seen.range_m - linear->innovation(0);
  Eigen::Matrix<double, 2, Eigen::Dynamic> jacobian =
      Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, mean_.size());
  jacobian.middleCols<kPoseSize>(robot.at) = linear->jacobian_pose;
  jacobian(0, robot.at + kRangeScale) = expected_m;
  jacobian(0, target_at) = expected_m;
  jacobian(1, robot.at + kBearing) = 1.0;
  if (peer != nullptr) {
    jacobian.middleCols<2>(peer->at) = -linear->jacobian_pose.leftCols(2);
  }
  Eigen::Vector2d innovation = linear->innovation;
  innovation.x() -= expected_m * (mean_(robot.at + kRangeScale) + mean_(target_at));
  innovation.y() -= mean_(robot.at + kBearing);
  return correct(jacobian, innovation, linear->noise);
}

EkfOutcome JointLocalizer::correct(const Eigen::Matrix<double, 2, Eigen::Dynamic>& jacobian,
                                   const Eigen::Vector2d& innovation,
                                   const Eigen::Matrix2d& noise) {
  const Eigen::Matrix<double, Eigen::Dynamic, 2> cross = covariance_ * jacobian.transpose();
  const Eigen::LLT<Eigen::Matrix2d> root(jacobian * cross + noise);
  const Eigen::Vector2d whitened = root.matrixL().solve(innovation);
  if (!(whitened.squaredNorm() <= params_.gate)) {
    return EkfOutcome::kGated;
  }
  // With S = L L^T the gain is K = root_gain L^-1, and K S K^T = root_gain root_gain^T.
  const Eigen::MatrixXd root_gain = root.matrixL().solve(cross.transpose()).transpose();
  mean_ += root_gain * whitened;
  covariance_ -= root_gain * root_gain.transpose();
  return EkfOutcome::kApplied;
}

/// One more number at the end of the state, nought with that variance.
Eigen::Index JointLocalizer::append(double variance) {
  const Eigen::Index at = mean_.size();
  mean_.conservativeResize(at + 1);
  mean_(at) = 0.0;
  covariance_.conservativeResize(at + 1, at + 1);
  covariance_.row(at).setZero();
  covariance_.col(at).setZero();
  covariance_(at, at) = variance;
  return at;
}

void JointLocalizer::decay(Eigen::Index at, const SlowError& error, double duration_s) {
  const double left = std::exp(-std::max(0.0, duration_s) / error.time_constant_s);
  mean_(at) *= left;
  covariance_.row(at) *= left;
  covariance_.col(at) *= left;
  covariance_(at, at) += square(error.stddev) * (1.0 - square(left));
}

/// Where the error of this pair's ranges stands in the state, carried on until now.
Eigen::Index JointLocalizer::target_error(const Pair& pair, double stamp_s) {
  const SlowError& error = params_.target_range_scale;
  if (const auto known = target_errors_.find(pair); known != target_errors_.end()) {
    decay(known->second.at, error, stamp_s - known->second.sighted_s);
    known->second.sighted_s = stamp_s;
    return known->second.at;
  }
  const auto forgotten = std::ranges::find_if(target_errors_, [&](const auto& entry) {
    return stamp_s - entry.second.sighted_s > kForgottenAfter * error.time_constant_s;
  });
  if (forgotten == target_errors_.end()) {
    const Eigen::Index at = append(square(error.stddev));
    target_errors_[pair] = {at, stamp_s};
    return at;
  }
  const Eigen::Index at = forgotten->second.at;
  decay(at, error, std::numeric_limits<double>::infinity());
  target_errors_.erase(forgotten);
  target_errors_[pair] = {at, stamp_s};
  return at;
}

void JointLocalizer::note_landmark(Robot& robot, EkfOutcome outcome) {
  if (outcome == EkfOutcome::kApplied) {
    robot.gated_in_a_row = 0;
  }
  if (outcome != EkfOutcome::kGated || ++robot.gated_in_a_row < params_.max_gated_in_a_row) {
    return;
  }
  robot.gated_in_a_row = 0;
  ++robot.times_lost;
  covariance_.diagonal().segment<kPoseSize>(robot.at) +=
      Eigen::Vector3d(params_.lost_stddev_m, params_.lost_stddev_m, params_.lost_stddev_rad)
          .cwiseAbs2();
}

}  // namespace echomap::localization
