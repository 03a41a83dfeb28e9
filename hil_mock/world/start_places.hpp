// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// Where robots that share a room may start.
struct StartRules {
  std::size_t robots = 1;
  /// Shortest way over the floor between any two, for a robot's middle.
  double apart_m = 2.0;
  double radius_m = 0.09;
  /// Between a robot's hull and the next wall or hole, where it starts.
  double clearance_m = 0.05;
};

/// Draws start poses, as world coordinates, of places that can be reached from the room's own
/// start. `first` is the first robot's where it is given, and else drawn too. Ways are measured on
/// a lattice of 5 cm with 16 directions, which makes them up to 3 % longer than they are. Throws
/// std::invalid_argument where the room has no place for so many.
std::vector<geometry::Pose2> draw_starts(const FloorPlan& plan,
                                         const StartRules& rules,
                                         const std::optional<geometry::Pose2>& first,
                                         std::uint32_t seed);

}  // namespace echomap::world
