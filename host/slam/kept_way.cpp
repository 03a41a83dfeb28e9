// SPDX-License-Identifier: MIT
#include "host/slam/kept_way.hpp"

#include <cmath>
#include <stdexcept>

namespace echomap::slam {

using geometry::Pose2;

KeptWay::KeptWay(const KeptWayParams& params) : params_(params) {
  if (params.most_kept < 2) {
    throw std::invalid_argument("kept way: at least two poses are kept");
  }
}

void KeptWay::keep(EkfSlam& filter) {
  const Pose2 T_map_robot = filter.belief().T_map_robot;
  const auto T_kept_robot = [&] {
    return filter.T_map_kept(filter.kept_poses() - 1).inverse() * T_map_robot;
  };
  const bool is_due =
      filter.kept_poses() == 0 ||
      T_kept_robot().position_m().norm() >= kept_every_ * params_.kept_every_m ||
      std::abs(T_kept_robot().heading_rad()) >= kept_every_ * params_.kept_every_rad;
  if (is_due) {
    filter.keep_pose();
  }
  now_ = {filter.kept_poses() - 1, T_kept_robot()};
  if (filter.kept_poses() > params_.most_kept) {
    thin_out(filter);
  }
}

void KeptWay::add(const Pose2& T_now_instant) {
  instants_.push_back({now_.kept, now_.T_kept_robot * T_now_instant});
}

/// Every other kept pose goes; what hung on it now hangs on the one before.
void KeptWay::thin_out(EkfSlam& filter) {
  kept_every_ *= 2.0;
  const auto hang_on_before = [&](Instant& instant) {
    if (instant.kept % 2 == 1) {
      const Pose2 T_before_kept =
          filter.T_map_kept(instant.kept - 1).inverse() * filter.T_map_kept(instant.kept);
      instant.T_kept_robot = T_before_kept * instant.T_kept_robot;
    }
    instant.kept /= 2;
  };
  for (Instant& instant : instants_) {
    hang_on_before(instant);
  }
  hang_on_before(now_);
  for (std::size_t i = filter.kept_poses(); i-- > 0;) {
    if (i % 2 == 1) {
      filter.forget_pose(i);
    }
  }
}

std::vector<Pose2> KeptWay::trajectory(const EkfSlam& filter) const {
  std::vector<Pose2> T_map_robots;
  T_map_robots.reserve(instants_.size());
  for (const Instant& instant : instants_) {
    T_map_robots.push_back(filter.T_map_kept(instant.kept) * instant.T_kept_robot);
  }
  return T_map_robots;
}

}  // namespace echomap::slam
