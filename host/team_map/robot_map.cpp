// SPDX-License-Identifier: MIT
#include "host/team_map/robot_map.hpp"

#include <algorithm>
#include <utility>

#include "host/slam/leave_one_out.hpp"

namespace echomap::team_map {

namespace {

using geometry::Pose2;

bool are_same(const std::vector<Pose2>& some, const std::vector<Pose2>& others) {
  return std::equal(
      some.begin(), some.end(), others.begin(), others.end(), [](const auto& a, const auto& b) {
        return a.position_m() == b.position_m() && a.heading_rad() == b.heading_rad();
      });
}

/// As slam::StopAlignment matches stops.
mapping::SurfaceMatchingParams matching_params() {
  return {.wall_bearing_tolerance_rad = 0.18, .post_bearing_tolerance_rad = 0.18};
}

}  // namespace

bool RobotMap::take(RobotRecord record) {
  const std::size_t known = std::min(record.submaps.size(), record.T_map_submaps.size());
  record.submaps.resize(known);
  record.T_map_submaps.resize(known);
  const bool has_other_beam = record.beam_half_angle_rad != record_.beam_half_angle_rad;
  if (record.robot == record_.robot && known == record_.submaps.size() && !has_other_beam &&
      record.body_radius_m == record_.body_radius_m &&
      are_same(record.T_map_submaps, record_.T_map_submaps)) {
    return false;
  }
  record_ = std::move(record);
  if (has_other_beam) {
    mapper_.reset();
    surfaces_.clear();
  }
  calibrated_.take(record_.submaps);
  placed_ = team_map::placed(submaps(), record_.T_map_submaps);
  if (!mapper_) {
    params_.surfaces.beam_half_angle_rad = record_.beam_half_angle_rad;
    mapper_.emplace(params_);
  }
  mapper_->take(placed_.scans, positions_m(placed_.T_map_way));
  map_.emplace(mapping::rasterize(mapper_->grid()));
  find_features();
  return known > 0;
}

void RobotMap::find_features() {
  // A submap is immutable: what was seen from it is found once.
  surfaces_.resize(std::min(surfaces_.size(), submaps().size()));
  while (surfaces_.size() < submaps().size()) {
    const std::size_t i = surfaces_.size();
    surfaces_.push_back(mapping::find_surfaces(
        mapping::moved(placed_.scans[i], record_.T_map_submaps[i].inverse()), params_.surfaces));
  }
  placed_surfaces_.clear();
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    placed_surfaces_.push_back(mapping::moved(surfaces_[i], record_.T_map_submaps[i]));
  }
  features_ = mapping::match_surfaces(placed_surfaces_, matching_params());
  slam::StopHeadingParams heading;
  heading.beam_half_angle_rad = record_.beam_half_angle_rad;
  scene_.emplace(features_, heading);
  own_.clear();
  for (std::size_t i = 0; i < placed_.scans.size(); ++i) {
    const slam::SonarScene others(slam::features_of_others(features_, i), heading);
    own_.push_back(others.log_likelihoods_of(placed_.scans[i]));
  }
}

}  // namespace echomap::team_map
