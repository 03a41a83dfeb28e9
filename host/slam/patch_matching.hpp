// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/surface_patch.hpp"

namespace echomap::slam {

/// When two patches of different multiscans may be the same surface. Ours.
struct PatchMatchingParams {
  /// Not farther apart than this along the surface.
  double along_m = 0.5;
  /// What surfaces are off across themselves, besides what is not known of where the robot was;
  /// three times both together is too far.
  double across_stddev_m = 0.1;
  /// More is never believed of what is not known.
  double max_place_stddev_m = 0.3;
  double max_angle_rad = 0.5;
  /// Multiscans that lie farther apart than this in time are different visits.
  std::size_t visit_multiscans = 20;
  /// A patch is compared with so many others of its visit, the latest, and so many of earlier
  /// visits, spread over them.
  std::size_t max_partners = 4;
};

/// Throws std::invalid_argument for invalid parameters.
void validate(const PatchMatchingParams& params);

/// A multiscan as the map has it.
struct PlacedPatches {
  geometry::Pose2 T_map_begin;
  std::vector<SurfacePatch> patches;
  /// Of x, y and heading, when it was the newest.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// A patch by the multiscan that it is of.
struct PatchIndex {
  std::size_t multiscan = 0;
  std::size_t patch = 0;
};

/// Two patches that may be of one surface.
struct PatchMatch {
  PatchIndex later;
  PatchIndex earlier;
  bool is_revisit = false;
  /// How far they may lie apart across because one of them is of an earlier visit.
  double place_stddev_m = 0.0;
};

/// Pairs every patch of the multiscans from `first` on with patches before it that lie near, look
/// the same way and are of other multiscans: the nearest of each.
std::vector<PatchMatch> match_patches(const std::vector<PlacedPatches>& multiscans,
                                      std::size_t first,
                                      const PatchMatchingParams& params);

}  // namespace echomap::slam
