// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/sector_kernel.hpp"
#include "host/mapping/sector_rows.hpp"

namespace echomap::mapping {

/// The evidence that the readings of one kind of sonar bring, by the angle off the cone's axis.
struct ConeInsertionParams {
  /// Half of the cone's opening, radians, in (0, pi / 2): 7.5 degrees, as of the HC-SR04.
  double half_opening_rad = 0.1309;
  /// Hundredths of log-odds for equal parts of the half opening, from the axis outwards; free
  /// evidence below 0, arc evidence above 0. Each part makes at least one step of the grid, save
  /// that the outermost parts may be 0: there the cone says nothing. May be empty; at most 8.
  std::vector<int> free_centilogits = {-40, -40, -30, -20};
  std::vector<int> arc_centilogits = {60, 50, 30, 15};
  /// Half of the thickness of the arc, metres.
  double half_thickness_m = 0.05;
  /// No cell farther off than this gets evidence, metres; at most 2000 cells.
  double reach_m = 5.0;
};

/// What one reading says of the cells in its cone.
struct ConeReading {
  geometry::Pose2 T_map_sonar;
  /// Up to here the cone is free; 0 says nothing of the floor.
  double free_range_m = 0.0;
  /// Something stands at this range within the cone; empty when nothing was heard.
  std::optional<double> arc_range_m;
};

/// Adds sonar cones to an occupancy grid, reading by reading. For each cell of the cone:
///
/// - The angle off axis is seen from the centre of the sonar's cell: with 5 cm cells the apex moves
///   by at most 3.5 cm, 2 degrees for what is 1 m off. The border of a part moves on by a whole
///   number of 1/512 of a cell from row to row, and cells on it are within: it is off by less than
///   0.06 degrees.
/// - The range is seen from there, too, and every range of the reading is made longer by as much as
///   the sonar stands ahead of that centre along the axis; that is right to some millimetres.
/// - A cell whose centre is no farther than `free_range_m` gets the free evidence of its angle, one
///   within `half_thickness_m` of `arc_range_m` that of the arc. Free floor ends where the arc
///   begins, so that no cell gets both.
///
/// A reading costs time with the rows of cells that it covers. One with a number that is not finite
/// adds nothing.
class ConeInserter {
 public:
  /// For grids with the resolution, and a step as wide, as `grid`. Throws std::invalid_argument for
  /// parameters outside of their ranges.
  ConeInserter(const ConeInsertionParams& params, const OccupancyGrid& grid);

  /// `grid` must have the resolution that this was made for.
  void insert(const ConeReading& reading, OccupancyGrid& grid);

 private:
  using Kernel =
      void(const SectorRows&, const WedgeSteps&, const Patch&, EvidenceLimits, std::uint8_t*);

  /// Where a cone begins and points, the latter as a unit vector.
  struct Cone {
    geometry::CellIndex apex;
    Eigen::Vector2d axis;
  };

  /// Wedges within each other, from the widest to the narrowest, what each adds, and where the
  /// present cone has them.
  struct Evidence {
    std::vector<Eigen::Vector2d> half_openings;  ///< Cosines and sines.
    WedgeSteps steps;
    SectorRows rows;
  };

  Evidence evidence(const std::vector<std::uint8_t>& steps_by_angle, double half_opening_rad) const;
  /// The largest square of a distance in cells that is within, or before, a range.
  std::int32_t last_within(double range_m) const;
  std::int32_t last_before(double range_m) const;
  void add(
      Evidence& evidence, const Ring& ring, Kernel* kernel, const Cone& cone, OccupancyGrid& grid);
  /// Adds what falls into kPatchSide columns of the grid from `column` on.
  static void add_strip(const Evidence& evidence,
                        std::int32_t column,
                        Kernel* kernel,
                        geometry::CellIndex apex,
                        OccupancyGrid& grid);

  double resolution_m_;
  double half_thickness_m_;
  double reach_cells_;
  Evidence free_;
  Evidence arc_;
  std::vector<Wedge> wedges_;
};

}  // namespace echomap::mapping
