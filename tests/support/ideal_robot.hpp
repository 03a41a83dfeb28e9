// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/team_map/submap.hpp"
#include "tests/support/smooth_room.hpp"

namespace echomap::tests {

/// Submaps of a robot in a room, without any error. Its map begins at the first of its stops;
/// `heading_rad` is its heading in the room at all of them.
inline team_map::RobotRecord ideal_record(std::string robot,
                                          const SmoothRoom& room,
                                          const std::vector<Eigen::Vector2d>& places_m,
                                          double heading_rad) {
  constexpr double kWayStepM = 0.1;
  team_map::RobotRecord record;
  record.robot = std::move(robot);
  record.body_radius_m = 0.09;
  const geometry::Pose2 T_room_map(places_m.front().x(), places_m.front().y(), heading_rad);
  Eigen::Vector2d before_m = places_m.front();
  double path_m = 0.0;
  for (const Eigen::Vector2d& place_m : places_m) {
    team_map::Submap submap;
    submap.index = static_cast<std::uint32_t>(record.submaps.size());
    submap.begin_s = 20.0 * submap.index;
    submap.end_s = submap.begin_s + 20.0;
    const double distance_m = (place_m - before_m).norm();
    const auto steps = static_cast<int>(std::lround(distance_m / kWayStepM));
    for (int i = 1; i <= steps; ++i) {
      const Eigen::Vector2d at_m = before_m + (place_m - before_m) * i / steps;
      submap.T_odom_way.push_back(T_room_map.inverse() *
                                  geometry::Pose2(at_m.x(), at_m.y(), heading_rad));
    }
    path_m += distance_m;
    before_m = place_m;
    const geometry::Pose2 T_room_robot(place_m.x(), place_m.y(), heading_rad);
    slam::OdometryMark mark;
    mark.T_odom_robot = T_room_map.inverse() * T_room_robot;
    mark.path_m = path_m;
    for (int i = 0; i < 90; ++i) {
      const geometry::Pose2 T_robot_sonar(0.0, 0.0, geometry::radians(4.0 * i));
      submap.readings.push_back(
          {mark, T_robot_sonar, ideal_range_m(T_room_robot * T_robot_sonar, room)});
    }
    record.T_map_submaps.push_back(mark.T_odom_robot);
    record.submaps.push_back(std::move(submap));
  }
  return record;
}

/// The same before the last stops.
inline team_map::RobotRecord first_stops(team_map::RobotRecord record, std::size_t stops) {
  record.submaps.resize(stops);
  record.T_map_submaps.resize(stops);
  return record;
}

/// Four walls, one corner cut off, and posts; x from -1.1 to 1.3, y from -0.7 to 0.9.
inline SmoothRoom room_of_posts() {
  SmoothRoom room = smooth_rectangle();
  room.walls.push_back({geometry::radians(40.0), 1.15});
  room.corners_m.erase(room.corners_m.begin());
  room.corners_m.emplace_back(0.75, 0.1);
  room.corners_m.emplace_back(-0.65, 0.45);
  return room;
}

/// A room of the same size, with another corner cut off and its posts elsewhere.
inline SmoothRoom look_alike_room() {
  SmoothRoom room = smooth_rectangle();
  room.walls.push_back({geometry::radians(140.0), 1.0});
  room.corners_m.erase(room.corners_m.begin() + 1);
  room.corners_m.emplace_back(0.1, -0.25);
  room.corners_m.emplace_back(-0.1, 0.6);
  room.corners_m.emplace_back(0.8, 0.5);
  return room;
}

/// Two rounds of such a room.
inline std::vector<Eigen::Vector2d> one_round_m() {
  return {{0.0, 0.0},
          {0.4, 0.3},
          {0.9, 0.5},
          {0.9, -0.3},
          {0.3, -0.4},
          {-0.4, -0.3},
          {-0.8, 0.0},
          {-0.3, 0.1}};
}
inline std::vector<Eigen::Vector2d> other_round_m() {
  return {{-0.7, -0.4},
          {-0.2, -0.1},
          {-0.3, 0.6},
          {0.2, 0.6},
          {0.6, 0.6},
          {1.0, 0.1},
          {0.6, -0.3},
          {0.1, -0.2}};
}

/// Where the map of one robot lies in that of another, of the same room.
inline geometry::Pose2 T_maps(const std::vector<Eigen::Vector2d>& own_m,
                              double own_heading_rad,
                              const std::vector<Eigen::Vector2d>& peer_m,
                              double peer_heading_rad) {
  const geometry::Pose2 T_room_own(own_m.front().x(), own_m.front().y(), own_heading_rad);
  const geometry::Pose2 T_room_peer(peer_m.front().x(), peer_m.front().y(), peer_heading_rad);
  return T_room_own.inverse() * T_room_peer;
}

}  // namespace echomap::tests
