// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "host/sensors/range_scan.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::slam {

/// EKF-SLAM for any range sensor: the first scan says whether its beams are thin (LandmarkSlam) or
/// cones (SonarLandmarkSlam).
class EkfSlam final : public SlamMethod {
 public:
  void follow(const geometry::Pose2& T_odom_robot) override;
  void carry(const geometry::Pose2& T_odom_robot) override;
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override;
  localization::PoseGaussian belief() const override;
  std::vector<geometry::Pose2> trajectory() const override;
  FactorGraph factor_graph() const override;

 private:
  std::vector<geometry::Pose2>
      T_odom_before_scans_;  ///< Odometry poses from before the first scan.
  std::unique_ptr<SlamMethod> chosen_;
};

}  // namespace echomap::slam
