// SPDX-License-Identifier: MIT
#include "host/slam/ekf_slam.hpp"

#include <utility>

#include "host/sensors/range_scan.hpp"
#include "host/slam/landmark_slam.hpp"
#include "host/slam/sonar_landmark_slam.hpp"

namespace echomap::slam {

using geometry::Pose2;

void EkfSlam::follow(const Pose2& T_odom_robot) {
  if (chosen_) {
    chosen_->follow(T_odom_robot);
  } else {
    T_odom_before_scans_.push_back(T_odom_robot);
  }
}

void EkfSlam::carry(const Pose2& T_odom_robot) {
  if (chosen_) {
    chosen_->carry(T_odom_robot);
  } else {
    follow(T_odom_robot);
  }
}

void EkfSlam::add(const Pose2& T_odom_robot, const sensors::RangeScan& scan) {
  if (!chosen_) {
    if (scan.beam_width_rad > 0.0) {
      chosen_ = std::make_unique<SonarLandmarkSlam>();
    } else {
      chosen_ = std::make_unique<LandmarkSlam>();
    }
    for (const Pose2& T_odom_before : std::exchange(T_odom_before_scans_, {})) {
      chosen_->follow(T_odom_before);
    }
  }
  chosen_->add(T_odom_robot, scan);
}

localization::PoseGaussian EkfSlam::belief() const {
  return chosen_ ? chosen_->belief() : localization::PoseGaussian{};
}

std::vector<Pose2> EkfSlam::trajectory() const {
  return chosen_ ? chosen_->trajectory() : std::vector<Pose2>{};
}

FactorGraph EkfSlam::factor_graph() const {
  return chosen_ ? chosen_->factor_graph() : FactorGraph{};
}

}  // namespace echomap::slam
