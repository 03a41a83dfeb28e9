// SPDX-License-Identifier: MIT
#include "host/evaluation/belief_error.hpp"

#include <chrono>
#include <cmath>

#include <Eigen/Cholesky>

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"

namespace echomap::evaluation {

namespace {

constexpr std::chrono::milliseconds kMaxTruthGap(500);
/// 95 % of chi square with two degrees of freedom.
constexpr double kChiSquare95 = 5.991;

}  // namespace

BeliefError score_beliefs(const std::vector<pipeline::StampedBelief>& beliefs,
                          const std::vector<TruePose>& truth) {
  BeliefError error;
  for (const auto& [stamp, belief] : beliefs) {
    const auto T_map_true = true_pose_at(truth, stamp, kMaxTruthGap);
    if (!T_map_true) {
      continue;
    }
    const Eigen::Vector2d off_m = belief.T_map_robot.position_m() - T_map_true->position_m();
    const double off_rad =
        geometry::angle_between(T_map_true->heading_rad(), belief.T_map_robot.heading_rad());
    const Eigen::Vector3d off(off_m.x(), off_m.y(), off_rad);
    const Eigen::Matrix2d of_position = belief.covariance.topLeftCorner<2, 2>();
    ++error.poses;
    error.rmse_m += off_m.squaredNorm();
    error.heading_rmse_rad += geometry::square(off_rad);
    error.expected_rmse_m += of_position.trace();
    error.nees += off.dot(belief.covariance.llt().solve(off));
    error.within_95 += off_m.dot(of_position.llt().solve(off_m)) <= kChiSquare95 ? 1.0 : 0.0;
  }
  if (error.poses > 0) {
    const auto poses = static_cast<double>(error.poses);
    error.rmse_m = std::sqrt(error.rmse_m / poses);
    error.heading_rmse_rad = std::sqrt(error.heading_rmse_rad / poses);
    error.expected_rmse_m = std::sqrt(error.expected_rmse_m / poses);
    error.nees /= poses;
    error.within_95 /= poses;
  }
  return error;
}

}  // namespace echomap::evaluation
