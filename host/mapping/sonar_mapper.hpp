// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/scan_alignment.hpp"
#include "host/mapping/sonar_features.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/stop_floor.hpp"
#include "host/mapping/surface_matching.hpp"
#include "host/mapping/wall_corners.hpp"

namespace echomap::mapping {

/// Evidence is in hundredths of log-odds; the weights are ours, chosen in simulated rooms.
struct SonarMapperParams {
  OccupancyGridParams grid;
  SonarSurfaceParams surfaces;
  SurfaceMatchingParams matching;
  ScanAlignmentParams alignment;
  CornerJoiningParams corners;
  StopFloorParams floor;
  /// Evidence of one stop for floor or surface at its feet; it falls to 1/e at `fade_m`, because an
  /// error of bearing counts the more the farther off.
  int free_centilogits = 220;
  int occupied_centilogits = 100;
  /// The same for a post or corner, which may as well be an echo from round a corner: one sighting
  /// alone does not make a cell occupied.
  int post_centilogits = 50;
  double fade_m = 3.0;
  /// Evidence for a wall or post that several stops agree on.
  int matched_centilogits = 500;
  /// Such a wall is drawn so far behind its face: floor ends in the middle of a cell, and the half
  /// before the wall is floor.
  double drawn_behind_m = 0.02;
};

/// Makes an occupancy grid of sonar scans. Not reading by reading: the readings of a stop are
/// resolved into surfaces, the surfaces of all stops are matched, the stops are moved to where
/// these agree, and only then is evidence put into cells (docs/algorithms/sonar_grid.md).
class SonarMapper {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SonarMapper(const SonarMapperParams& params = {});

  /// Adds the readings of one stop, placed by odometry alone.
  void add(const Scan& scan);
  /// Takes the readings of all stops so far, as SLAM places them now, for those of before.
  void take(const std::vector<Scan>& scans);

  /// The grid of all scans so far; without any echo, an untouched one.
  OccupancyGrid grid() const;
  /// What that grid is drawn from.
  SonarFeatures features() const;
  /// From where each scan was placed to where it is on the map; the robot goes with the last one.
  const std::vector<geometry::Pose2>& T_map_placed() const { return T_map_placed_; }

 private:
  using CellSet = std::set<geometry::CellIndex>;

  /// Readings and what was found in them, both as they were placed then.
  struct KnownScan {
    Scan readings;
    ScanSurfaces surfaces;
  };

  void match(const std::vector<ScanSurfaces>& placed);

  void add_floor(const ScanSurfaces& scan,
                 const std::vector<MatchedWall>& walls,
                 const CellSet& solid,
                 OccupancyGrid& grid) const;
  void add_surfaces(const ScanSurfaces& scan,
                    const OccupancyGrid& floor,
                    OccupancyGrid& grid) const;
  /// Where the walls and posts stand that stops agree on.
  CellSet solid_cells(const OccupancyGrid& grid) const;
  int faded(int centilogits, double distance_m) const;

  SonarMapperParams params_;
  std::vector<KnownScan> scans_;
  MatchedSurfaces matched_;  ///< On the map.
  std::vector<geometry::Pose2> T_map_placed_;
};

}  // namespace echomap::mapping
