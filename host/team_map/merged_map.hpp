// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/contact_mapper.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/placed_reading.hpp"
#include "host/mapping/sonar_features.hpp"
#include "host/mapping/sonar_mapper.hpp"
#include "host/team_map/placed_submaps.hpp"

namespace echomap::team_map {

/// Which robots have observed each cell: one bit per robot, in the order in which the map lists
/// them.
class Provenance {
 public:
  Provenance() = default;
  Provenance(const mapping::CellBounds& bounds, double resolution_m);

  const mapping::CellBounds& bounds() const { return bounds_; }
  double resolution_m() const { return resolution_m_; }
  /// Bits of the robots that have observed a cell; none outside of the bounds.
  std::uint64_t robots_at(geometry::CellIndex cell) const;
  void add(geometry::CellIndex cell, std::size_t robot);

 private:
  mapping::CellBounds bounds_;
  double resolution_m_ = 0.0;
  std::vector<std::uint64_t> robots_;
};

/// The map of several robots in one frame.
struct MergedMap {
  std::vector<std::string> robots;  ///< At most 64 have a bit of their own.
  std::shared_ptr<const mapping::OccupancyGrid> grid;
  /// Sonar scans of all of them, in the order in which they came.
  std::shared_ptr<const std::vector<mapping::Scan>> scans;
  /// What the grid is drawn from.
  std::shared_ptr<const mapping::SonarFeatures> features;
  /// Positions where the robots' centres have been.
  std::shared_ptr<const std::vector<Eigen::Vector2d>> been_m;
  Provenance provenance;
};

/// What one robot contributes to a map.
struct MapShare {
  std::string robot;
  double body_radius_m = 0.0;
  PlacedSubmaps placed;  ///< In the frame of the merged map.
};

/// Builds the map of several robots from their readings, as a robot builds its own: not from their
/// grids, so that a wall that two robots have measured is one wall.
class MergedMapper {
 public:
  explicit MergedMapper(const mapping::SonarMapperParams& params) : params_(params) {}

  /// Merges all that the robots have published so far. Reuses what has not changed since the last
  /// call.
  MergedMap merge(const std::vector<MapShare>& shares);

 private:
  mapping::SonarMapperParams params_;
  /// A scan of a robot, by indices.
  struct Contribution {
    std::size_t robot = 0;
    std::size_t scan = 0;
  };

  /// Starts again where other robots are in it, or one of them has fewer scans than before.
  void begin_with(const std::vector<MapShare>& shares);

  std::vector<std::string> robots_;
  std::vector<std::size_t> taken_;   ///< How many scans of each.
  std::vector<Contribution> order_;  ///< In which the mapper has them: it knows scans by it.
  std::unique_ptr<mapping::SonarMapper> mapper_;
};

}  // namespace echomap::team_map
