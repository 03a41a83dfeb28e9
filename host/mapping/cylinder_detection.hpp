// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace echomap::mapping {

/// What stands alone in a scan and is as wide as the cylinders that are looked for; ours.
struct CylinderDetectionParams {
  double radius_m = 0.045;
  /// Neighbours on one cylinder are not farther apart than this.
  double max_gap_m = 0.05;
  /// What is seen beside a cylinder lies at least this far behind it.
  double min_step_m = 0.1;
  /// The seen width may be less or more than the diameter by this: beams that pass, and noise.
  double width_tolerance_m = 0.035;
  std::size_t min_points = 3;
};

/// Centres of upright cylinders in a laser scan. `points_m` are the returns of one scan in the
/// sensor's frame, in the order of their bearings; beams without return are left out. The centre
/// lies on the mean bearing of a cylinder's points, and behind their mean range by pi / 4 radii:
/// what a disc that is met evenly across its width is nearer than its centre. Throws
/// std::invalid_argument for invalid parameters.
std::vector<Eigen::Vector2d> find_cylinders(std::span<const Eigen::Vector2d> points_m,
                                            const CylinderDetectionParams& params = {});

}  // namespace echomap::mapping
