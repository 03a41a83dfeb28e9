// SPDX-License-Identifier: MIT
#include "host/slam/ekf_slam_filter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;

constexpr Eigen::Index kPoseSize = 3;
constexpr Eigen::Index kLandmarkSize = 2;
constexpr Eigen::Index kCalibrationSize = 3;

/// What the exponential map of SE(2) makes of a translation while it turns.
Eigen::Matrix2d turning_translation(double turn_rad) {
  if (std::abs(turn_rad) < 1e-9) {
    return Eigen::Matrix2d::Identity();
  }
  const double along = std::sin(turn_rad) / turn_rad;
  const double aside = (1.0 - std::cos(turn_rad)) / turn_rad;
  Eigen::Matrix2d matrix;
  matrix << along, -aside, aside, along;
  return matrix;
}

/// A correction as a turn and translation of the whole map, that of the first robot, and what each
/// place is moved by of its own.
class GroupStep {
 public:
  GroupStep(const Eigen::Vector2d& first_m, const Eigen::VectorXd& correction)
      : first_m_(first_m), turn_rad_(correction.z()), turning_(turning_translation(turn_rad_)) {}

  Eigen::Vector2d place_m(const Eigen::Vector2d& place_m,
                          const Eigen::Vector2d& correction_m) const {
    const Eigen::Vector2d own_m = correction_m - turn_rad_ * geometry::perpendicular(place_m);
    return Pose2(0.0, 0.0, turn_rad_) * place_m + turning_ * own_m;
  }
  Eigen::RowVector3d wall_by_first(const Eigen::Vector2d& before,
                                   const Eigen::Vector2d& after) const {
    const Eigen::Vector2d swing =
        geometry::unit_vector(after.y()) - geometry::unit_vector(before.y());
    return {swing.x(), swing.y(), -swing.dot(geometry::perpendicular(first_m_))};
  }

 private:
  Eigen::Vector2d first_m_;
  double turn_rad_;
  Eigen::Matrix2d turning_;
};

}  // namespace

EkfSlamFilter::EkfSlamFilter(const EkfSlamFilterParams& params)
    : EkfSlamFilter(std::vector<localization::PoseGaussian>(1), params) {}

EkfSlamFilter::EkfSlamFilter(std::span<const localization::PoseGaussian> starts,
                             const EkfSlamFilterParams& params)
    : params_(params) {
  if (starts.empty()) {
    throw std::invalid_argument("EKF-SLAM filter: a team needs at least one robot");
  }
  for (const localization::PoseGaussian& start : starts) {
    if (!localization::is_finite(start.T_map_robot) || !start.covariance.allFinite()) {
      throw std::invalid_argument("EKF-SLAM filter: a start must be finite");
    }
    T_map_robots_.push_back(start.T_map_robot);
    covariance_.append(Eigen::MatrixXd::Zero(kPoseSize, covariance_.size()), start.covariance);
  }
}

void EkfSlamFilter::move(std::size_t robot,
                         const Pose2& T_before_after,
                         const models::OdometryStep& step,
                         const models::MotionSpread& spread) {
  const localization::PoseGaussian before = belief(robot);
  const localization::PoseGaussian after =
      localization::moved(before, T_before_after, step, spread);
  const Eigen::Matrix3d jacobian_pose =
      localization::motion_jacobians(before.T_map_robot, T_before_after, step).jacobian_pose;
  const Eigen::Index at = pose_at(robot);
  Eigen::MatrixXd columns = covariance_.columns<kPoseSize>(at) * jacobian_pose.transpose();
  columns.middleRows<kPoseSize>(at) = after.covariance;
  covariance_.set_columns(at, columns);
  T_map_robots_[robot] = after.T_map_robot;
}

void EkfSlamFilter::add_calibration(const Eigen::Matrix3d& covariance) {
  calibration_at_ = covariance_.size();
  covariance_.append(Eigen::MatrixXd::Zero(kCalibrationSize, covariance_.size()), covariance);
}

EkfSlamFilter::MotionChange EkfSlamFilter::change_by(std::size_t robot,
                                                     const CalibratedMotion& motion) const {
  const Pose2& T_map_before = T_map_robots_[robot];
  Eigen::Matrix3d to_map = Eigen::Matrix3d::Identity();
  to_map.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(T_map_before.heading_rad()).toRotationMatrix();
  MotionChange change{Eigen::Matrix3d::Identity(),
                      to_map * motion.by_calibration,
                      to_map * motion.variances.asDiagonal() * to_map.transpose()};
  change.jacobian_pose.topRightCorner<2, 1>() =
      geometry::perpendicular(to_map.topLeftCorner<2, 2>() * motion.T_before_after.position_m());
  return change;
}

localization::PoseGaussian EkfSlamFilter::belief_after(std::size_t robot,
                                                       const CalibratedMotion& motion) const {
  const MotionChange change = change_by(robot, motion);
  Eigen::Matrix<double, 3, 6> by_both;
  by_both << change.jacobian_pose, change.by_calibration;
  const Eigen::Index at = pose_at(robot);
  // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the calibration is estimated
  const Eigen::Index calibration_at = *calibration_at_;
  const Eigen::Matrix3d cross = covariance_.block<3, 3>(at, calibration_at);
  Eigen::Matrix<double, 6, 6> both;
  both << covariance_.block<3, 3>(at, at), cross, cross.transpose(),
      covariance_.block<3, 3>(calibration_at, calibration_at);
  return {T_map_robots_[robot] * motion.T_before_after,
          by_both * both * by_both.transpose() + change.noise};
}

void EkfSlamFilter::move(std::size_t robot, const CalibratedMotion& motion) {
  const MotionChange change = change_by(robot, motion);
  const localization::PoseGaussian after = belief_after(robot, motion);
  const Eigen::Index at = pose_at(robot);
  Eigen::MatrixXd columns =
      covariance_.columns<kPoseSize>(at) * change.jacobian_pose.transpose() +
      // NOLINTNEXTLINE(bugprone-unchecked-optional-access): the calibration is estimated
      covariance_.columns<kCalibrationSize>(*calibration_at_) * change.by_calibration.transpose();
  columns.middleRows<kPoseSize>(at) = after.covariance;
  covariance_.set_columns(at, columns);
  T_map_robots_[robot] = after.T_map_robot;
}

std::optional<LinearSighting> EkfSlamFilter::linearized(const LandmarkSighting& sighting,
                                                        std::size_t landmark) const {
  const Landmark& target = landmarks_[landmark];
  return linearized_at(sighting, target.kind, target.value, landmark_at(landmark));
}

std::optional<LinearSighting> EkfSlamFilter::linearized_peer(const LandmarkSighting& sighting,
                                                             std::size_t peer) const {
  return linearized_at(
      sighting, LandmarkKind::kPoint, T_map_robots_[peer].position_m(), pose_at(peer));
}

std::optional<LinearSighting> EkfSlamFilter::linearized_at(const LandmarkSighting& sighting,
                                                           LandmarkKind kind,
                                                           const Eigen::Vector2d& target,
                                                           Eigen::Index target_at) const {
  const auto expected =
      expected_sighting(kind, target, T_map_robots_[sighting.robot], sighting.T_robot_sensor);
  if (!expected) {
    return std::nullopt;
  }
  return LinearSighting{innovation(sighting.value, expected->value),
                        expected->jacobian_pose,
                        expected->jacobian_landmark,
                        sighting.noise,
                        pose_at(sighting.robot),
                        target_at};
}

Eigen::Matrix2d EkfSlamFilter::covariance_between(const LinearSighting& first,
                                                  const LinearSighting& second) const {
  const auto poses = covariance_.block<3, 3>(first.pose_at, second.pose_at);
  const auto pose_target = covariance_.block<3, 2>(first.pose_at, second.target_at);
  const auto target_pose = covariance_.block<2, 3>(first.target_at, second.pose_at);
  const auto targets = covariance_.block<2, 2>(first.target_at, second.target_at);
  return (first.jacobian_pose * poses + first.jacobian_target * target_pose) *
             second.jacobian_pose.transpose() +
         (first.jacobian_pose * pose_target + first.jacobian_target * targets) *
             second.jacobian_target.transpose();
}

double EkfSlamFilter::squared_distance(const LinearSighting& sighting) const {
  const Eigen::Matrix2d covariance = covariance_between(sighting, sighting) + sighting.noise;
  return sighting.innovation.dot(covariance.llt().solve(sighting.innovation));
}

Eigen::MatrixXd EkfSlamFilter::cross_covariance(std::span<const LinearSighting> sightings) const {
  Eigen::MatrixXd cross(covariance_.size(), 2 * static_cast<Eigen::Index>(sightings.size()));
  Eigen::Index column = 0;
  for (const LinearSighting& sighting : sightings) {
    cross.middleCols<2>(column) =
        covariance_.columns<3>(sighting.pose_at) * sighting.jacobian_pose.transpose() +
        covariance_.columns<2>(sighting.target_at) * sighting.jacobian_target.transpose();
    column += 2;
  }
  return cross;
}

/// S of all sightings together.
Eigen::MatrixXd EkfSlamFilter::innovation_covariance(std::span<const LinearSighting> sightings,
                                                     const Eigen::MatrixXd& cross) const {
  Eigen::MatrixXd covariance(cross.cols(), cross.cols());
  Eigen::Index row = 0;
  for (const LinearSighting& sighting : sightings) {
    covariance.middleRows<2>(row) =
        sighting.jacobian_pose * cross.middleRows<3>(sighting.pose_at) +
        sighting.jacobian_target * cross.middleRows<2>(sighting.target_at);
    covariance.block<2, 2>(row, row) += sighting.noise;
    row += 2;
  }
  return covariance;
}

void EkfSlamFilter::update(std::span<const LinearSighting> sightings) {
  if (sightings.empty()) {
    return;
  }
  Eigen::VectorXd innovations(2 * static_cast<Eigen::Index>(sightings.size()));
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    innovations.segment<2>(2 * static_cast<Eigen::Index>(i)) = sightings[i].innovation;
  }
  const Eigen::MatrixXd cross = cross_covariance(sightings);
  const Eigen::LLT<Eigen::MatrixXd> root(innovation_covariance(sightings, cross));
  if (root.info() != Eigen::Success) {
    return;
  }
  // With S = L L^T the gain is K = root_gain L^-1, and K S K^T = root_gain root_gain^T.
  const Eigen::MatrixXd root_gain = root.matrixL().solve(cross.transpose()).transpose();
  const Eigen::VectorXd correction = root_gain * root.matrixL().solve(innovations);
  if (calibration_at_) {
    calibration_ += correction.segment<kCalibrationSize>(*calibration_at_);
  }
  covariance_.add_product(-root_gain, root_gain);
  if (params_.is_invariant) {
    carry_errors(step_invariantly_by(correction));
  } else {
    step_by(correction);
  }
}

/// Moves the mean as the book does: by addition.
void EkfSlamFilter::step_by(const Eigen::VectorXd& correction) {
  const auto moved = [&](const Pose2& pose, Eigen::Index at) {
    return Pose2(pose.x_m() + correction(at),
                 pose.y_m() + correction(at + 1),
                 pose.heading_rad() + correction(at + 2));
  };
  for (std::size_t i = 0; i < robots(); ++i) {
    T_map_robots_[i] = moved(T_map_robots_[i], pose_at(i));
  }
  for (StoredPose& stored : stored_) {
    stored.T_map_robot = moved(stored.T_map_robot, stored.at);
  }
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    landmarks_[i].value += correction.segment<kLandmarkSize>(landmark_at(i));
  }
}

/// Moves the mean along the group of turns and translations of the whole map. Answers U: by how
/// much more the error of each place now changes with that of the first robot's pose.
Eigen::MatrixXd EkfSlamFilter::step_invariantly_by(const Eigen::VectorXd& correction) {
  Eigen::MatrixXd by_first = Eigen::MatrixXd::Zero(covariance_.size(), kPoseSize);
  const GroupStep step(T_map_robots_.front().position_m(), correction);
  const auto moved = [&](const Eigen::Vector2d& place_m, Eigen::Index at) {
    Eigen::Vector2d after_m = step.place_m(place_m, correction.segment<2>(at));
    by_first.block<2, 1>(at, 2) = geometry::perpendicular(after_m - place_m);
    return after_m;
  };
  const auto moved_pose = [&](const Pose2& pose, Eigen::Index at) {
    const Eigen::Vector2d after_m = moved(pose.position_m(), at);
    return Pose2(after_m.x(), after_m.y(), pose.heading_rad() + correction(at + 2));
  };
  for (std::size_t i = 0; i < robots(); ++i) {
    T_map_robots_[i] = moved_pose(T_map_robots_[i], pose_at(i));
  }
  for (StoredPose& stored : stored_) {
    stored.T_map_robot = moved_pose(stored.T_map_robot, stored.at);
  }
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const Eigen::Index at = landmark_at(i);
    Eigen::Vector2d& value = landmarks_[i].value;
    if (landmarks_[i].kind == LandmarkKind::kPoint) {
      value = moved(value, at);
      continue;
    }
    const Eigen::Vector2d before = value;
    // By addition: a turn around the origin changes the normal alone, and what stays, stays.
    value.x() += correction(at);
    value.y() = geometry::wrap_angle(value.y() + correction(at + 1));
    by_first.row(at) = step.wall_by_first(before, value);
  }
  return by_first;
}

/// Errors are carried from where the state was to where it is: M P M^T with M = I + U E^T, E the
/// columns of the first robot's pose.
void EkfSlamFilter::carry_errors(const Eigen::MatrixXd& by_first) {
  const Eigen::MatrixXd carried =
      covariance_.columns<kPoseSize>(0) + 0.5 * by_first * covariance_.block<3, 3>(0, 0);
  Eigen::MatrixXd left(covariance_.size(), 2 * kPoseSize);
  Eigen::MatrixXd right(covariance_.size(), 2 * kPoseSize);
  left << by_first, carried;
  right << carried, by_first;
  covariance_.add_product(left, right);
}

void EkfSlamFilter::note(const LandmarkSighting& sighting, std::size_t landmark) {
  Landmark& target = landmarks_[landmark];
  ++target.sightings;
  if (target.kind == LandmarkKind::kWall) {
    const Pose2 T_map_sensor = T_map_robots_[sighting.robot] * sighting.T_robot_sensor;
    const double foot_m = geometry::perpendicular(geometry::unit_vector(target.value.y()))
                              .dot(T_map_sensor.position_m());
    target.along_from_m = std::min(target.along_from_m, foot_m + sighting.along_from_m);
    target.along_to_m = std::max(target.along_to_m, foot_m + sighting.along_to_m);
  }
}

std::size_t EkfSlamFilter::add(const LandmarkSighting& sighting) {
  const PlacedLandmark placed = placed_landmark(sighting, T_map_robots_[sighting.robot]);
  const Eigen::Index at = pose_at(sighting.robot);
  landmarks_at_.push_back(covariance_.size());
  const Eigen::MatrixXd cross =
      placed.jacobian_pose * covariance_.columns<kPoseSize>(at).transpose();
  covariance_.append(cross,
                     cross.middleCols<kPoseSize>(at) * placed.jacobian_pose.transpose() +
                         placed.by_value * sighting.noise * placed.by_value.transpose());
  Landmark landmark{sighting.kind, placed.landmark, 0.0, 0.0, sighting.label, 0};
  const Pose2 T_map_sensor = T_map_robots_[sighting.robot] * sighting.T_robot_sensor;
  const double foot_m = geometry::perpendicular(geometry::unit_vector(placed.landmark.y()))
                            .dot(T_map_sensor.position_m());
  landmark.along_from_m = foot_m + sighting.along_from_m;
  landmark.along_to_m = foot_m + sighting.along_to_m;
  landmark.sightings = 1;
  landmarks_.push_back(landmark);
  return landmarks_.size() - 1;
}

void EkfSlamFilter::remove(std::size_t landmark) {
  erase(landmark_at(landmark), kLandmarkSize);
  landmarks_.erase(landmarks_.begin() + static_cast<std::ptrdiff_t>(landmark));
  landmarks_at_.erase(landmarks_at_.begin() + static_cast<std::ptrdiff_t>(landmark));
}

void EkfSlamFilter::store_pose(std::size_t robot) {
  const Eigen::Index at = pose_at(robot);
  stored_.push_back({T_map_robots_[robot], covariance_.size()});
  covariance_.append(covariance_.columns<kPoseSize>(at).transpose(),
                     covariance_.block<kPoseSize, kPoseSize>(at, at));
}

void EkfSlamFilter::forget_pose(std::size_t stored) {
  erase(stored_[stored].at, kPoseSize);
  stored_.erase(stored_.begin() + static_cast<std::ptrdiff_t>(stored));
}

void EkfSlamFilter::erase(Eigen::Index at, Eigen::Index size) {
  covariance_.erase(at, size);
  for (Eigen::Index& other : landmarks_at_) {
    other -= other > at ? size : 0;
  }
  for (StoredPose& other : stored_) {
    other.at -= other.at > at ? size : 0;
  }
  if (calibration_at_ && *calibration_at_ > at) {
    *calibration_at_ -= size;
  }
}

localization::PoseGaussian EkfSlamFilter::belief(std::size_t robot) const {
  return {T_map_robots_[robot], covariance_.block<3, 3>(pose_at(robot), pose_at(robot))};
}

Eigen::Matrix2d EkfSlamFilter::landmark_covariance(std::size_t landmark) const {
  return covariance_.block<2, 2>(landmark_at(landmark), landmark_at(landmark));
}

Eigen::Vector2d EkfSlamFilter::landmark_variance(std::size_t landmark) const {
  const Eigen::Index at = landmark_at(landmark);
  return {covariance_.at(at, at), covariance_.at(at + 1, at + 1)};
}

}  // namespace echomap::slam
