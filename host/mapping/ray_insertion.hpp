// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/occupancy_grid.hpp"
#include "host/mapping/ray_fan.hpp"
#include "host/mapping/ray_mask.hpp"

namespace echomap::mapping {

/// The evidence of one scan of thin rays, hundredths of log-odds.
struct RayInsertionParams {
  /// For a cell that a ray ends in, above 0, and for one that rays only cross, below 0: the odds of
  /// 0.7 and 0.4 that Hornung et al. (2013) took for laser scans.
  int hit_centilogits = 85;
  int free_centilogits = -40;
};

/// One beam of a scan: from the sensor to `end_m` in the sensor's frame, x forward. `is_hit` says
/// that it ended at something there, and not at the end of the sensor's range.
struct Ray {
  Eigen::Vector2d end_m = Eigen::Vector2d::Zero();
  bool is_hit = false;
};

/// The longest ray in cells; a longer one is cut there and hits nothing.
constexpr double kMaxRayCells = 1900.0;

/// Adds whole scans of thin rays to an occupancy grid. Each cell gets evidence at most once a scan,
/// and where one ray ends and others pass, the hit counts. Sensor and ends are rounded to 1/256 of
/// a cell. A ray or pose that is not finite adds nothing.
class RayInserter {
 public:
  /// Throws std::invalid_argument for evidence that is not a step of the grid or more.
  explicit RayInserter(const RayInsertionParams& params = {});

  void insert(const geometry::Pose2& T_map_sensor, std::span<const Ray> rays, OccupancyGrid& grid);

 private:
  struct LatticeRay {
    LatticePoint end;
    bool is_hit = false;
  };

  /// Puts the rays on a lattice whose corner is that of cell `origin`.
  void place(const geometry::Pose2& T_map_sensor,
             std::span<const Ray> rays,
             geometry::CellIndex origin,
             double resolution_m);
  /// Marks all rays in a window of the lattice and all hits.
  void mark(LatticePoint sensor, const CellBounds& tiles);
  /// Marks the cells that the rays cross so closely that none is missed.
  void add_fan(LatticePoint sensor);
  void add_to_grid(const CellBounds& tiles, OccupancyGrid& grid) const;

  RayInsertionParams params_;
  std::vector<LatticeRay> rays_;
  std::vector<LatticePoint> directions_;  ///< From the sensor to the ends.
  RayFan fan_;
  RayMask crossed_;
  std::vector<TileBits> hits_;  ///< By the tiles of the window.
};

}  // namespace echomap::mapping
