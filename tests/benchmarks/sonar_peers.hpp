// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"

namespace echomap::bench {

/// What the peers need to know of the sonar.
struct PeerSonar {
  double beam_half_angle_rad = 0.2618;
  double max_range_m = 3.0;
};

/// Mahmood and Ridao's grid, Algorithms 2 and 3, with a whole sweep as the measurement z_t: the
/// beam nearest to a cell's bearing speaks of it.
mapping::OccupancyGrid paper002_grid(const std::vector<mapping::Scan>& sweeps,
                                     const PeerSonar& sonar);

/// The same with every reading as a measurement of its own, which speaks of its whole cone.
mapping::OccupancyGrid paper002_single_grid(const std::vector<mapping::Scan>& sweeps,
                                            const PeerSonar& sonar);

/// Hennessey et al.'s grid: occupied from a confidence of 1 on, one echo; all the rest of the field
/// that echoes span is empty, as their map is from the start.
mapping::OccupancyGrid paper003_grid(const std::vector<mapping::Scan>& sweeps);

/// MRPT's COccupancyGridMap2D with CObservationRange, its own thresholds of insertion. Empty where
/// MRPT was not found.
std::optional<mapping::OccupancyGrid> mrpt_grid(const std::vector<mapping::Scan>& sweeps,
                                                const PeerSonar& sonar);

}  // namespace echomap::bench
