// SPDX-License-Identifier: MIT
#include "host/team_map/robot_map.hpp"

#include <algorithm>
#include <utility>

namespace echomap::team_map {

namespace {

bool are_same(const std::vector<geometry::Pose2>& some,
              const std::vector<geometry::Pose2>& others) {
  return std::equal(
      some.begin(), some.end(), others.begin(), others.end(), [](const auto& a, const auto& b) {
        return a.position_m() == b.position_m() && a.heading_rad() == b.heading_rad();
      });
}

}  // namespace

bool RobotMap::take(RobotRecord record) {
  const std::size_t known = std::min(record.submaps.size(), record.T_map_submaps.size());
  record.submaps.resize(known);
  record.T_map_submaps.resize(known);
  if (record.robot == record_.robot && known == record_.submaps.size() &&
      are_same(record.T_map_submaps, record_.T_map_submaps)) {
    return false;
  }
  record_ = std::move(record);
  calibrated_ = calibrated_turns(record_.submaps);
  placed_ = team_map::placed(calibrated_, record_.T_map_submaps);
  if (!mapper_) {
    params_.surfaces.beam_half_angle_rad = record_.beam_half_angle_rad;
    mapper_.emplace(params_);
  }
  mapper_->take(placed_.scans, positions_m(placed_.T_map_way));
  map_.emplace(mapping::rasterize(mapper_->grid()));
  return known > 0;
}

}  // namespace echomap::team_map
