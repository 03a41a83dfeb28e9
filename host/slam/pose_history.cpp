// SPDX-License-Identifier: MIT
#include "host/slam/pose_history.hpp"

#include <cmath>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::slam {

using geometry::Pose2;

PoseHistory::PoseHistory(const PoseHistoryParams& params) : params_(params) {
  geometry::ParameterValidator("pose history").at_least("max_poses", params.max_poses, 2);
}

void PoseHistory::keep(EkfSlamFilter& filter) {
  const Pose2 T_map_robot = filter.belief().T_map_robot;
  const auto T_stored_robot = [&] {
    return filter.T_map_stored(filter.stored_poses() - 1).inverse() * T_map_robot;
  };
  const bool is_due =
      filter.stored_poses() == 0 ||
      T_stored_robot().position_m().norm() >= pose_every_ * params_.pose_every_m ||
      std::abs(T_stored_robot().heading_rad()) >= pose_every_ * params_.pose_every_rad;
  if (is_due) {
    filter.store_pose();
  }
  now_ = {filter.stored_poses() - 1, T_stored_robot()};
  if (filter.stored_poses() > params_.max_poses) {
    thin_out(filter);
  }
}

void PoseHistory::add(const Pose2& T_now_instant) {
  instants_.push_back({now_.stored, now_.T_stored_robot * T_now_instant});
}

/// Every other kept pose goes; what hung on it now hangs on the one before.
void PoseHistory::thin_out(EkfSlamFilter& filter) {
  pose_every_ *= 2.0;
  const auto hang_on_before = [&](Instant& instant) {
    if (instant.stored % 2 == 1) {
      const Pose2 T_before_stored =
          filter.T_map_stored(instant.stored - 1).inverse() * filter.T_map_stored(instant.stored);
      instant.T_stored_robot = T_before_stored * instant.T_stored_robot;
    }
    instant.stored /= 2;
  };
  for (Instant& instant : instants_) {
    hang_on_before(instant);
  }
  hang_on_before(now_);
  for (std::size_t i = filter.stored_poses(); i-- > 0;) {
    if (i % 2 == 1) {
      filter.forget_pose(i);
    }
  }
}

std::vector<Pose2> PoseHistory::trajectory(const EkfSlamFilter& filter) const {
  std::vector<Pose2> T_map_robots;
  T_map_robots.reserve(instants_.size());
  for (const Instant& instant : instants_) {
    T_map_robots.push_back(filter.T_map_stored(instant.stored) * instant.T_stored_robot);
  }
  return T_map_robots;
}

}  // namespace echomap::slam
