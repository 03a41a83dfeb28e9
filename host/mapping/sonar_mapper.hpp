// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/scan_alignment.hpp"
#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

/// Evidence is in hundredths of log-odds; the weights are ours, chosen in simulated rooms.
struct SonarMapperParams {
  OccupancyGridParams grid;
  SonarSurfaceParams surfaces;
  SurfaceMatchingParams matching;
  ScanAlignmentParams alignment;
  /// Between two surfaces farther apart than this a stop knows nothing of the floor.
  double widest_gap_rad = 1.1;
  /// Floor nearer to a surface than this is not called free: its noise and half a cell.
  double margin_m = 0.04;
  /// A wall hides the floor behind it for so far beyond its seen ends, too.
  double hidden_beyond_ends_m = 0.1;
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
};

/// Makes an occupancy grid of sonar scans. Not reading by reading: the readings of a stop are
/// resolved into surfaces, the surfaces of all stops are matched, the stops are moved to where
/// these agree, and only then is evidence put into cells (docs/algorithms/sonar_grid.md).
class SonarMapper {
 public:
  /// Throws std::invalid_argument for parameters without sense.
  explicit SonarMapper(const SonarMapperParams& params = {});

  /// Adds the readings of one stop, placed by odometry alone.
  void add(const Scan& scan);

  /// The grid of all scans so far; without any echo, an untouched one.
  OccupancyGrid grid() const;
  /// From where odometry places the robot since the last scan to where it is on the map.
  const geometry::Pose2& T_map_odom() const { return T_map_odom_; }

 private:
  void add_floor(const ScanSurfaces& scan,
                 const std::vector<MatchedWall>& walls,
                 OccupancyGrid& grid) const;
  void add_surfaces(const ScanSurfaces& scan, OccupancyGrid& grid) const;
  void add_matched(const MatchedSurfaces& matched, OccupancyGrid& grid) const;
  int faded(int centilogits, double distance_m) const;

  SonarMapperParams params_;
  std::vector<ScanSurfaces> scans_;  ///< As odometry places them.
  MatchedSurfaces matched_;          ///< On the map.
  geometry::Pose2 T_map_odom_;
};

}  // namespace echomap::mapping
