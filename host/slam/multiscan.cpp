// SPDX-License-Identifier: MIT
#include "host/slam/multiscan.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

MultiscanGathering::MultiscanGathering(const MultiscanParams& params) : params_(params) {
  geometry::ParameterValidator("multiscan")
      .positive_finite("max_path_m", params.max_path_m)
      .positive_finite("max_turned_rad", params.max_turned_rad)
      .positive_finite("max_range_m", params.max_range_m)
      .positive_finite("jump_m", params.jump_m)
      .positive_finite("jump_rad", params.jump_rad)
      .positive("max_echoes", params.max_echoes);
}

std::optional<OdometryPiece> MultiscanGathering::add(const geometry::Pose2& T_odom_robot,
                                                     const sensors::RangeScan& scan) {
  follow(T_odom_robot);
  std::optional<OdometryPiece> piece;
  const bool has_jumped = piece_.jumped_m > 0.0 || piece_.jumped_rad > 0.0;
  if (piece_.path_m >= params_.max_path_m || piece_.turned_rad >= params_.max_turned_rad ||
      has_jumped) {
    piece = std::exchange(piece_, {});
    finished_ = std::exchange(open_, {T_odom_robot, {}});
    taken_every_ = 1;
    answers_ = 0;
  }
  gather(scan);
  return piece;
}

void MultiscanGathering::follow(const geometry::Pose2& T_odom_robot) {
  step_to(T_odom_robot, false);
}

void MultiscanGathering::carry(const geometry::Pose2& T_odom_robot) { step_to(T_odom_robot, true); }

void MultiscanGathering::step_to(const geometry::Pose2& T_odom_robot, bool is_carried) {
  if (!T_odom_last_) {
    open_.T_odom_begin = T_odom_robot;
    T_odom_last_ = T_odom_robot;
    return;
  }
  const geometry::Pose2 T_last_robot = T_odom_last_->inverse() * T_odom_robot;
  const double travelled_m = T_last_robot.position_m().norm();
  const double turn_rad = T_last_robot.heading_rad();
  if (is_carried) {
    piece_.jumped_m += std::max(travelled_m, params_.jump_m);
    piece_.jumped_rad += std::max(std::abs(turn_rad), params_.jump_rad);
  } else if (travelled_m > params_.jump_m || std::abs(turn_rad) > params_.jump_rad) {
    piece_.jumped_m += travelled_m;
    piece_.jumped_rad += std::abs(turn_rad);
  } else {
    piece_.path_m += travelled_m;
    piece_.turn_rad += turn_rad;
    piece_.turned_rad += std::abs(turn_rad);
  }
  piece_.T_before_after = open_.T_odom_begin.inverse() * T_odom_robot;
  T_odom_last_ = T_odom_robot;
}

void MultiscanGathering::gather(const sensors::RangeScan& scan) {
  const geometry::Pose2 T_begin_sensor = piece_.T_before_after * scan.T_robot_sensor;
  for (const sensors::Beam& beam : scan.beams) {
    if (!beam.range_m || *beam.range_m > params_.max_range_m) {
      continue;
    }
    if (answers_++ % taken_every_ == 0) {
      open_.echoes.push_back({T_begin_sensor.position_m(),
                              T_begin_sensor.heading_rad() + beam.bearing_rad,
                              *beam.range_m,
                              scan.beam_width_rad / 2.0});
    }
    if (open_.echoes.size() > params_.max_echoes) {
      thin_out();
    }
  }
}

void MultiscanGathering::thin_out() {
  std::vector<mapping::Echo> kept;
  for (std::size_t i = 0; i < open_.echoes.size(); i += 2) {
    kept.push_back(open_.echoes[i]);
  }
  open_.echoes = std::move(kept);
  taken_every_ *= 2;
}

}  // namespace echomap::slam
