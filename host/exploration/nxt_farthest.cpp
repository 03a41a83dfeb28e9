// SPDX-License-Identifier: MIT
#include "host/exploration/nxt_farthest.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

namespace {

using geometry::Pose2;

void validate(const NxtFarthestParams& params) {
  geometry::ParameterValidator("nxt-farthest")
      .require(is_possible(params.sweep), "the sweep is impossible: check its range and its steps")
      .positive("robot_radius_m", params.robot_radius_m)
      .at_least("clearance_m", params.clearance_m, 0.0)
      .positive("min_drive_m", params.min_drive_m)
      .at_least("back_off_m", params.back_off_m, 0.0)
      .at_least("stop_spacing_m", params.stop_spacing_m, 0.0)
      .at_least("candidate_spread_rad", params.candidate_spread_rad, 0.0)
      .positive("candidates", params.candidates)
      .positive("drive_share", params.drive_share)
      .at_most("drive_share", params.drive_share, 1.0)
      .positive("max_stops", params.max_stops)
      .positive("stops_without_new_ground", params.stops_without_new_ground)
      .positive("scans", params.scans);
}

/// From the robot to the echoes of the last scan, the farthest first; of echoes less than
/// `spread_rad` apart only the farthest.
std::vector<Eigen::Vector2d> ways_farthest_first_m(const pipeline::Snapshot& snapshot,
                                                   double spread_rad) {
  std::vector<Eigen::Vector2d> offsets_m;
  for (const auto& reading : *snapshot.last_scan) {
    if (const auto echo_m = mapping::echo_point_m(reading)) {
      offsets_m.emplace_back(*echo_m - snapshot.latest.T_map_robot.position_m());
    }
  }
  std::stable_sort(offsets_m.begin(), offsets_m.end(), [](const auto& a, const auto& b) {
    return a.squaredNorm() > b.squaredNorm();
  });
  std::vector<Eigen::Vector2d> spread_m;
  for (const auto& offset_m : offsets_m) {
    const auto is_near = [&](const Eigen::Vector2d& other_m) {
      return std::acos(std::clamp(offset_m.normalized().dot(other_m.normalized()), -1.0, 1.0)) <
             spread_rad;
    };
    if (std::none_of(spread_m.begin(), spread_m.end(), is_near)) {
      spread_m.push_back(offset_m);
    }
  }
  return spread_m;
}

/// Brings one of the first `candidates` to the front. Plain multiplication instead of a standard
/// distribution, so that the choice repeats with any standard library.
void put_random_first(std::vector<Eigen::Vector2d>& offsets_m,
                      std::size_t candidates,
                      std::mt19937& random) {
  const std::uint64_t choices = std::min(candidates, offsets_m.size());
  const auto chosen = static_cast<std::ptrdiff_t>((random() * choices) >> 32U);
  std::rotate(offsets_m.begin(), offsets_m.begin() + chosen, offsets_m.begin() + chosen + 1);
}

/// How far a disc of `radius_m` can go along x until it touches the point.
double room_before_m(const Eigen::Vector2d& point_m, double radius_m) {
  if (point_m.x() <= 0.0 || std::abs(point_m.y()) >= radius_m) {
    return std::numeric_limits<double>::infinity();
  }
  return point_m.x() - std::sqrt(radius_m * radius_m - point_m.y() * point_m.y());
}

/// How far along the way, from under the body on, the map holds the floor rather free than not.
double known_floor_m(const mapping::OccupancyGrid& grid,
                     const Eigen::Vector2d& here_m,
                     const Eigen::Vector2d& offset_m,
                     double body_m) {
  constexpr double kEven = 0.5;
  const double length_m = offset_m.norm();
  const double step_m = 0.5 * grid.resolution_m();
  for (int i = 0; body_m + i * step_m < length_m; ++i) {
    const double at_m = body_m + i * step_m;
    const auto probability = grid.probability(grid.cell_at(here_m + at_m / length_m * offset_m));
    if (probability.value_or(1.0) >= kEven) {
      return at_m;
    }
  }
  return length_m;
}

/// From the poses, beginning with `first`.
bool is_apart(const Eigen::Vector2d& point_m,
              const std::vector<Pose2>& poses,
              std::size_t first,
              double spacing_m) {
  const auto begin = poses.begin() + static_cast<std::ptrdiff_t>(first);
  return std::none_of(begin, poses.end(), [&](const Pose2& pose) {
    return (pose.position_m() - point_m).norm() < spacing_m;
  });
}

}  // namespace

NxtFarthest::NxtFarthest(const NxtFarthestParams& params, std::mt19937& random)
    : params_(params), random_(random) {
  validate(params);
}

Motion NxtFarthest::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  note(last);
  if (plan_.empty()) {
    if (phase_ == Phase::kSensing) {
      plan_moving(snapshot);
    } else {
      plan_sensing(snapshot);
    }
  }
  Motion motion = plan_.front();
  plan_.pop_front();
  sweeping_ = std::holds_alternative<Sweep>(motion);
  return motion;
}

/// A move that failed is not finished: the robot backs off from what stopped it, and where nothing
/// did, or where a person had it, reads anew from where it stands.
void NxtFarthest::note(MotionResult last) {
  if (last == MotionResult::kTakenOver) {
    plan_.clear();
    phase_ = Phase::kMoving;
    return;
  }
  sweeps_done_ += sweeping_ && last == MotionResult::kReached ? 1 : 0;
  if (phase_ != Phase::kMoving || last == MotionResult::kReached) {
    return;
  }
  plan_.clear();
  if (last != MotionResult::kInterrupted) {
    phase_ = Phase::kBackingOff;
    plan_ = {Drive{-params_.back_off_m}};
  }
}

/// Section 3.1. The body turns towards the heading of the start, so that an error of the wheel
/// track does not add up over the stops.
void NxtFarthest::plan_sensing(const pipeline::Snapshot& snapshot) {
  phase_ = Phase::kSensing;
  sweeps_done_ = 0;
  plan_ = round_sweep(params_.sweep, snapshot.latest.T_map_robot.heading_rad() > 0.0);
}

/// Section 3.2: one of the farthest echoes at random, and half the way to it.
void NxtFarthest::plan_moving(const pipeline::Snapshot& snapshot) {
  phase_ = Phase::kMoving;
  if (const auto reason = reason_to_finish(snapshot)) {
    plan_.emplace_back(Finished{*reason});
    return;
  }
  const auto offset_m = choose_offset_m(snapshot);
  if (!offset_m) {
    plan_.emplace_back(Finished{FinishReason::kNowhereToGo});
    return;
  }
  // Both headings lie in (-pi, pi]. Their plain difference never turns through the back, so that an
  // error of the wheel track cannot add up turn after turn.
  const double bearing_rad = std::atan2(offset_m->y(), offset_m->x());
  plan_.emplace_back(Turn{bearing_rad - snapshot.latest.T_map_robot.heading_rad()});
  plan_.emplace_back(Drive{offset_m->norm()});
}

/// Where the chosen way is not free, or leads where the robot has been, the next farthest echo
/// takes its place; only where all lead there, one of them will do.
std::optional<Eigen::Vector2d> NxtFarthest::choose_offset_m(const pipeline::Snapshot& snapshot) {
  auto offsets_m = ways_farthest_first_m(snapshot, params_.candidate_spread_rad);
  if (offsets_m.empty()) {
    return std::nullopt;
  }
  put_random_first(offsets_m, params_.candidates, random_);
  for (auto& offset_m : offsets_m) {
    offset_m *= drivable_m(offset_m, snapshot) / offset_m.norm();
  }
  for (const double spacing_m : {params_.stop_spacing_m, 0.0}) {
    for (const auto& offset_m : offsets_m) {
      const Eigen::Vector2d goal_m = snapshot.latest.T_map_robot.position_m() + offset_m;
      if (offset_m.norm() >= params_.min_drive_m &&
          is_apart(goal_m, snapshot.points->poses(), first_pose_, spacing_m)) {
        return offset_m;
      }
    }
  }
  return std::nullopt;
}

std::optional<FinishReason> NxtFarthest::reason_to_finish(const pipeline::Snapshot& snapshot) {
  if (sweeps_done_ == 0) {
    return FinishReason::kCannotSense;
  }
  const auto reason = end_of_scan(snapshot);
  if (!reason || ++scans_done_ == params_.scans) {
    return reason;
  }
  if (scans_done_ == 1) {
    stops_of_first_scan_ = snapshot.stops;
    end_of_first_scan_ = *reason;
  }
  first_stop_ = snapshot.stops;
  first_pose_ = snapshot.points->poses().size();
  return std::nullopt;
}

std::optional<FinishReason> NxtFarthest::end_of_scan(const pipeline::Snapshot& snapshot) {
  if (scans_done_ > 0) {
    const bool is_over = snapshot.stops - first_stop_ >= stops_of_first_scan_;
    return is_over ? std::optional(end_of_first_scan_) : std::nullopt;
  }
  poor_stops_ = snapshot.newly_free_m2 < params_.new_ground_m2 ? poor_stops_ + 1 : 0;
  if (poor_stops_ >= params_.stops_without_new_ground) {
    return FinishReason::kNoNewGround;
  }
  if (snapshot.stops >= params_.max_stops) {
    return FinishReason::kStopLimit;
  }
  return std::nullopt;
}

/// Half the way, or as far as the body has room: before any echo of this scan, and over floor that
/// the map takes to be free.
double NxtFarthest::drivable_m(const Eigen::Vector2d& offset_m,
                               const pipeline::Snapshot& snapshot) const {
  const Eigen::Vector2d here_m = snapshot.latest.T_map_robot.position_m();
  const double body_m = params_.robot_radius_m + params_.clearance_m;
  double drivable_m = std::min(params_.drive_share * offset_m.norm(),
                               known_floor_m(*snapshot.grid, here_m, offset_m, body_m) - body_m);
  const Pose2 T_offset_map =
      Pose2(here_m.x(), here_m.y(), std::atan2(offset_m.y(), offset_m.x())).inverse();
  for (const auto& reading : *snapshot.last_scan) {
    if (const auto echo_m = mapping::echo_point_m(reading)) {
      drivable_m = std::min(drivable_m, room_before_m(T_offset_map * *echo_m, body_m));
    }
  }
  return std::max(0.0, drivable_m);
}

}  // namespace echomap::exploration
