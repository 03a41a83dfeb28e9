// SPDX-License-Identifier: MIT
#include "host/slam/multiscan_slam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "host/geometry/parameter_validator.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/multiscan_factors.hpp"

namespace echomap::slam {

namespace {

/// From one odometry scale to the next that is tried.
constexpr double kScaleStep = 1.5;

bool is_sound(const OdometryNoiseHypothesis& hypothesis) {
  return hypothesis.steady_scale > 0.0 && std::isfinite(hypothesis.steady_scale) &&
         hypothesis.min_scale > 0.0 && hypothesis.min_scale <= hypothesis.max_scale &&
         std::isfinite(hypothesis.max_scale);
}

}  // namespace

MultiscanSlam::MultiscanSlam(const MultiscanSlamParams& params)
    : params_(params), gathering_(params.gathering) {
  geometry::ParameterValidator("multiscan SLAM")
      .require(
          !params.noise_hypotheses.empty() &&
              std::all_of(params.noise_hypotheses.begin(), params.noise_hypotheses.end(), is_sound),
          "noise_hypotheses hold at least one, with scales and deviations above 0")
      .positive("belief_match_weight", params.belief_match_weight)
      .at_least("window", params.window, 2)
      .at_least("steps", params.steps, 1)
      .at_least("whole_share", params.whole_share, 0);
  validate(params.patches);
  validate(params.matching);
  validate(params.alignment);
  for (const OdometryNoiseHypothesis& hypothesis : params.noise_hypotheses) {
    MultiscanGraph& graph = graphs_.emplace_back();
    graph.multiscans.emplace_back();
    graph.odometry_scale = std::clamp(1.0, hypothesis.min_scale, hypothesis.max_scale);
    graph.steady_scale = hypothesis.steady_scale;
  }
}

void MultiscanSlam::begin_once(const geometry::Pose2& T_odom_robot) {
  if (!gathering_.has_begun()) {
    for (MultiscanGraph& graph : graphs_) {
      graph.multiscans.front().T_map_begin = T_odom_robot;
    }
  }
}

void MultiscanSlam::follow(const geometry::Pose2& T_odom_robot) {
  begin_once(T_odom_robot);
  gathering_.follow(T_odom_robot);
}

void MultiscanSlam::carry(const geometry::Pose2& T_odom_robot) {
  begin_once(T_odom_robot);
  gathering_.carry(T_odom_robot);
}

void MultiscanSlam::add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) {
  follow(T_odom_robot);
  if (const auto piece = gathering_.add(T_odom_robot, scan)) {
    begin_multiscan(*piece);
  }
  taken_.push_back({graph().pieces.size(), gathering_.piece().T_before_after});
}

void MultiscanSlam::begin_multiscan(const OdometryPiece& piece) {
  const auto patches = find_patches(gathering_.finished().echoes, params_.patches);
  for (MultiscanGraph& graph : graphs_) {
    graph.multiscans.back().patches = patches;
    const geometry::Pose2 T_map_begin =
        graph.multiscans.back().T_map_begin * calibrated(piece, graph.calibration);
    const Eigen::Matrix3d covariance = covariance_after(graph, piece);
    graph.pieces.push_back(piece);
    graph.multiscans.push_back({T_map_begin, {}, covariance});
  }
  align();
}

std::size_t MultiscanSlam::first_of_window() const {
  const std::size_t count = graph().multiscans.size();
  return count > params_.window ? count - params_.window : 1;
}

void MultiscanSlam::align() {
  const std::size_t count = graph().multiscans.size();
  const auto due = static_cast<std::size_t>(params_.whole_share * static_cast<double>(count));
  if (count >= aligned_whole_ + std::max<std::size_t>(1, due)) {
    align_whole();
    aligned_whole_ = count;
    return;
  }
  for (MultiscanGraph& graph : graphs_) {
    for (int step = 0; step < params_.steps; ++step) {
      const auto matches = match_patches(graph.multiscans, first_of_window(), params_.matching);
      align_multiscans(graph, matches, first_of_window(), first_of_window(), params_.alignment);
    }
  }
}

void MultiscanSlam::align_whole() {
  double min_negative_log_evidence = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < graphs_.size(); ++i) {
    MultiscanGraph& graph = graphs_[i];
    for (int step = 0; step < params_.steps; ++step) {
      const auto matches = match_patches(graph.multiscans, 1, params_.matching);
      if (step == 0) {
        learn_odometry_scale(params_.noise_hypotheses[i], matches, graph);
      }
      graph.multiscans.back().covariance =
          align_multiscans(graph, matches, 1, first_of_window(), params_.alignment).last_covariance;
    }
    const double negative_log_evidence = negative_log_evidence_of(graph);
    if (negative_log_evidence < min_negative_log_evidence) {
      min_negative_log_evidence = negative_log_evidence;
      best_ = i;
    }
  }
}

void MultiscanSlam::learn_odometry_scale(const OdometryNoiseHypothesis& hypothesis,
                                         const std::vector<PatchMatch>& matches,
                                         MultiscanGraph& graph) const {
  std::set<double> scales;
  for (const double factor : {1.0 / kScaleStep, 1.0, kScaleStep}) {
    scales.insert(
        std::clamp(factor * graph.odometry_scale, hypothesis.min_scale, hypothesis.max_scale));
  }
  if (scales.size() < 2) {
    return;
  }
  double min_negative_log_evidence = std::numeric_limits<double>::max();
  for (const double scale : scales) {
    MultiscanGraph tried = graph;
    tried.odometry_scale = scale;
    align_multiscans(tried, matches, 1, first_of_window(), params_.alignment);
    const double negative_log_evidence =
        align_multiscans(tried, matches, 1, first_of_window(), params_.alignment)
            .negative_log_evidence;
    if (negative_log_evidence < min_negative_log_evidence) {
      min_negative_log_evidence = negative_log_evidence;
      graph.odometry_scale = scale;
    }
  }
}

double MultiscanSlam::negative_log_evidence_of(MultiscanGraph graph) const {
  PatchMatchingParams narrow = params_.matching;
  narrow.max_place_stddev_m = 0.0;
  MultiscanAlignmentParams weighted = params_.alignment;
  weighted.match_weight = params_.belief_match_weight;
  const auto matches = match_patches(graph.multiscans, 1, narrow);
  return align_multiscans(graph, matches, 1, first_of_window(), weighted).negative_log_evidence;
}

Eigen::Matrix3d MultiscanSlam::covariance_after(const MultiscanGraph& graph,
                                                const OdometryPiece& piece) const {
  const PlacedPatches& last = graph.multiscans.back();
  const Eigen::Vector2d offset_m =
      (last.T_map_begin * piece.T_before_after).position_m() - last.T_map_begin.position_m();
  Eigen::Matrix3d jacobian_pose = Eigen::Matrix3d::Identity();
  jacobian_pose.topRightCorner<2, 1>() << -offset_m.y(), offset_m.x();
  Eigen::Matrix3d covariance = jacobian_pose * last.covariance * jacobian_pose.transpose();
  covariance.diagonal() +=
      graph.odometry_scale * graph.odometry_scale * variances(piece, params_.alignment.odometry);
  return covariance;
}

geometry::Pose2 MultiscanSlam::T_map_robot(const TakenScan& taken) const {
  return graph().multiscans[taken.multiscan].T_map_begin * taken.T_begin_robot;
}

localization::PoseGaussian MultiscanSlam::belief() const {
  if (taken_.empty()) {
    return {};
  }
  return {T_map_robot(taken_.back()), covariance_after(graph(), gathering_.piece())};
}

std::vector<geometry::Pose2> MultiscanSlam::trajectory() const {
  std::vector<geometry::Pose2> poses;
  poses.reserve(taken_.size());
  for (const TakenScan& taken : taken_) {
    poses.push_back(T_map_robot(taken));
  }
  return poses;
}

FactorGraph MultiscanSlam::factor_graph() const {
  return slam::factor_graph(graph(),
                            match_patches(graph().multiscans, 1, params_.matching),
                            first_of_window(),
                            params_.alignment);
}

}  // namespace echomap::slam
