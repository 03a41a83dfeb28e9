// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/pose2.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/cell_field.hpp"
#include "host/models/gaussian_patch.hpp"

namespace echomap::mapping {

/// The grid of Hennessey et al., section II.B, and its patches.
struct PatchGridParams {
  CellBounds cells{{0, 0}, {55, 43}};  ///< "A 56 by 44 unit grid".
  double cell_m = 0.05;                ///< "With 5cm resolution".
  models::GaussianPatchParams patch;
};

/// Confidence that something stands in a cell (Hennessey et al., section II.B): 0 at first, 1 on
/// known walls; echoes and bumps add to it, nothing takes it away. Cell (0, 0) begins at the origin
/// of the grid's frame. What falls outside of the grid is left out.
class PatchGrid {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit PatchGrid(const PatchGridParams& params = {});

  /// "We initialize the coordinates corresponding to the playground walls as one": the cells whose
  /// middle is within half a cell of the wall.
  void mark_wall(const geometry::Segment& wall_m);
  /// A patch where the echo would lie on the axis of the beam.
  void add_echo(const geometry::Pose2& T_grid_sonar, double range_m);
  /// Patches along a line where a bumper has met something (models::bumper_line): "each point in
  /// the virtual obstacle is updated with Gaussian kernel".
  void add_bump(const geometry::Segment& line_m);

  /// Takes away what echoes have put into a cone from a sonar on, as far as `range_m`: of what a
  /// beam hears, the nearest thing answers first, so that nothing stands before it. Walls that were
  /// marked and bumps stay. The paper takes nothing away.
  void clear_cone(const geometry::Pose2& T_grid_sonar, double range_m, double beam_half_angle_rad);

  /// Sum over the cells with their middle in a rectangle: from `from_m` to `to_m` ahead of the
  /// pose, half of `width_m` to either side (section II.D, figure 3).
  double sum_ahead(const geometry::Pose2& T_grid_path,
                   double from_m,
                   double to_m,
                   double width_m) const;

  const CellField& confidence() const { return confidence_; }

 private:
  void add_patch(const Eigen::Vector2d& middle_m, CellField& field) const;

  PatchGridParams params_;
  models::GaussianPatch patch_;
  CellField confidence_;
  CellField lasting_;  ///< What of it are walls that were marked, and bumps.
};

}  // namespace echomap::mapping
