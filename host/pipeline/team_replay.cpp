// SPDX-License-Identifier: MIT
#include "host/pipeline/team_replay.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"

namespace echomap::pipeline {

namespace {

using geometry::square;
using localization::EkfOutcome;

void validate(const TeamReplayParams& params) {
  geometry::ParameterValidator("team replay")
      .positive("range_stddev_m", params.range_stddev_m)
      .nonnegative_finite("range_stddev_share", params.range_stddev_share)
      .positive("bearing_stddev_rad", params.bearing_stddev_rad)
      .nonnegative_finite("offset_stddev_m", params.offset_stddev_m)
      .positive("start_stddev_m", params.start_stddev_m)
      .positive("start_stddev_rad", params.start_stddev_rad)
      .nonnegative_finite("max_start_age_s", params.max_start_age_s);
}

}  // namespace

TeamReplay::TeamReplay(std::map<std::int64_t, Eigen::Vector2d> landmarks_m,
                       const TeamReplayParams& params)
    : landmarks_m_(std::move(landmarks_m)), params_(params), localizer_(params.localizer) {
  validate(params);
}

void TeamReplay::play(const datasets::TeamRecord& record) {
  Member& member = members_[record.robot];
  if (const auto* step = std::get_if<datasets::OdometryStep>(&record.record)) {
    move(member, record.stamp_s, step->T_last_now);
  } else if (const auto* seen = std::get_if<datasets::LandmarkSighting>(&record.record)) {
    see(member, record.robot, record.stamp_s, *seen);
  } else if (!member.index) {
    member.given = record;
  }
}

const std::vector<StampedBelief>& TeamReplay::track(std::int64_t robot) const {
  static const std::vector<StampedBelief> kNone;
  const auto member = members_.find(robot);
  return member == members_.end() ? kNone : member->second.track;
}

SightingCounts TeamReplay::counts(std::int64_t robot) const {
  const auto member = members_.find(robot);
  return member == members_.end() ? SightingCounts() : member->second.counts;
}

std::size_t TeamReplay::times_lost(std::int64_t robot) const {
  const auto member = members_.find(robot);
  const bool has_started = member != members_.end() && member->second.index;
  return has_started ? localizer_.times_lost(*member->second.index) : 0;
}

void TeamReplay::move(Member& member, double stamp_s, const geometry::Pose2& T_last_now) {
  if (!member.index) {
    start(member, stamp_s);
  } else if (localizer_.move(*member.index, stamp_s, T_last_now) != EkfOutcome::kApplied) {
    return;
  }
  if (member.index) {
    member.track.push_back({time::robot_time(stamp_s), localizer_.belief(*member.index)});
  }
}

void TeamReplay::start(Member& member, double stamp_s) {
  if (!member.given || stamp_s - member.given->stamp_s > params_.max_start_age_s) {
    return;
  }
  const Eigen::Vector3d variance(square(params_.start_stddev_m),
                                 square(params_.start_stddev_m),
                                 square(params_.start_stddev_rad));
  const auto& given = std::get<datasets::GivenPose>(member.given->record);
  member.index =
      localizer_.add_robot(stamp_s, {given.T_map_robot, variance.asDiagonal().toDenseMatrix()});
}

void TeamReplay::see(Member& member,
                     std::int64_t robot,
                     double stamp_s,
                     const datasets::LandmarkSighting& seen) {
  if (!member.index) {
    return;
  }
  const double range_stddev_m =
      std::hypot(params_.range_stddev_m, params_.range_stddev_share * seen.range_m);
  const double bearing_stddev_rad =
      std::hypot(params_.bearing_stddev_rad, params_.offset_stddev_m / seen.range_m);
  if (const auto landmark = landmarks_m_.find(seen.id); landmark != landmarks_m_.end()) {
    if (params_.blind.contains(robot)) {
      return;
    }
    const auto outcome = localizer_.see_landmark(*member.index,
                                                 seen.id,
                                                 {stamp_s,
                                                  landmark->second,
                                                  {},
                                                  seen.range_m,
                                                  seen.bearing_rad,
                                                  range_stddev_m,
                                                  bearing_stddev_rad});
    member.counts.landmarks += outcome == EkfOutcome::kApplied ? 1 : 0;
    member.counts.gated += outcome == EkfOutcome::kGated ? 1 : 0;
    return;
  }
  const auto peer = members_.find(seen.id);
  if (peer == members_.end() || !peer->second.index || seen.id == robot) {
    ++member.counts.unknown;
    return;
  }
  if (!params_.with_peers) {
    return;
  }
  const auto outcome = localizer_.see_peer(
      *member.index,
      *peer->second.index,
      {stamp_s, seen.range_m, seen.bearing_rad, range_stddev_m, bearing_stddev_rad});
  member.counts.peers += outcome == EkfOutcome::kApplied ? 1 : 0;
  member.counts.gated += outcome == EkfOutcome::kGated ? 1 : 0;
}

}  // namespace echomap::pipeline
