// SPDX-License-Identifier: MIT
#include "host/slam/scan_gathering.hpp"

#include "host/geometry/parameter_validator.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {
namespace {

std::vector<Eigen::Vector2d> spaced_points_m(const sensors::RangeScan& scan,
                                             double max_range_m,
                                             double spacing_m) {
  std::vector<Eigen::Vector2d> kept_m;
  for (const Eigen::Vector2d& point_m : sensors::end_points_m(scan, max_range_m)) {
    if (kept_m.empty() || (point_m - kept_m.back()).squaredNorm() >= spacing_m * spacing_m) {
      kept_m.push_back(point_m);
    }
  }
  return kept_m;
}

}  // namespace

ScanGathering::ScanGathering(const ScanGatheringParams& params) : params_(params) {
  geometry::ParameterValidator("scan gathering")
      .positive("max_range_m", params.max_range_m)
      .at_least("spacing_m", params.spacing_m, 0)
      .at_least("min_points", params.min_points, 1)
      .positive("max_distance_m", params.max_distance_m)
      .at_least("max_scans", params.max_scans, 1);
}

void ScanGathering::add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) {
  if (!scans_.empty()) {
    travelled_m_ += (T_odom_robot.position_m() - scans_.back().T_odom_robot.position_m()).norm();
  }
  scans_.push_back({T_odom_robot, scan});
  points_m_.push_back(spaced_points_m(scan, params_.max_range_m, params_.spacing_m));
  count_ += points_m_.back().size();
}

bool ScanGathering::is_enough() const {
  return count_ >= params_.min_points || travelled_m_ >= params_.max_distance_m ||
         scans_.size() >= params_.max_scans;
}

std::vector<Eigen::Vector2d> ScanGathering::points_m() const {
  std::vector<Eigen::Vector2d> all_m;
  all_m.reserve(count_);
  const geometry::Pose2 T_now_odom = scans_.back().T_odom_robot.inverse();
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const auto points_m = sensors::in_frame_a_m(T_now_odom * scans_[i].T_odom_robot, points_m_[i]);
    all_m.insert(all_m.end(), points_m.begin(), points_m.end());
  }
  return all_m;
}

void ScanGathering::clear() {
  scans_.clear();
  points_m_.clear();
  count_ = 0;
  travelled_m_ = 0.0;
}

}  // namespace echomap::slam
