// SPDX-License-Identifier: MIT
#include "host/exploration/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/exploration/unwinding_turn.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"

namespace echomap::exploration {

namespace {

/// The share of the way from `a` to `b` at which it is nearest to a point.
double share_nearest(const Eigen::Vector2d& a,
                     const Eigen::Vector2d& b,
                     const Eigen::Vector2d& point_m) {
  const double length_m2 = (b - a).squaredNorm();
  return length_m2 == 0.0 ? 1.0 : std::clamp((point_m - a).dot(b - a) / length_m2, 0.0, 1.0);
}

}  // namespace

std::size_t max_motions(double path_m, const PathFollowerParams& params) {
  constexpr double kTurns = 20.0;
  return static_cast<std::size_t>(kTurns +
                                  2.0 * path_m / (params.min_speed_m_per_s * params.roll_s));
}

PathFollower::PathFollower(const PathFollowerParams& params) : params_(params) {
  geometry::ParameterValidator("path follower")
      .positive("min_speed_m_per_s", params.min_speed_m_per_s)
      .at_least("speed_m_per_s", params.speed_m_per_s, params.min_speed_m_per_s)
      .positive("braking_m_per_s2", params.braking_m_per_s2)
      .above("look_ahead_m", params.look_ahead_m, params.arrived_m)
      .positive("arrived_m", params.arrived_m)
      .positive("turn_on_spot_rad", params.turn_on_spot_rad)
      .positive("roll_s", params.roll_s);
}

void PathFollower::follow(std::vector<Eigen::Vector2d> path_m) {
  path_m_ = std::move(path_m);
  piece_ = 0;
}

std::optional<Motion> PathFollower::next(const geometry::Pose2& T_map_robot, const CostGrid& grid) {
  const Eigen::Vector2d& here_m = T_map_robot.position_m();
  if (path_m_.empty() || (path_m_.back() - here_m).norm() <= params_.arrived_m) {
    path_m_.clear();
    return std::nullopt;
  }
  const Eigen::Vector2d ahead_m = T_map_robot.inverse() * target_m(here_m);
  const double off_rad = std::atan2(ahead_m.y(), ahead_m.x());
  if (std::abs(off_rad) > params_.turn_on_spot_rad) {
    const double heading_rad = T_map_robot.heading_rad();
    return Turn{unwinding_turn_rad(heading_rad, geometry::wrap_angle(heading_rad + off_rad))};
  }
  const double speed_m_per_s = this->speed_m_per_s(here_m, grid);
  const double curvature_per_m = 2.0 * ahead_m.y() / ahead_m.squaredNorm();
  const double to_go_m = (path_m_.back() - here_m).norm();
  return Roll{speed_m_per_s,
              speed_m_per_s * curvature_per_m,
              std::min(params_.roll_s, to_go_m / speed_m_per_s)};
}

/// On the way, `look_ahead_m` of it beyond the point nearest to the robot.
Eigen::Vector2d PathFollower::target_m(const Eigen::Vector2d& here_m) {
  while (piece_ + 2 < path_m_.size() &&
         share_nearest(path_m_[piece_], path_m_[piece_ + 1], here_m) >= 1.0) {
    ++piece_;
  }
  if (path_m_.size() == 1) {
    return path_m_.front();
  }
  const double share = share_nearest(path_m_[piece_], path_m_[piece_ + 1], here_m);
  Eigen::Vector2d at_m = path_m_[piece_] + share * (path_m_[piece_ + 1] - path_m_[piece_]);
  double ahead_m = params_.look_ahead_m;
  for (std::size_t i = piece_ + 1; i < path_m_.size(); ++i) {
    const Eigen::Vector2d rest_m = path_m_[i] - at_m;
    if (rest_m.norm() >= ahead_m) {
      return at_m + ahead_m / rest_m.norm() * rest_m;
    }
    ahead_m -= rest_m.norm();
    at_m = path_m_[i];
  }
  return at_m;
}

double PathFollower::speed_m_per_s(const Eigen::Vector2d& here_m, const CostGrid& grid) const {
  const geometry::CellIndex cell = grid.cell_at(here_m);
  const double price = grid.is_open(cell)
                           ? static_cast<double>(grid.costs()[grid.index(cell)]) / CostGrid::kPlain
                           : params_.speed_m_per_s / params_.min_speed_m_per_s;
  const double to_go_m = (path_m_.back() - here_m).norm();
  const double stoppable_m_per_s = std::sqrt(2.0 * params_.braking_m_per_s2 * to_go_m);
  return std::max(params_.min_speed_m_per_s,
                  std::min(params_.speed_m_per_s / price, stoppable_m_per_s));
}

}  // namespace echomap::exploration
