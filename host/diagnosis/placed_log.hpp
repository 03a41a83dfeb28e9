// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/diagnosis/robot_errors.hpp"
#include "host/diagnosis/stand_log.hpp"

namespace echomap::diagnosis {

/// A surface where a robot of some errors has heard it, in the frame of its start.
struct PlacedSurface {
  Eigen::Vector2d foot_m;     ///< Its point nearest to the sonar.
  Eigen::Vector2d direction;  ///< From the sonar to it.
  bool is_wall = false;
  std::size_t readings = 0;
};

/// A stand with its surfaces where a robot of some errors has heard them.
struct PlacedStand {
  std::vector<PlacedSurface> surfaces;
  double travelled_m = 0.0;  ///< What the wheels have rolled until then, on average.
  std::size_t piece = 0;
};

/// A rolling ping with the sonar where a robot of some errors has had it.
struct PlacedPing {
  Eigen::Vector2d at_m;
  Eigen::Vector2d direction;
  double range_m = 0.0;
  double travelled_m = 0.0;  ///< As of a stand.
  std::size_t piece = 0;
};

/// Where a robot of some errors has heard what it has heard.
struct PlacedLog {
  std::vector<PlacedStand> stands;
  std::vector<PlacedPing> pings;
};

/// Integrates the wheel steps of a robot that has these errors.
PlacedLog place(const StandLog& log, const RobotErrors& errors);

}  // namespace echomap::diagnosis
