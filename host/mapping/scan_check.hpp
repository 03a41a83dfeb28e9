// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// What makes a scan worthless for the map.
enum class ScanFault : std::uint8_t {
  kNone,
  kStuck,      ///< All round there is one and the same range: a sonar that hangs.
  kElsewhere,  ///< It is of another place: the robot was carried off, or its wheels have slipped.
};

/// When a scan has a fault; ours, chosen in simulated rooms.
struct ScanCheckParams {
  /// Fewer readings tell nothing.
  std::size_t min_readings = 20;
  /// Ranges that differ by less are one; a sonar's own noise is larger.
  double same_range_m = 0.004;
  /// So many in a row, over so much of the circle, are no wall: walls end, and no room is round
  /// about the sonar to a few millimetres.
  std::size_t same_readings = 12;
  double same_bearing_rad = 1.57;
  /// Half of the beam, within which an echo may come from anywhere.
  double beam_half_angle_rad = 0.26;
  /// An echo is where the map has floor if nothing is known that is nearer to its arc than this.
  double tolerance_m = 0.15;
  /// Of so many echoes that the map has something to say of, a scan of the place has at least
  /// `min_share` where walls are.
  std::size_t min_echoes = 12;
  double min_share = 0.5;
  /// ... and at most this share where floor is firm: more than one stop has seen it, which alone
  /// may have been deceived by a wall that threw its sound aside. Of the arc of such an echo, at
  /// most `max_other_share` is other than floor of that evidence.
  double max_firm_share = 0.3;
  double max_other_share = 0.4;
  int firm_floor_centilogits = -240;
};

/// What a scan is compared with: the map that the stops of `scans` have made and, as long as they
/// are fewer than three, what each of them has heard as well. A wall is drawn where stops agree, so
/// that a young map has floor and hardly a wall, and some of its floor is that of an echo by way of
/// a wall.
std::shared_ptr<const OccupancyGrid> compared_map(std::shared_ptr<const OccupancyGrid> map,
                                                  const std::vector<Scan>& scans);

/// How the echoes of a scan agree with a map.
struct ScanFit {
  std::size_t on_walls = 0;  ///< Something stands on the echo's arc.
  std::size_t on_floor = 0;  ///< All of the arc is floor.
};

/// Both in the map frame.
ScanFit fit_of(const Scan& scan, const OccupancyGrid& map, const ScanCheckParams& params = {});

/// A map of which only the states of its cells are known, to be compared with scans in its own
/// frame: the lower left corner of the picture's first cell is the origin.
OccupancyGrid grid_of(const RasterMap& map);

/// Of a scan before it is put into the map.
ScanFault fault_of(const Scan& scan, const OccupancyGrid& map, const ScanCheckParams& params = {});

}  // namespace echomap::mapping
