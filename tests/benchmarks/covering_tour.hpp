// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"
#include "host/exploration/stop_tour.hpp"
#include "tests/benchmarks/stop_choice.hpp"

namespace echomap::bench {

/// How a robot gets around a room of which everything is known.
struct CoveringTourParams {
  StopChoiceParams stops;
  /// From the middle of the axle to the farthest part of the hull (robot profile).
  double robot_radius_m = 0.09;
  /// Floor that is left between the hull and a wall.
  double clearance_m = 0.08;
  /// Cells of the plan that ways are searched on.
  double cell_m = 0.025;
  /// Lattice of the places among which stops are chosen, in cells.
  int candidate_cells = 6;
};

/// Stops that show a room to a sonar and the way from one to the next.
struct CoveringTour {
  /// In the order of the tour, in the world frame; the first is the start.
  std::vector<Eigen::Vector2d> stops_m;
  /// For strategy `stops`: the stops and between them the corners of the ways, in the map frame.
  std::vector<exploration::TourPlace> places;
};

/// Chooses stops by the true plan of a room, among those that the robot can get to, and orders them
/// by the nearest next one and exchanges (2-opt, Croes 1958). Throws std::invalid_argument where
/// the robot has no room at the start.
CoveringTour covering_tour(const world::FloorPlan& plan, const CoveringTourParams& params = {});

/// Writes what strategies::load_stop_list reads. Throws files::FileError.
void write_stop_list(const std::filesystem::path& path,
                     const std::vector<exploration::TourPlace>& places);

}  // namespace echomap::bench
