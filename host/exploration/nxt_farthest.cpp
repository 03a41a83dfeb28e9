// SPDX-License-Identifier: MIT
#include "host/exploration/nxt_farthest.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {

namespace {

using geometry::Pose2;

constexpr double kFullTurnRad = 2.0 * std::numbers::pi;
/// Angles given in degrees are whole numbers of steps only up to rounding.
constexpr double kRoundingRad = 1e-9;

void check(const NxtFarthestParams& params) {
  const bool angles_ok = params.scan_rad >= kFullTurnRad - kRoundingRad && params.step_rad > 0.0 &&
                         params.pan_range_rad >= params.step_rad;
  const bool lengths_ok = params.robot_radius_m > 0.0 && params.clearance_m >= 0.0 &&
                          params.least_drive_m > 0.0 && params.back_off_m >= 0.0;
  const bool choice_ok = params.candidates > 0 && params.drive_share > 0.0 &&
                         params.drive_share <= 1.0 && params.most_stops > 0 &&
                         params.stops_without_new_ground > 0 && params.settle_s >= 0.0;
  if (!angles_ok || !lengths_ok || !choice_ok) {
    throw std::invalid_argument("nxt-farthest: a parameter is outside of its range");
  }
}

/// Echo points of a scan, the farthest first.
std::vector<Eigen::Vector2d> farthest_first(const mapping::Scan& scan) {
  mapping::Scan echoes;
  std::copy_if(scan.begin(), scan.end(), std::back_inserter(echoes), [](const auto& reading) {
    return reading.range_m.has_value();
  });
  std::stable_sort(echoes.begin(), echoes.end(), [](const auto& a, const auto& b) {
    return *a.range_m > *b.range_m;
  });
  std::vector<Eigen::Vector2d> points_m;
  for (const auto& echo : echoes) {
    points_m.push_back(*mapping::echo_point_m(echo));
  }
  return points_m;
}

/// Brings one of the first `candidates` to the front. Plain multiplication instead of a standard
/// distribution, so that the choice repeats with any standard library.
void put_random_first(std::vector<Eigen::Vector2d>& points_m,
                      std::size_t candidates,
                      std::mt19937& random) {
  const std::uint64_t choices = std::min(candidates, points_m.size());
  const auto chosen = static_cast<std::ptrdiff_t>((random() * choices) >> 32U);
  std::rotate(points_m.begin(), points_m.begin() + chosen, points_m.begin() + chosen + 1);
}

/// How far a disc of `radius_m` can go along x until it touches the point.
double free_way_m(const Eigen::Vector2d& point_m, double radius_m) {
  if (point_m.x() <= 0.0 || std::abs(point_m.y()) >= radius_m) {
    return std::numeric_limits<double>::infinity();
  }
  return std::max(0.0, point_m.x() - std::sqrt(radius_m * radius_m - point_m.y() * point_m.y()));
}

double bearing_rad(const Pose2& T_map_robot, const Eigen::Vector2d& target_m) {
  const Eigen::Vector2d way = target_m - T_map_robot.position_m();
  return std::atan2(way.y(), way.x());
}

}  // namespace

NxtFarthest::NxtFarthest(const NxtFarthestParams& params, std::mt19937& random)
    : params_(params), random_(random) {
  check(params);
}

Motion NxtFarthest::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (phase_ == Phase::kMoving && last != MotionResult::kReached) {
    plan_.clear();
    plan_back_off();
  }
  if (plan_.empty()) {
    if (phase_ == Phase::kMoving) {
      plan_sensing(snapshot);
    } else {
      plan_moving(snapshot);
    }
  }
  Motion motion = plan_.front();
  plan_.pop_front();
  return motion;
}

/// Section 3.1. Sweeps to and fro, with turns of the body between them where the pan does not go
/// all the way round. The turns go back the way they came, so that an error of the wheel track
/// cancels, and begin towards the heading of the start.
void NxtFarthest::plan_sensing(const pipeline::Snapshot& snapshot) {
  phase_ = Phase::kSensing;
  const auto sectors =
      static_cast<int>(std::ceil(kFullTurnRad / params_.pan_range_rad - kRoundingRad));
  const auto rounds = static_cast<int>(std::lround(params_.scan_rad / kFullTurnRad));
  const double sector_rad = kFullTurnRad / sectors;
  const double first_rad = -sector_rad / 2.0;
  const double last_rad = sector_rad / 2.0 - params_.step_rad;
  double turn_rad = snapshot.latest.T_map_robot.heading_rad() > 0.0 ? -sector_rad : sector_rad;

  plan_.emplace_back(BeginScan{});
  for (int round = 0; round < rounds; ++round) {
    for (int sector = 0; sector < sectors; ++sector) {
      if (sector > 0) {
        plan_.emplace_back(Turn{turn_rad});
      }
      plan_.emplace_back(Sweep{first_rad, last_rad, params_.step_rad, params_.settle_s});
    }
    turn_rad = -turn_rad;
  }
  plan_.emplace_back(EndScan{});
}

/// Section 3.2: one of the farthest echoes at random, half the way. Where the way there is not
/// free, the next farthest takes its place.
void NxtFarthest::plan_moving(const pipeline::Snapshot& snapshot) {
  phase_ = Phase::kMoving;
  if (const auto reason = reason_to_finish(snapshot)) {
    plan_.emplace_back(Finished{*reason});
    return;
  }
  auto targets_m = farthest_first(*snapshot.last_scan);
  if (!targets_m.empty()) {
    put_random_first(targets_m, params_.candidates, random_);
  }
  for (const Eigen::Vector2d& target_m : targets_m) {
    const double distance_m = drive_towards_m(target_m, snapshot);
    if (distance_m >= params_.least_drive_m) {
      const Pose2& T_map_robot = snapshot.latest.T_map_robot;
      // Both headings lie in (-pi, pi]. Their plain difference never turns through the back, so an
      // error of the wheel track cannot add up turn after turn.
      plan_.emplace_back(Turn{bearing_rad(T_map_robot, target_m) - T_map_robot.heading_rad()});
      plan_.emplace_back(Drive{distance_m});
      return;
    }
  }
  plan_.emplace_back(Finished{FinishReason::kNowhereToGo});
}

void NxtFarthest::plan_back_off() { plan_.emplace_back(Drive{-params_.back_off_m}); }

std::optional<FinishReason> NxtFarthest::reason_to_finish(const pipeline::Snapshot& snapshot) {
  poor_stops_ = snapshot.newly_free_m2 < params_.new_ground_m2 ? poor_stops_ + 1 : 0;
  if (poor_stops_ >= params_.stops_without_new_ground) {
    return FinishReason::kNoNewGround;
  }
  if (snapshot.stops >= params_.most_stops) {
    return FinishReason::kStopLimit;
  }
  return std::nullopt;
}

double NxtFarthest::drive_towards_m(const Eigen::Vector2d& target_m,
                                    const pipeline::Snapshot& snapshot) const {
  const Pose2& T_map_robot = snapshot.latest.T_map_robot;
  const Pose2 T_facing_map =
      Pose2(T_map_robot.x_m(), T_map_robot.y_m(), bearing_rad(T_map_robot, target_m)).inverse();
  double distance_m = params_.drive_share * (target_m - T_map_robot.position_m()).norm();
  for (const auto& reading : *snapshot.last_scan) {
    if (const auto echo_m = mapping::echo_point_m(reading)) {
      const double radius_m = params_.robot_radius_m + params_.clearance_m;
      distance_m = std::min(distance_m, free_way_m(T_facing_map * *echo_m, radius_m));
    }
  }
  return distance_m;
}

}  // namespace echomap::exploration
