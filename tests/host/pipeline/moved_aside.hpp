// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/sensors/range_scan.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::pipeline {

/// SLAM that has every scan a metre to the left of where the odometry has it, or so far as is told.
class MovedAside : public slam::SlamMethod {
 public:
  void follow(const geometry::Pose2& /*T_odom_robot*/) override { ++followed; }
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override {
    poses.push_back(T_odom_robot);
    beams += scan.beams.size();
  }
  localization::PoseGaussian belief() const override {
    return poses.empty() ? localization::PoseGaussian{}
                         : localization::PoseGaussian{T_map_odom * poses.back(), covariance};
  }
  std::vector<geometry::Pose2> trajectory() const override {
    std::vector<geometry::Pose2> moved;
    for (const geometry::Pose2& pose : poses) {
      moved.push_back(T_map_odom * pose);
    }
    return moved;
  }
  slam::FactorGraph factor_graph() const override { return {trajectory(), {}, {}, {}}; }

  geometry::Pose2 T_map_odom{0.0, 1.0, 0.0};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::vector<geometry::Pose2> poses;  ///< By odometry.
  std::size_t beams = 0;
  std::size_t followed = 0;
};

}  // namespace echomap::pipeline
