// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/tile_index.hpp"

namespace echomap::slam {

/// How points become surfaces.
struct SurfaceFieldParams {
  /// Edge of the finest cells, metres. A surface is fitted to 3 x 3 cells: 30 cm are flat indoors.
  double cell_m = 0.1;
  /// Noise of a point across its surface in the finest cells, metres; doubled as the cells are.
  double noise_m = 0.03;
  /// Fewer points make no surface: two always lie on a line.
  int min_points = 3;
};

/// A normal distribution of points around one place, which is a piece of a wall.
struct Surface {
  Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
  /// Inverse covariance (1/m^2) of a point on the surface: xx, xy, yy. Along the surface it is 0,
  /// since where along it a point lies says nothing.
  double information_xx = 0.0;
  double information_xy = 0.0;
  double information_yy = 0.0;

  Eigen::Matrix2d information() const {
    return (Eigen::Matrix2d() << information_xx, information_xy, information_xy, information_yy)
        .finished();
  }
  bool empty() const { return information_xx + information_yy == 0.0; }
};

/// The surfaces that points lie on, at three sizes of cells, each double the one before: normal
/// distributions over overlapping cells (Biber and Strasser 2003), which place a wall much finer
/// than a cell. Cells are found by hashing, so the points may be anywhere. Surfaces are fitted when
/// they are first asked for.
class SurfaceField {
 public:
  static constexpr int kLevels = 3;

  /// Throws std::invalid_argument for invalid parameters.
  explicit SurfaceField(const SurfaceFieldParams& params = {});

  /// Forgets all points.
  void clear();
  void add(std::span<const Eigen::Vector2d> points_m);
  bool empty() const { return levels_[0].cells.empty(); }
  /// The cell of a level that a point, within 2^30 cells, falls into. Within a cell the surface is
  /// one.
  geometry::CellIndex cell_at(const Eigen::Vector2d& point_m, int level) const {
    const double cells_per_m = levels_[static_cast<std::size_t>(level)].cells_per_m;
    return {rounded_down(point_m.x() * cells_per_m), rounded_down(point_m.y() * cells_per_m)};
  }
  /// The surface around a cell of a level, 0 the finest; or, where it has too few points, that
  /// around the next coarser cell that has; empty if none has.
  Surface surface_at(geometry::CellIndex cell, int level);

 private:
  /// Number of points and their moments.
  struct Moments {
    double count = 0.0;
    Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
    double square_xx_m2 = 0.0;
    double square_xy_m2 = 0.0;
    double square_yy_m2 = 0.0;

    void add(const Eigen::Vector2d& point_m);
    void add(const Moments& other);
  };
  struct Cell {
    Moments moments;
    Surface surface;
    std::uint64_t fitted = 0;  ///< At which revision of the field.
  };
  struct Level {
    double cell_m = 0.0;
    double cells_per_m = 0.0;
    double noise_m = 0.0;
    mapping::TileIndex index;
    std::vector<Cell> cells;

    Cell& cell(geometry::CellIndex at);
  };

  /// std::floor is a call where the processor need not have SSE 4.1.
  static std::int32_t rounded_down(double value) {
    const auto towards_zero = static_cast<std::int32_t>(value);
    return towards_zero - (value < towards_zero ? 1 : 0);
  }

  Moments moments_around(const Level& level, geometry::CellIndex middle) const;
  Surface fitted(const Level& level, const Moments& moments) const;

  SurfaceFieldParams params_;
  std::array<Level, kLevels> levels_;
  std::uint64_t revision_ = 1;
};

}  // namespace echomap::slam
