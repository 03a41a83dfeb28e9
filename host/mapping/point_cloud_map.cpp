// SPDX-License-Identifier: MIT
#include "host/mapping/point_cloud_map.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace echomap::mapping {

namespace {

bool is_same_place(const geometry::Pose2& a, const geometry::Pose2& b) {
  return a.position_m() == b.position_m() && a.heading_rad() == b.heading_rad();
}

}  // namespace

PointCloudMap::PointCloudMap(std::vector<geometry::Pose2> poses, std::vector<MapPoint> points)
    : poses_(std::move(poses)), points_(std::move(points)) {
  const auto names_no_pose = [this](const MapPoint& point) {
    return point.pose_index >= poses_.size();
  };
  if (std::any_of(points_.begin(), points_.end(), names_no_pose)) {
    throw std::invalid_argument("a map point names a pose that the map does not hold");
  }
}

void PointCloudMap::add(const PlacedReading& reading) {
  if (poses_.empty() || !is_same_place(poses_.back(), reading.T_map_robot)) {
    poses_.push_back(reading.T_map_robot);
  }
  if (const auto point_m = echo_point_m(reading)) {
    points_.push_back({*point_m, poses_.size() - 1});
  }
}

}  // namespace echomap::mapping
