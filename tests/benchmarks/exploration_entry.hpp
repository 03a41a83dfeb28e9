// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "hil_mock/world/floor_plan.hpp"
#include "host/exploration/waypoint_course.hpp"
#include "tests/benchmarks/exploration_runs.hpp"

namespace echomap::bench {

/// A strategy in a room: with which robot it runs there, or why it does not.
struct ExplorationEntry {
  ExplorationCase what;
  std::string why_not{};     ///< Empty where it runs.
  double room_edge_m = 0.0;  ///< The longer side of the box around the room.
};

/// Share of a room's free floor that a round hull can pass over from the room's start, by cells of
/// 2 cm.
double share_in_reach(const world::FloorPlan& room, double body_radius_m);

/// A course round the room: course_around, without the waypoints where furniture
/// leaves no place for the hull. Throws std::invalid_argument where the room is too small for its
/// corners.
exploration::WaypointCourse course_of(const world::FloorPlan& room, double body_radius_m);

/// Whether and how a strategy runs in a room. All that go by a sonar drive the same robot, uno_2wd,
/// so that their times compare; coastal and random-bounce drive a Create, epuck an e-puck under a
/// camera. A course goes to `folder`. Throws files::ConfigError for a room that is not there.
ExplorationEntry entry_of(const std::string& room,
                          const std::string& strategy,
                          const std::filesystem::path& folder);

}  // namespace echomap::bench
