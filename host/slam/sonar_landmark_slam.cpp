// SPDX-License-Identifier: MIT
#include "host/slam/sonar_landmark_slam.hpp"

#include <algorithm>
#include <stdexcept>

#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

using geometry::Pose2;

SonarLandmarkSlam::SonarLandmarkSlam(const SonarLandmarkSlamParams& params)
    : params_(params), gathering_(params.gathering), random_(params.seed) {
  validate(params.landmarks);
  const bool trusts_ok =
      !params.noise_hypotheses.empty() && std::all_of(params.noise_hypotheses.begin(),
                                                      params.noise_hypotheses.end(),
                                                      [](const OdometryNoisePrior& hypothesis) {
                                                        return hypothesis.steady_scale > 0.0 &&
                                                               hypothesis.chance_scale > 0.0;
                                                      });
  if (!params.odometry.is_sound() || !(params.calibration_stddev.minCoeff() > 0.0) || !trusts_ok) {
    throw std::invalid_argument("sonar landmark slam: odometry's deviations are above 0");
  }
  begin_at({});
}

void SonarLandmarkSlam::begin_at(const Pose2& T_odom_robot) {
  const localization::PoseGaussian start{T_odom_robot};
  estimates_.clear();
  for (const OdometryNoisePrior& hypothesis : params_.noise_hypotheses) {
    Estimate& estimate =
        estimates_.emplace_back(Estimate{EkfSlamFilter({&start, 1}, params_.filter),
                                         LandmarkUpdate(params_.update),
                                         PoseHistory(params_.pose_history),
                                         hypothesis.negative_log_evidence});
    const Eigen::Vector3d sd = hypothesis.steady_scale * params_.calibration_stddev;
    estimate.filter.add_calibration(sd.cwiseAbs2().asDiagonal());
  }
}

void SonarLandmarkSlam::begin_once(const Pose2& T_odom_robot) {
  if (!gathering_.has_begun()) {
    begin_at(T_odom_robot);
  }
}

void SonarLandmarkSlam::follow(const Pose2& T_odom_robot) {
  begin_once(T_odom_robot);
  gathering_.follow(T_odom_robot);
}

void SonarLandmarkSlam::carry(const Pose2& T_odom_robot) {
  begin_once(T_odom_robot);
  gathering_.carry(T_odom_robot);
}

void SonarLandmarkSlam::add(const Pose2& T_odom_robot, const sensors::RangeScan& scan) {
  follow(T_odom_robot);
  if (const auto piece = gathering_.add(T_odom_robot, scan)) {
    finish_multiscan(*piece);
  }
  open_.push_back(gathering_.piece());
}

void SonarLandmarkSlam::finish_multiscan(const OdometryPiece& piece) {
  const Multiscan& finished = gathering_.finished();
  const auto sightings = sonar_landmarks(finished.echoes, params_.landmarks, random_);
  for (std::size_t i = 0; i < estimates_.size(); ++i) {
    Estimate& estimate = estimates_[i];
    estimate.negative_log_evidence +=
        estimate.update.add_sightings(sightings, finished.T_odom_begin, estimate.filter);
    estimate.pose_history.keep(estimate.filter);
    for (const OdometryPiece& to_scan : open_) {
      estimate.pose_history.add(motion_by(to_scan, i).T_before_after);
    }
    estimate.filter.move(0, motion_by(piece, i));
    if (estimate.negative_log_evidence < estimates_[best_].negative_log_evidence) {
      best_ = i;
    }
  }
  open_.clear();
}

CalibratedMotion SonarLandmarkSlam::motion_by(const OdometryPiece& piece,
                                              std::size_t estimate) const {
  const OdometryCalibration calibration{estimates_[estimate].filter.calibration()};
  const double scale = params_.noise_hypotheses[estimate].chance_scale;
  return {calibrated(piece, calibration),
          calibrated_by_calibration(piece, calibration),
          scale * scale * variances(piece, params_.odometry)};
}

localization::PoseGaussian SonarLandmarkSlam::belief() const {
  return open_.empty() ? localization::PoseGaussian{}
                       : filter().belief_after(0, motion_by(open_.back(), best_));
}

std::vector<Pose2> SonarLandmarkSlam::trajectory() const {
  std::vector<Pose2> T_map_robots = estimates_[best_].pose_history.trajectory(filter());
  for (const OdometryPiece& to_scan : open_) {
    T_map_robots.push_back(filter().belief().T_map_robot *
                           motion_by(to_scan, best_).T_before_after);
  }
  return T_map_robots;
}

}  // namespace echomap::slam
