// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_slam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host/slam/multiscan_factors.hpp"

namespace echomap::slam {

namespace {

/// From one odometry scale to the next that is tried.
constexpr double kScaleStep = 1.5;

}  // namespace

MultiscanSlam::MultiscanSlam(const MultiscanSlamParams& params)
    : params_(params), gathering_(params.gathering) {
  const bool scales_ok = params.least_odometry_scale > 0.0 && params.least_odometry_scale <= 1.0 &&
                         params.most_odometry_scale >= 1.0 &&
                         std::isfinite(params.most_odometry_scale);
  if (!scales_ok || params.window < 2 || params.steps < 1 || !(params.whole_share >= 0.0)) {
    throw std::invalid_argument("multiscan SLAM: a parameter is outside of its range");
  }
  check(params.patches);
  check(params.matching);
  check(params.alignment);
  graph_.multiscans.emplace_back();
}

void MultiscanSlam::follow(const geometry::Pose2& T_odom_robot) {
  if (!has_begun_) {
    graph_.multiscans.front().T_map_begin = T_odom_robot;
    has_begun_ = true;
  }
  gathering_.follow(T_odom_robot);
}

void MultiscanSlam::add(const geometry::Pose2& T_odom_robot, const RangeScan& scan) {
  follow(T_odom_robot);
  if (const auto piece = gathering_.add(T_odom_robot, scan)) {
    begin_multiscan(*piece);
  }
  scans_.push_back({graph_.pieces.size(), gathering_.piece().T_before_after, scan});
}

void MultiscanSlam::begin_multiscan(const OdometryPiece& piece) {
  graph_.multiscans.back().patches = find_patches(gathering_.finished().echoes, params_.patches);
  const geometry::Pose2 T_map_begin =
      graph_.multiscans.back().T_map_begin * calibrated(piece, graph_.calibration);
  graph_.pieces.push_back(piece);
  graph_.multiscans.push_back({T_map_begin, {}, covariance_after(piece)});
  align();
}

std::size_t MultiscanSlam::first_of_window() const {
  const std::size_t count = graph_.multiscans.size();
  return count > params_.window ? count - params_.window : 1;
}

void MultiscanSlam::align() {
  const std::size_t count = graph_.multiscans.size();
  const auto due = static_cast<std::size_t>(params_.whole_share * static_cast<double>(count));
  const std::size_t window = first_of_window();
  if (count < aligned_whole_ + std::max<std::size_t>(1, due)) {
    for (int step = 0; step < params_.steps; ++step) {
      align_from(window, window);
    }
    return;
  }
  learn_odometry_scale(match_patches(graph_.multiscans, 1, params_.matching), window);
  for (int step = 0; step < params_.steps; ++step) {
    graph_.multiscans.back().covariance = align_from(1, window).last_covariance;
  }
  aligned_whole_ = count;
}

AlignmentStep MultiscanSlam::align_from(std::size_t first_free, std::size_t first_wide) {
  const auto matches = match_patches(graph_.multiscans, first_free, params_.matching);
  return align_multiscans(graph_, matches, first_free, first_wide, params_.alignment);
}

void MultiscanSlam::learn_odometry_scale(const std::vector<PatchMatch>& matches,
                                         std::size_t first_wide) {
  double least_surprise = std::numeric_limits<double>::max();
  double best = graph_.odometry_scale;
  for (const double factor : {1.0, 1.0 / kScaleStep, kScaleStep}) {
    MultiscanGraph tried = graph_;
    tried.odometry_scale = std::clamp(
        factor * graph_.odometry_scale, params_.least_odometry_scale, params_.most_odometry_scale);
    align_multiscans(tried, matches, 1, first_wide, params_.alignment);
    const double surprise =
        align_multiscans(tried, matches, 1, first_wide, params_.alignment).surprise;
    if (surprise < least_surprise) {
      least_surprise = surprise;
      best = tried.odometry_scale;
    }
  }
  graph_.odometry_scale = best;
}

Eigen::Matrix3d MultiscanSlam::covariance_after(const OdometryPiece& piece) const {
  const PlacedPatches& last = graph_.multiscans.back();
  const Eigen::Vector2d way_m =
      (last.T_map_begin * piece.T_before_after).position_m() - last.T_map_begin.position_m();
  Eigen::Matrix3d by_pose = Eigen::Matrix3d::Identity();
  by_pose.topRightCorner<2, 1>() << -way_m.y(), way_m.x();
  Eigen::Matrix3d covariance = by_pose * last.covariance * by_pose.transpose();
  covariance.diagonal() +=
      graph_.odometry_scale * graph_.odometry_scale * variances(piece, params_.alignment.odometry);
  return covariance;
}

geometry::Pose2 MultiscanSlam::T_map_robot(const TakenScan& taken) const {
  return graph_.multiscans[taken.multiscan].T_map_begin * taken.T_begin_robot;
}

localization::PoseGaussian MultiscanSlam::belief() const {
  if (scans_.empty()) {
    return {};
  }
  return {T_map_robot(scans_.back()), covariance_after(gathering_.piece())};
}

std::vector<geometry::Pose2> MultiscanSlam::trajectory() const {
  std::vector<geometry::Pose2> poses;
  poses.reserve(scans_.size());
  for (const TakenScan& taken : scans_) {
    poses.push_back(T_map_robot(taken));
  }
  return poses;
}

mapping::OccupancyGrid MultiscanSlam::grid() const {
  std::vector<PlacedScan> placed;
  placed.reserve(scans_.size());
  for (const TakenScan& taken : scans_) {
    placed.push_back({T_map_robot(taken), taken.scan});
  }
  return map_of_scans(placed, params_.map);
}

FactorGraph MultiscanSlam::factor_graph() const {
  return slam::factor_graph(graph_,
                            match_patches(graph_.multiscans, 1, params_.matching),
                            first_of_window(),
                            params_.alignment);
}

}  // namespace echomap::slam
