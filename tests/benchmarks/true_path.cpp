// SPDX-License-Identifier: MIT
#include "tests/benchmarks/true_path.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "host/geometry/angle.hpp"

namespace echomap::bench {

namespace {

constexpr double kLongestGapS = 0.5;

}  // namespace

void TruePath::add(double stamp_s, const geometry::Pose2& T_map_robot) {
  poses_.emplace_back(stamp_s, T_map_robot);
}

std::optional<geometry::Pose2> TruePath::at(double stamp_s) const {
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), stamp_s, [](double stamp, const auto& pose) {
        return stamp < pose.first;
      });
  if (after == poses_.begin() || after == poses_.end()) {
    return std::nullopt;
  }
  const auto& [from_s, from] = *std::prev(after);
  const auto& [to_s, to] = *after;
  if (to_s - from_s > kLongestGapS) {
    return std::nullopt;
  }
  const double share = (stamp_s - from_s) / (to_s - from_s);
  const Eigen::Vector2d position_m =
      from.position_m() + share * (to.position_m() - from.position_m());
  return geometry::Pose2(
      position_m.x(),
      position_m.y(),
      from.heading_rad() + share * geometry::angle_between(from.heading_rad(), to.heading_rad()));
}

void FollowTally::count(const localization::PoseGaussian& belief,
                        const geometry::Pose2& truth,
                        const geometry::Pose2& dead_reckoning,
                        bool with_heading) {
  const Eigen::Vector2d off_m = belief.T_map_robot.position_m() - truth.position_m();
  sums_.mean_m += off_m.norm();
  sums_.rmse_m += off_m.squaredNorm();
  sums_.dead_reckoning_mean_m += (dead_reckoning.position_m() - truth.position_m()).norm();
  const Eigen::Vector3d off(
      off_m.x(),
      off_m.y(),
      geometry::angle_between(truth.heading_rad(), belief.T_map_robot.heading_rad()));
  const Eigen::Matrix2d place = belief.covariance.topLeftCorner<2, 2>();
  sums_.nees += with_heading ? off.dot(belief.covariance.llt().solve(off))
                             : off_m.dot(place.llt().solve(off_m));
  ++sums_.poses;
}

FollowScore FollowTally::score(std::size_t gated) const {
  FollowScore score = sums_;
  const auto poses = static_cast<double>(score.poses);
  score.mean_m /= poses;
  score.rmse_m = std::sqrt(score.rmse_m / poses);
  score.dead_reckoning_mean_m /= poses;
  score.nees /= poses;
  score.gated = gated;
  return score;
}

}  // namespace echomap::bench
