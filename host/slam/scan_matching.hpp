// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <Eigen/Core>

#include "host/localization/pose_gaussian.hpp"
#include "host/slam/surface_field.hpp"

namespace echomap::slam {

/// How points are matched to surfaces.
struct ScanMatchingParams {
  /// A point so many standard deviations from its surface counts a quarter (Geman and McClure).
  double kernel = 3.0;
  double prior_kernel = 3.0;
  /// What one point counts: neighbours err together, and so does the map they are matched to.
  double weight = 0.5;
  int most_coarse_iterations = 2;  ///< On each level but the finest.
  int most_iterations = 4;         ///< On the finest.
  /// A step smaller than this is the last one of a level.
  double least_step_m = 2e-3;
  double least_step_rad = 5e-4;
  /// A match below this share of points on surfaces is tried from other headings, too.
  double good_share = 0.5;
  /// Which are so far to either side: two steps of this.
  double heading_step_rad = 0.12;
};

/// Where points fit.
struct ScanMatch {
  geometry::Pose2 T_map_robot;
  /// What the points say of x, y (m) and heading (rad), without what was believed before.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// Share of the points that lie on surfaces, in [0, 1].
  double share = 0.0;
  /// What was minimised: half the squares of all errors, of the points and of the prior.
  double cost = 0.0;
};

/// Moves points, in the robot's frame, to where they lie on the surfaces of a field: Gauss-Newton
/// on the distances from the normal distributions (Biber and Strasser 2003; Magnusson 2009), from
/// coarse cells to fine ones, with what was believed before as a prior. Directions that the points
/// say nothing of keep the prior's.
class ScanMatcher {
 public:
  /// Throws std::invalid_argument for parameters that make no sense.
  explicit ScanMatcher(const ScanMatchingParams& params = {});

  ScanMatch match(std::span<const Eigen::Vector2d> points_m,
                  const localization::PoseGaussian& prior,
                  SurfaceField& field) const;

 private:
  struct Prior {
    Eigen::Vector3d pose;
    Eigen::Matrix3d information;
  };

  ScanMatch refined(std::span<const Eigen::Vector2d> points_m,
                    const Prior& prior,
                    const Eigen::Vector3d& start,
                    int from_level,
                    SurfaceField& field) const;

  ScanMatchingParams params_;
};

}  // namespace echomap::slam
