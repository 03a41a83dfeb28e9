// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "host/pipeline/snapshot.hpp"

namespace echomap::tests {

/// A snapshot as of a run that has drawn this grid and gone this way.
inline pipeline::Snapshot snapshot_of(mapping::OccupancyGrid grid,
                                      std::vector<pipeline::StampedPose> trajectory = {},
                                      mapping::PointCloudMap points = {}) {
  pipeline::Snapshot snapshot;
  if (!trajectory.empty()) {
    snapshot.latest = trajectory.back();
  }
  snapshot.trajectory =
      std::make_shared<const std::vector<pipeline::StampedPose>>(std::move(trajectory));
  snapshot.points = std::make_shared<const mapping::PointCloudMap>(std::move(points));
  snapshot.grid = std::make_shared<const mapping::OccupancyGrid>(std::move(grid));
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>();
  snapshot.last_scan = std::make_shared<const mapping::Scan>();
  return snapshot;
}

inline pipeline::StampedPose pose_at(double stamp_s, const geometry::Pose2& pose) {
  const auto stamp = std::chrono::duration_cast<time::RobotClock::duration>(
      std::chrono::duration<double>(stamp_s));
  return {time::RobotTime(stamp), pose};
}

}  // namespace echomap::tests
