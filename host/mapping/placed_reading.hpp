// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::mapping {

/// A sonar reading with the place it was taken from. The sonar frame lies at the transducer with x
/// along the beam's axis. `range_m` is empty without an echo in range.
struct PlacedReading {
  geometry::Pose2 T_map_robot;
  geometry::Pose2 T_map_sonar;
  std::optional<double> range_m;
  bool has_answered = true;  ///< False where the sonar did not answer its trigger.
};

/// What the robot saw from one stop, in the order in which it was read.
using Scan = std::vector<PlacedReading>;

/// The same in another frame, or from where else they were taken: by `T_to_from` to the left.
PlacedReading moved(const PlacedReading& reading, const geometry::Pose2& T_to_from);
Scan moved(const Scan& scan, const geometry::Pose2& T_to_from);

/// The readings whose trigger the sonar has answered: of the others nobody has listened.
Scan answered(const Scan& scan);

/// Where the echo would lie if it came from the axis of the beam, in the map frame; empty without
/// echo.
std::optional<Eigen::Vector2d> echo_point_m(const PlacedReading& reading);

}  // namespace echomap::mapping
