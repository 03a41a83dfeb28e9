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
  /// So does what was believed before where the points contradict it: wheels slip.
  double prior_kernel = 3.0;
  /// What one point counts: neighbours err together, and so does the map they are matched to.
  double weight = 0.5;
  int max_coarse_iterations = 2;  ///< On each level but the finest.
  int max_iterations = 4;         ///< On the finest.
  /// A step smaller than this is the last one of a level.
  double min_step_m = 2e-3;
  double min_step_rad = 5e-4;
  /// A match with a smaller share of points on surfaces is tried again from coarser cells; and from
  /// other headings where it is poor, or the heading was not known to within `known_heading_rad`:
  /// then more has to lie on surfaces.
  double good_share = 0.75;
  double good_turned_share = 0.9;
  double poor_share = 0.5;
  double known_heading_rad = 0.03;
  /// And is left only for one whose cost is smaller by such a share: new ground fits nothing
  /// rightly.
  double min_saving = 0.3;
  /// The other headings are so many such turns away, to either side.
  int turns = 4;
  double turn_rad = 0.1;
};

/// Where points fit.
struct ScanMatch {
  geometry::Pose2 T_map_robot;
  /// What the points say of x, y (m) and heading (rad), without what was believed before.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// Share of the points that lie on surfaces, in [0, 1].
  double share = 0.0;
  /// Half the squares of all errors: of the points, under their kernel, and of the prior, without
  /// its own, so that where the prior is contradicted, points have to speak for it.
  double cost = 0.0;
};

/// Moves points, in the robot's frame, to where they lie on the surfaces of a field: Gauss-Newton
/// on the distances from the normal distributions (Biber and Strasser 2003; Magnusson 2009), from
/// coarse cells to fine ones, with what was believed before as a prior. Directions that the points
/// say nothing of keep the prior's.
class ScanMatcher {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit ScanMatcher(const ScanMatchingParams& params = {});

  /// Not moved where there are no points or no surfaces.
  ScanMatch match(std::span<const Eigen::Vector2d> points_m,
                  const localization::PoseGaussian& prior,
                  SurfaceField& field) const;
  /// The same where odometry may have jumped: if the match is poor and a good one is found from
  /// where the robot was before, it has stayed there.
  ScanMatch match_after(std::span<const Eigen::Vector2d> points_m,
                        const geometry::Pose2& T_map_before,
                        const localization::PoseGaussian& prior,
                        SurfaceField& field) const;

 private:
  struct Prior {
    Eigen::Vector3d pose;
    Eigen::Matrix3d information;
  };
  /// Of cells, from coarse to fine.
  struct Levels {
    int from = 0;
    int to = 0;
  };

  ScanMatch best_of_starts(std::span<const Eigen::Vector2d> points_m,
                           const Prior& prior,
                           int turns,
                           SurfaceField& field) const;

  ScanMatch refined(std::span<const Eigen::Vector2d> points_m,
                    const Prior& prior,
                    const Eigen::Vector3d& start,
                    const Levels& levels,
                    SurfaceField& field) const;

  ScanMatchingParams params_;
};

}  // namespace echomap::slam
