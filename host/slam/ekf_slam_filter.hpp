// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/localization/pose_gaussian.hpp"
#include "host/models/odometry_motion.hpp"
#include "host/slam/growing_covariance.hpp"
#include "host/slam/landmark_sighting.hpp"

namespace echomap::slam {

/// Settings of an EkfSlamFilter.
struct EkfSlamFilterParams {
  /// Errors of places are measured in a frame that turns with the error of the heading
  /// (right-invariant: Barrau and Bonnabel 2015). Without it the filter is that of the book, which
  /// grows too sure of its heading.
  bool is_invariant = true;
};

/// A landmark of the map.
struct Landmark {
  LandmarkKind kind = LandmarkKind::kPoint;
  Eigen::Vector2d value = Eigen::Vector2d::Zero();  ///< By the kind.
  /// Of a wall: the piece that has been seen, along the normal's quarter turn.
  double along_from_m = 0.0;
  double along_to_m = 0.0;
  int label = 0;
  std::size_t sightings = 0;
  std::size_t passes = 0;  ///< Number of beams that passed through its place.
};

/// A sighting of a landmark as a linear function of the state.
struct LinearSighting {
  Eigen::Vector2d innovation = Eigen::Vector2d::Zero();
  Eigen::Matrix<double, 2, 3> jacobian_pose = Eigen::Matrix<double, 2, 3>::Zero();
  Eigen::Matrix2d jacobian_target = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d noise = Eigen::Matrix2d::Identity();
  Eigen::Index pose_at = 0;    ///< Index of the robot's pose in the state.
  Eigen::Index target_at = 0;  ///< Index of the target's two numbers in the state.
};

/// A motion measured by odometry, corrected by the estimated calibration.
struct CalibratedMotion {
  geometry::Pose2 T_before_after;
  /// How x, y and heading of T_before_after change with the calibration.
  Eigen::Matrix3d by_calibration = Eigen::Matrix3d::Zero();
  Eigen::Vector3d variances =
      Eigen::Vector3d::Zero();  ///< Variances of the random errors of the same three.
};

/// SLAM with an extended Kalman filter (Thrun, Burgard and Fox 2005, table 10.1): the poses of a
/// robot, or of a team, and all landmarks are one normal distribution. A motion costs as much as
/// there are landmarks, an update the square of that. Sightings are to be told which landmark they
/// are of: see data_association.hpp.
class EkfSlamFilter {
 public:
  /// One robot at the map's origin.
  explicit EkfSlamFilter(const EkfSlamFilterParams& params = {});
  /// A robot for each start. Throws std::invalid_argument for no start, and for one that is not
  /// finite.
  explicit EkfSlamFilter(std::span<const localization::PoseGaussian> starts,
                         const EkfSlamFilterParams& params = {});

  /// A motion of a robot by `T_before_after`, which is driven as `step`, with that spread.
  void move(std::size_t robot,
            const geometry::Pose2& T_before_after,
            const models::OdometryStep& step,
            const models::MotionSpread& spread);
  /// From now on how odometry is off all the time is estimated, too, as three numbers that are
  /// nought as far as `covariance` leaves open.
  void add_calibration(const Eigen::Matrix3d& covariance);
  /// A motion of a robot after `add_calibration`.
  void move(std::size_t robot, const CalibratedMotion& motion);
  /// Where a robot would be after that.
  localization::PoseGaussian belief_after(std::size_t robot, const CalibratedMotion& motion) const;

  /// What a sighting says if it is of that landmark. Empty where the robot believes to stand on it.
  std::optional<LinearSighting> linearized(const LandmarkSighting& sighting,
                                           std::size_t landmark) const;
  /// What a sighting, a point, says if it is of another robot of the team.
  std::optional<LinearSighting> linearized_peer(const LandmarkSighting& sighting,
                                                std::size_t peer) const;
  /// Covariance of the innovations of two sightings, without their noise.
  Eigen::Matrix2d covariance_between(const LinearSighting& first,
                                     const LinearSighting& second) const;
  /// Squared Mahalanobis distance of one sighting's innovation.
  double squared_distance(const LinearSighting& sighting) const;

  /// Takes sightings of one instant at once.
  void update(std::span<const LinearSighting> sightings);
  /// Counts a sighting to its landmark, and lengthens a wall by what was seen of it.
  void note(const LandmarkSighting& sighting, std::size_t landmark);
  /// Counts a beam that went through where a landmark should be.
  void note_pass(std::size_t landmark) { ++landmarks_[landmark].passes; }
  /// Takes a landmark into the map; answers its index.
  std::size_t add(const LandmarkSighting& sighting);
  /// Takes a landmark out of the map; those behind it move up by one.
  void remove(std::size_t landmark);
  /// Keeps where a robot is now: what is learnt later corrects that place, too (a clone of the
  /// state, Roumeliotis and Burdick 2002).
  void store_pose(std::size_t robot = 0);
  /// Lets a kept pose go; those behind it move up by one.
  void forget_pose(std::size_t stored);

  std::size_t robots() const { return T_map_robots_.size(); }
  localization::PoseGaussian belief(std::size_t robot = 0) const;
  /// As far as it is known how odometry is off all the time.
  const Eigen::Vector3d& calibration() const { return calibration_; }
  const std::vector<Landmark>& landmarks() const { return landmarks_; }
  std::size_t stored_poses() const { return stored_.size(); }
  const geometry::Pose2& T_map_stored(std::size_t stored) const {
    return stored_[stored].T_map_robot;
  }
  Eigen::Matrix3d stored_covariance(std::size_t stored) const {
    return covariance_.block<3, 3>(stored_[stored].at, stored_[stored].at);
  }
  Eigen::Matrix2d landmark_covariance(std::size_t landmark) const;
  /// The diagonal of that.
  Eigen::Vector2d landmark_variance(std::size_t landmark) const;
  /// Of the poses of all robots, then of the calibration, of all landmarks and kept poses in the
  /// order they came.
  Eigen::MatrixXd covariance() const { return covariance_.whole(); }

 private:
  struct StoredPose {
    geometry::Pose2 T_map_robot;
    Eigen::Index at = 0;  ///< Where in the state it stands.
  };

  /// How a pose after a motion changes with the one before, and with the calibration.
  struct MotionChange {
    Eigen::Matrix3d jacobian_pose;
    Eigen::Matrix3d by_calibration;
    Eigen::Matrix3d noise;
  };

  /// What a sighting says if it is of a target that stands at `target_at` in the state.
  std::optional<LinearSighting> linearized_at(const LandmarkSighting& sighting,
                                              LandmarkKind kind,
                                              const Eigen::Vector2d& target,
                                              Eigen::Index target_at) const;
  MotionChange change_by(std::size_t robot, const CalibratedMotion& motion) const;
  Eigen::Index pose_at(std::size_t robot) const { return 3 * static_cast<Eigen::Index>(robot); }
  Eigen::Index landmark_at(std::size_t landmark) const { return landmarks_at_[landmark]; }
  void erase(Eigen::Index at, Eigen::Index size);
  /// Columns of P H^T for all sightings.
  Eigen::MatrixXd cross_covariance(std::span<const LinearSighting> sightings) const;
  Eigen::MatrixXd innovation_covariance(std::span<const LinearSighting> sightings,
                                        const Eigen::MatrixXd& cross) const;
  void step_by(const Eigen::VectorXd& correction);
  Eigen::MatrixXd step_invariantly_by(const Eigen::VectorXd& correction);
  void carry_errors(const Eigen::MatrixXd& by_first);

  EkfSlamFilterParams params_;
  std::vector<geometry::Pose2> T_map_robots_;
  std::vector<Landmark> landmarks_;
  std::vector<Eigen::Index> landmarks_at_;
  std::vector<StoredPose> stored_;
  Eigen::Vector3d calibration_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Index> calibration_at_;
  GrowingCovariance covariance_;
};

}  // namespace echomap::slam
