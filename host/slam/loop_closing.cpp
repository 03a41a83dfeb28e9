// SPDX-License-Identifier: MIT
#include "host/slam/loop_closing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace echomap::slam {

using geometry::Pose2;

LoopClosing::LoopClosing(const LoopClosingParams& params,
                         const LoopSearchParams& search,
                         const ScanMatchingParams& matching,
                         const SurfaceFieldParams& field)
    : params_(params), search_(search), matcher_(matching), field_(field) {
  if (!(params.least_way_m > 0.0) || !(params.drift_m > 0.0) || !(params.patch_m > 0.0)) {
    throw std::invalid_argument("loop closing: way, drift and patch are above 0");
  }
}

std::vector<PoseEdge> LoopClosing::close(const KeyFrames& frames) {
  const std::vector<NearFrame> reached =
      frames.near(frames.size() - 1, std::numeric_limits<double>::infinity());
  const auto place = candidate(frames, reached);
  if (!place) {
    return {};
  }
  const auto loop = matched(frames, reached, *place);
  if (!loop) {
    return {};
  }
  if (loop->drift_m <= params_.near_m) {
    return {loop->edge};
  }
  std::vector<PoseEdge> proved;
  if (pending_ && agree(*pending_, *loop)) {
    proved = {pending_->edge, loop->edge};
    pending_.reset();
  } else {
    pending_ = loop;
  }
  return proved;
}

std::optional<LoopClosing::Candidate> LoopClosing::candidate(
    const KeyFrames& frames, const std::vector<NearFrame>& reached) const {
  const Eigen::Vector2d here_m = frames.T_map_frame(frames.size() - 1).position_m();
  std::optional<Candidate> nearest;
  double least_m = std::numeric_limits<double>::infinity();
  for (const NearFrame& frame : reached) {
    if (frame.way_m < params_.least_way_m) {
      continue;
    }
    const double away_m = (frames.T_map_frame(frame.frame).position_m() - here_m).norm();
    const double drift_m =
        std::min(params_.most_drift_m, params_.drift_m + params_.drift_m_per_m * frame.way_m);
    if (away_m < params_.sight_m + drift_m && away_m < least_m) {
      least_m = away_m;
      nearest = {frame.frame,
                 drift_m,
                 std::min(params_.most_drift_rad,
                          params_.drift_rad + params_.drift_rad_per_m * frame.way_m)};
    }
  }
  return nearest;
}

std::optional<LoopClosing::Loop> LoopClosing::matched(const KeyFrames& frames,
                                                      const std::vector<NearFrame>& reached,
                                                      const Candidate& candidate) {
  const std::size_t newest = frames.size() - 1;
  const Pose2& T_map_newest = frames.T_map_frame(newest);
  std::vector<bool> is_recent(frames.size(), false);
  std::vector<Eigen::Vector2d> points_m;
  for (const NearFrame& frame : reached) {
    is_recent[frame.frame] = frame.way_m < params_.least_way_m;
    if (frame.way_m < params_.patch_m) {
      const auto added_m = in_frame_a_m(T_map_newest.inverse() * frames.T_map_frame(frame.frame),
                                        frames.frame(frame.frame).points_m);
      points_m.insert(points_m.end(), added_m.begin(), added_m.end());
    }
  }
  std::vector<std::size_t> old_frames;
  std::vector<Eigen::Vector2d> map_points_m;
  for (const NearFrame& frame : frames.near(candidate.frame, params_.patch_m)) {
    if (!is_recent[frame.frame]) {
      old_frames.push_back(frame.frame);
      const auto added_m = frames.map_points_m(frame.frame);
      map_points_m.insert(map_points_m.end(), added_m.begin(), added_m.end());
    }
  }
  field_.clear();
  field_.add(map_points_m);
  localization::PoseGaussian start{T_map_newest, Eigen::Matrix3d::Zero()};
  start.covariance.diagonal() << candidate.drift_m * candidate.drift_m,
      candidate.drift_m * candidate.drift_m, candidate.drift_rad * candidate.drift_rad;
  if (candidate.drift_m > params_.near_m) {
    const auto found = search_.find(
        map_points_m, points_m, {T_map_newest, 2.0 * candidate.drift_m, 2.0 * candidate.drift_rad});
    if (!found) {
      return std::nullopt;
    }
    start.T_map_robot = found->T_map_robot;
  }
  const ScanMatch match = matcher_.match(points_m, start, field_);
  const ViewAgreement views = agreement(frames, newest, old_frames, match.T_map_robot);
  if (match.share < params_.least_share || views.met < params_.least_met ||
      views.contradicted_share() > params_.most_contradicted) {
    return std::nullopt;
  }
  const Pose2& T_map_old = frames.T_map_frame(candidate.frame);
  return Loop{
      {candidate.frame,
       newest,
       T_map_old.inverse() * match.T_map_robot,
       with_spread(
           in_frame_of(match.T_map_robot, match.information), params_.spread_m, params_.spread_rad),
       true},
      match.T_map_robot,
      match.T_map_robot * T_map_newest.inverse(),
      candidate.drift_m};
}

ViewAgreement LoopClosing::agreement(const KeyFrames& frames,
                                     std::size_t newest,
                                     const std::vector<std::size_t>& old_frames,
                                     const Pose2& T_map_newest) const {
  ViewAgreement views;
  const auto look = [&](const KeyFrame& from,
                        const Pose2& T_map_from,
                        const KeyFrame& at,
                        const Pose2& T_map_at) {
    for (const PlacedScan& scan : from.scans) {
      const Pose2 T_robot_at = (T_map_from * scan.T_key_robot).inverse() * T_map_at;
      const auto points_m = in_frame_a_m(T_robot_at, at.points_m);
      views += view_agreement(scan.scan, points_m, params_.view_margin_m);
    }
  };
  for (const std::size_t old : old_frames) {
    look(frames.frame(newest), T_map_newest, frames.frame(old), frames.T_map_frame(old));
    look(frames.frame(old), frames.T_map_frame(old), frames.frame(newest), T_map_newest);
  }
  return views;
}

bool LoopClosing::agree(const Loop& one, const Loop& other) const {
  const Pose2 T_map_by_one = one.T_map_moved * other.T_map_moved.inverse() * other.T_map_newest;
  const Pose2 difference = T_map_by_one.inverse() * other.T_map_newest;
  return other.edge.to - one.edge.to <= params_.agreement_frames &&
         difference.position_m().norm() <= params_.agreement_m &&
         std::abs(difference.heading_rad()) <= params_.agreement_rad;
}

}  // namespace echomap::slam
