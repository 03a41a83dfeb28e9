// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// Values without another source are ours, chosen in simulation.
struct CostGridParams {
  /// From the middle of the axle to the farthest part of the hull (robot profile).
  double robot_radius_m = 0.09;
  /// Floor to be left between the hull and the centre of an occupied cell: half a cell and the
  /// noise of a wall on the map.
  double clearance_m = 0.04;
  /// Beyond that, floor costs more the nearer it is to what is not free, up to here.
  double wary_m = 0.20;
  /// Cost of a metre right beside what is not free, for one of open floor as 1; up to 30.
  double dearest = 3.0;
  /// The robot stands where it stands, whatever the map says: no farther from it than this, all but
  /// occupied cells are open.
  double standing_m = 0.20;
};

/// What a metre of way costs in each cell of a map, for the middle of a round robot. Occupied cells
/// are closed, and so is the floor from where its hull would reach them. Unknown floor is closed
/// itself, but the hull may reach over it at the highest price: most of what a sonar leaves unknown
/// beside free floor is floor. An unknown strip of a few cells between free ones is a ford, a gap
/// between two beams, and counts as free.
class CostGrid {
 public:
  /// The cost of open floor; 0 is closed.
  static constexpr std::uint8_t kPlain = 8;

  /// `here_m` is where the robot stands. Throws std::invalid_argument for invalid parameters.
  CostGrid(const mapping::RasterMap& map,
           const Eigen::Vector2d& here_m,
           const CostGridParams& params);

  /// Opens, at the highest price, the cells within `reach_m` of where the middle of the robot has
  /// been, but for occupied ones of `map`: it fits through the door that it came by, however narrow
  /// the map has it.
  void open_along(const mapping::RasterMap& map,
                  const std::vector<Eigen::Vector2d>& been_m,
                  double reach_m,
                  const CostGridParams& params);

  /// Makes the open cells within `radius_m` of a point cost at least so many times open floor, up
  /// to 30: somebody stands there who may have left when the robot comes.
  void raise_around(const Eigen::Vector2d& at_m, double radius_m, double factor);
  /// Closes the cells within `radius_m` of a point: somebody stands there who stays.
  void close_around(const Eigen::Vector2d& at_m, double radius_m);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double resolution_m() const { return resolution_m_; }
  geometry::CellIndex cell_at(const Eigen::Vector2d& point_m) const;
  Eigen::Vector2d center_m(geometry::CellIndex cell) const;
  bool contains(geometry::CellIndex cell) const {
    return cell.x >= 0 && cell.x < columns_ && cell.y >= 0 && cell.y < rows_;
  }
  bool is_open(geometry::CellIndex cell) const {
    return contains(cell) && costs_[index(cell)] != 0;
  }

  /// All cells and a closed border around them, row by row: the eight neighbours of a cell inside
  /// can be read without a look at where it is.
  const std::vector<std::uint8_t>& costs() const { return costs_; }
  std::int32_t stride() const { return columns_ + 2; }
  std::size_t index(geometry::CellIndex cell) const {
    return static_cast<std::size_t>(cell.y + 1) * static_cast<std::size_t>(stride()) +
           static_cast<std::size_t>(cell.x + 1);
  }
  geometry::CellIndex cell(std::size_t index) const {
    const auto at = static_cast<std::int32_t>(index);
    return {at % stride() - 1, at / stride() - 1};
  }

 private:
  /// Calls `change` with the cost of each open cell within `radius_m` of a point.
  template <class Change>
  void change_around(const Eigen::Vector2d& at_m, double radius_m, Change change);
  void inflate(const mapping::RasterMap& map, const CostGridParams& params);
  void open_around(const mapping::RasterMap& map,
                   geometry::CellIndex middle,
                   double reach_m,
                   const CostGridParams& params);

  int columns_;
  int rows_;
  double resolution_m_;
  Eigen::Vector2d origin_m_;
  std::vector<std::uint8_t> costs_;
};

}  // namespace echomap::exploration
