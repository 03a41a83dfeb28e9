// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/slam/odometry_piece.hpp"
#include "host/slam/patch_matching.hpp"

namespace echomap::slam {

/// What odometry and patches are worth. Standard deviations; ours, of the right size for small
/// robots, and checked on logs of others.
struct MultiscanAlignmentParams {
  OdometryNoise odometry;
  /// Of how odometry is off all the time: of a turn, heading over way, of a drive.
  double turn_share_stddev = 0.03;
  double drift_stddev_rad_per_m = 0.05;
  double drive_share_stddev = 0.03;
  /// Of one patch across against another: surfaces are not quite straight.
  double patch_stddev_m = 0.05;
  /// Of a patch's direction, besides what its echoes leave open: measured in simulated rooms.
  double normal_stddev_rad = 0.15;
  /// Patches that are farther apart than this count less and less (Geman and McClure 1985): they
  /// are of different surfaces.
  double max_apart_m = 0.1;
  /// What a match counts. The patches of a multiscan share echoes, and all that are matched with
  /// one surface share its errors: together they know far less than as many measurements.
  double match_weight = 0.075;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const MultiscanAlignmentParams& params);

/// What is estimated: where multiscans began, and how odometry is off.
struct MultiscanGraph {
  std::vector<PlacedPatches> multiscans;
  /// `pieces[i]` leads from multiscan i to i + 1.
  std::vector<OdometryPiece> pieces;
  OdometryCalibration calibration;
  /// How much worse this odometry is than the parameters say: a factor of its deviations by chance.
  double odometry_scale = 1.0;
  /// The same for what is off all the time.
  double steady_scale = 1.0;
};

/// What one step of alignment has found.
struct AlignmentStep {
  /// Of the last multiscan's x, y and heading in the map frame, given what is not free; that of
  /// before where it cannot be told.
  Eigen::Matrix3d last_covariance;
  /// Minus twice the logarithm of how likely all measurements were before the step, by the method
  /// of Laplace, without what does not depend on the graph. A patch that is not matched surprises
  /// like one that lies endlessly far from its match.
  double negative_log_evidence = 0.0;
};

/// What a match measures: how far one patch lies across the other.
struct PatchFactor {
  double across_m = 0.0;
  /// By x, y and heading of the two multiscans in the map frame.
  Eigen::RowVector3d by_later = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d by_earlier = Eigen::RowVector3d::Zero();
  double information_per_m2 = 0.0;
  double max_apart_m = 0.0;    ///< Patches that are farther apart count less and less.
  double robust_weight = 1.0;  ///< Robust weight: the share of the information that is left because
                               ///< the patches are far apart.
};

/// Where the multiscans are; `first_wide` as below.
PatchFactor patch_factor(const MultiscanGraph& graph,
                         const PatchMatch& match,
                         std::size_t first_wide,
                         const MultiscanAlignmentParams& params);

/// Makes one step of Gauss and Newton: least squares over the poses of the multiscans from
/// `first_free` (at least 1: the first one holds the map) on, with the odometry between them and
/// the matches as measurements (graph SLAM; Thrun, Burgard and Fox 2005, chapter 11). Where all but
/// the first are free, the calibration of the odometry is estimated, too. Matches of multiscans
/// from `first_wide` on may be as far apart as their places are unknown.
AlignmentStep align_multiscans(MultiscanGraph& graph,
                               const std::vector<PatchMatch>& matches,
                               std::size_t first_free,
                               std::size_t first_wide,
                               const MultiscanAlignmentParams& params);

}  // namespace echomap::slam
