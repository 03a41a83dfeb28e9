// SPDX-License-Identifier: MIT
#include "host/slam/loop_closing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "host/geometry/parameter_validator.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

using geometry::Pose2;

namespace {

/// Places are looked for within so many times the drift that is expected, its standard deviation,
/// to each side.
constexpr double kSearchedDrifts = 2.0;

void append(const std::vector<Eigen::Vector2d>& added_m, std::vector<Eigen::Vector2d>& points_m) {
  points_m.insert(points_m.end(), added_m.begin(), added_m.end());
}

}  // namespace

LoopClosing::LoopClosing(const LoopClosingParams& params,
                         const LoopSearchParams& search,
                         const ScanMatchingParams& matching,
                         const SurfaceFieldParams& field)
    : params_(params), search_(search), matcher_(matching), field_(field) {
  geometry::ParameterValidator("loop closing")
      .positive("min_travelled_m", params.min_travelled_m)
      .positive("drift_m", params.drift_m)
      .positive("patch_m", params.patch_m);
}

std::vector<PoseEdge> LoopClosing::close(const KeyFrames& frames) {
  const std::size_t newest = frames.size() - 1;
  if (waiting_ && newest - waiting_->to > params_.agreement_frames) {
    waiting_.reset();
  }
  const std::vector<NearFrame> reached =
      frames.near(newest, std::numeric_limits<double>::infinity());
  const auto place = candidate(frames, reached);
  if (!place) {
    return {};
  }
  const auto loop = matched(frames, reached, *place);
  if (!loop) {
    return {};
  }
  if (!is_searched(*place)) {
    return {*loop};
  }
  if (!waiting_ || !agree(frames, *waiting_, *loop)) {
    waiting_ = loop;
    return {};
  }
  std::vector<PoseEdge> proved{*waiting_, *loop};
  waiting_.reset();
  return proved;
}

std::optional<LoopClosing::Candidate> LoopClosing::candidate(
    const KeyFrames& frames, const std::vector<NearFrame>& reached) const {
  const Eigen::Vector2d here_m = frames.T_map_frame(frames.size() - 1).position_m();
  std::optional<Candidate> nearest;
  double min_m = std::numeric_limits<double>::infinity();
  for (const NearFrame& frame : reached) {
    if (frame.travelled_m < params_.min_travelled_m) {
      continue;
    }
    const double away_m = (frames.T_map_frame(frame.frame).position_m() - here_m).norm();
    const double drift_m =
        std::min(params_.max_drift_m, params_.drift_m + params_.drift_m_per_m * frame.travelled_m);
    if (away_m < params_.sight_m + kSearchedDrifts * drift_m && away_m < min_m) {
      min_m = away_m;
      nearest = {frame.frame,
                 drift_m,
                 std::min(params_.max_drift_rad,
                          params_.drift_rad + params_.drift_rad_per_m * frame.travelled_m)};
    }
  }
  return nearest;
}

bool LoopClosing::is_searched(const Candidate& candidate) const {
  return candidate.drift_m > params_.near_m;
}

std::optional<PoseEdge> LoopClosing::matched(const KeyFrames& frames,
                                             const std::vector<NearFrame>& reached,
                                             const Candidate& candidate) {
  const std::size_t newest = frames.size() - 1;
  const Pose2& T_map_newest = frames.T_map_frame(newest);
  const auto points_m = newest_patch_m(frames, reached);
  const auto old_frames = old_patch(frames, reached, candidate.frame);
  std::vector<Eigen::Vector2d> map_points_m;
  for (const std::size_t old : old_frames) {
    append(frames.map_points_m(old), map_points_m);
  }
  const auto start = start_of_match(map_points_m, points_m, {T_map_newest, candidate});
  if (!start) {
    return std::nullopt;
  }
  field_.clear();
  field_.add(map_points_m);
  const ScanMatch match = matcher_.match(points_m, *start, field_);
  if (match.share < params_.min_share || (is_searched(candidate) && !is_determined(match)) ||
      !is_within_drift(T_map_newest.inverse() * match.T_map_robot, candidate) ||
      !is_seen_alike(frames, old_frames, match.T_map_robot)) {
    return std::nullopt;
  }
  return PoseEdge{
      candidate.frame,
      newest,
      frames.T_map_frame(candidate.frame).inverse() * match.T_map_robot,
      with_spread(
          in_frame_of(match.T_map_robot, match.information), params_.spread_m, params_.spread_rad),
      true};
}

std::vector<Eigen::Vector2d> LoopClosing::newest_patch_m(
    const KeyFrames& frames, const std::vector<NearFrame>& reached) const {
  const Pose2 T_newest_map = frames.T_map_frame(frames.size() - 1).inverse();
  std::vector<Eigen::Vector2d> points_m;
  for (const NearFrame& frame : reached) {
    if (frame.travelled_m < params_.patch_m) {
      append(sensors::in_frame_a_m(T_newest_map * frames.T_map_frame(frame.frame),
                                   frames.frame(frame.frame).points_m),
             points_m);
    }
  }
  return points_m;
}

std::vector<std::size_t> LoopClosing::old_patch(const KeyFrames& frames,
                                                const std::vector<NearFrame>& reached,
                                                std::size_t middle) const {
  std::vector<bool> is_recent(frames.size(), false);
  for (const NearFrame& frame : reached) {
    is_recent[frame.frame] = frame.travelled_m < params_.min_travelled_m;
  }
  std::vector<std::size_t> old;
  for (const NearFrame& frame : frames.near(middle, params_.patch_m)) {
    if (!is_recent[frame.frame]) {
      old.push_back(frame.frame);
    }
  }
  return old;
}

std::optional<localization::PoseGaussian> LoopClosing::start_of_match(
    const std::vector<Eigen::Vector2d>& map_points_m,
    const std::vector<Eigen::Vector2d>& points_m,
    const Expected& expected) {
  const auto& [T_map_newest, candidate] = expected;
  localization::PoseGaussian start{T_map_newest, Eigen::Matrix3d::Zero()};
  start.covariance.diagonal() << candidate.drift_m * candidate.drift_m,
      candidate.drift_m * candidate.drift_m, candidate.drift_rad * candidate.drift_rad;
  if (is_searched(candidate)) {
    const auto found = search_.find(
        map_points_m,
        points_m,
        {T_map_newest, kSearchedDrifts * candidate.drift_m, kSearchedDrifts * candidate.drift_rad});
    if (!found) {
      return std::nullopt;
    }
    start.T_map_robot = found->T_map_robot;
  }
  return start;
}

bool LoopClosing::is_determined(const ScanMatch& match) const {
  const Eigen::Vector2d along =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(match.information.topLeftCorner<2, 2>())
          .eigenvalues();
  return along[0] >= params_.min_determined * along[1];
}

bool LoopClosing::is_within_drift(const Pose2& T_newest_matched, const Candidate& candidate) {
  // A search looks in a square; a match may go on a little.
  constexpr double kMaxDrifts = 1.5 * kSearchedDrifts;
  return T_newest_matched.position_m().norm() <= kMaxDrifts * candidate.drift_m &&
         std::abs(T_newest_matched.heading_rad()) <= kMaxDrifts * candidate.drift_rad;
}

bool LoopClosing::is_seen_alike(const KeyFrames& frames,
                                const std::vector<std::size_t>& old_frames,
                                const Pose2& T_map_newest) const {
  const KeyFrame& newest = frames.frame(frames.size() - 1);
  ViewAgreement views;
  for (const std::size_t number : old_frames) {
    const Pose2 T_newest_old = T_map_newest.inverse() * frames.T_map_frame(number);
    const KeyFrame& old = frames.frame(number);
    views += look(newest, T_newest_old, old.points_m);
    views += look(old, T_newest_old.inverse(), newest.points_m);
  }
  return views.met >= params_.min_met && views.contradicted_share() <= params_.max_contradicted;
}

ViewAgreement LoopClosing::look(const KeyFrame& from,
                                const Pose2& T_from_points,
                                const std::vector<Eigen::Vector2d>& points_m) const {
  ViewAgreement views;
  for (const FrameScan& scan : from.scans) {
    views +=
        view_agreement(scan.scan,
                       sensors::in_frame_a_m(scan.T_key_robot.inverse() * T_from_points, points_m),
                       params_.view_margin_m);
  }
  return views;
}

bool LoopClosing::agree(const KeyFrames& frames, const PoseEdge& one, const PoseEdge& other) const {
  const Pose2 T_map_by_other = frames.T_map_frame(other.from) * other.T_from_to;
  const Pose2 T_map_by_one = frames.T_map_frame(one.from) * one.T_from_to *
                             frames.T_map_frame(one.to).inverse() * frames.T_map_frame(other.to);
  const Pose2 difference = T_map_by_one.inverse() * T_map_by_other;
  return difference.position_m().norm() <= params_.agreement_m &&
         std::abs(difference.heading_rad()) <= params_.agreement_rad;
}

}  // namespace echomap::slam
