// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"

namespace echomap::mapping {

/// One echo, in metres of the map frame, and the pose that it was seen from.
struct MapPoint {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  std::size_t pose_index = 0;
};

/// The map of Singh and Bedi 2013, section 3: one matrix of echo points and one of the robot's
/// poses, both in the order of their making. The first pose is where the robot started.
class PointCloudMap {
 public:
  PointCloudMap() = default;
  /// Puts a stored map together again; throws std::invalid_argument where a point names a pose that
  /// is not there.
  PointCloudMap(std::vector<geometry::Pose2> poses, std::vector<MapPoint> points);

  /// Appends the echo of a reading, and the robot's pose if it is not the last one. A reading
  /// without echo leaves no point.
  void add(const PlacedReading& reading);

  const std::vector<geometry::Pose2>& poses() const { return poses_; }
  const std::vector<MapPoint>& points() const { return points_; }

 private:
  std::vector<geometry::Pose2> poses_;
  std::vector<MapPoint> points_;
};

}  // namespace echomap::mapping
