// SPDX-License-Identifier: MIT
#include "host/team_map/placed_submaps.hpp"

#include <algorithm>

#include "host/geometry/angle.hpp"

namespace echomap::team_map {

namespace {

using geometry::Pose2;

/// Between two poses that are near each other.
Pose2 between(const Pose2& from, const Pose2& to, double share) {
  const Eigen::Vector2d position_m =
      from.position_m() + share * (to.position_m() - from.position_m());
  const double turn_rad = geometry::angle_between(from.heading_rad(), to.heading_rad());
  return {position_m.x(), position_m.y(), from.heading_rad() + share * turn_rad};
}

/// Places what lies on the way from one submap to the next.
class WayPlacement {
 public:
  WayPlacement(const Pose2& T_map_odom_before, const Pose2& T_map_odom_after)
      : T_map_odom_before_(T_map_odom_before), T_map_odom_after_(T_map_odom_after) {}

  Pose2 placed(const Pose2& T_odom_robot, double share) const {
    return between(T_map_odom_before_ * T_odom_robot, T_map_odom_after_ * T_odom_robot, share);
  }

 private:
  Pose2 T_map_odom_before_;
  Pose2 T_map_odom_after_;
};

void place_way(const Submap& submap, const WayPlacement& placement, PlacedSubmaps& placed) {
  const auto count = static_cast<double>(submap.T_odom_way.size());
  for (std::size_t i = 0; i < submap.T_odom_way.size(); ++i) {
    placed.T_map_way.push_back(
        placement.placed(submap.T_odom_way[i], static_cast<double>(i + 1) / count));
  }
  for (const SubmapContact& contact : submap.contacts) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < submap.T_odom_way.size(); ++i) {
      const auto off_m = [&](std::size_t at) {
        return (submap.T_odom_way[at].position_m() - contact.T_odom_robot.position_m()).norm();
      };
      nearest = off_m(i) < off_m(nearest) ? i : nearest;
    }
    const double share = count == 0.0 ? 1.0 : static_cast<double>(nearest + 1) / count;
    placed.contacts.push_back(
        {placement.placed(contact.T_odom_robot, share), contact.left, contact.right});
  }
}

mapping::Scan scan_of(const Submap& submap, const Pose2& T_map_odom) {
  mapping::Scan scan;
  for (const slam::StopReading& reading : submap.readings) {
    const Pose2 T_map_robot = T_map_odom * reading.mark.T_odom_robot;
    scan.push_back({T_map_robot, T_map_robot * reading.T_robot_sonar, reading.range_m});
  }
  return scan;
}

}  // namespace

PlacedSubmaps placed(const std::vector<Submap>& submaps, const std::vector<Pose2>& T_map_submaps) {
  PlacedSubmaps placed;
  Pose2 T_map_odom_before;
  for (std::size_t i = 0; i < submaps.size(); ++i) {
    const Submap& submap = submaps[i];
    const Pose2 T_map_odom = T_map_submaps[i] * submap.readings.front().mark.T_odom_robot.inverse();
    place_way(submap, {i == 0 ? T_map_odom : T_map_odom_before, T_map_odom}, placed);
    placed.T_map_way.push_back(T_map_submaps[i]);
    placed.scans.push_back(scan_of(submap, T_map_odom));
    T_map_odom_before = T_map_odom;
  }
  return placed;
}

std::vector<StopEnd> stop_ends(const std::vector<Submap>& submaps,
                               const std::vector<Pose2>& T_map_submaps) {
  std::vector<StopEnd> ends;
  for (std::size_t i = 0; i < T_map_submaps.size(); ++i) {
    const auto& readings = submaps[i].readings;
    const Pose2 T_map_odom = T_map_submaps[i] * readings.front().mark.T_odom_robot.inverse();
    ends.push_back({submaps[i].end_s, T_map_odom * readings.back().mark.T_odom_robot});
  }
  return ends;
}

std::vector<Eigen::Vector2d> positions_m(const std::vector<Pose2>& poses) {
  std::vector<Eigen::Vector2d> positions_m;
  positions_m.reserve(poses.size());
  for (const Pose2& pose : poses) {
    positions_m.push_back(pose.position_m());
  }
  return positions_m;
}

}  // namespace echomap::team_map
