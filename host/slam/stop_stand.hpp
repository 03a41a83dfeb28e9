// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/odometry_meter.hpp"

namespace echomap::slam {

/// A reading of a stop.
struct StopReading {
  OdometryMark mark;
  geometry::Pose2 T_robot_sonar;
  std::optional<double> range_m;
};

/// Readings of a stop from the first at one heading to the last before another one. Those in
/// between, while the body turns, belong to the heading before.
struct StopStand {
  std::size_t stop = 0;
  std::size_t first = 0;    ///< Index of its first reading in the stop.
  std::size_t resting = 0;  ///< Number of readings, from the first on, that were taken at rest.
  std::size_t last = 0;     ///< Index behind its last reading.
};

/// Which readings belong to one heading at rest; values are ours.
struct StopStandParams {
  /// While the body turns or moves by less.
  double same_rad = 0.1;
  double same_m = 0.05;
  /// Fewer readings at rest are part of the stand before.
  std::size_t min_readings = 8;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const StopStandParams& params);

/// The stands of the stop with that index, from its readings in the order of time.
std::vector<StopStand> stands_in(const std::vector<StopReading>& readings,
                                 std::size_t stop,
                                 const StopStandParams& params);

/// Whether poses are no farther apart than that.
bool is_near(const geometry::Pose2& one,
             const geometry::Pose2& other,
             double near_m,
             double near_rad);
/// Whether they are as many and all of them near each other.
bool are_near(const std::vector<geometry::Pose2>& some,
              const std::vector<geometry::Pose2>& others,
              double near_m,
              double near_rad);

}  // namespace echomap::slam
