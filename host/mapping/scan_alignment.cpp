// SPDX-License-Identifier: MIT
#include "host/mapping/scan_alignment.hpp"

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/optimization/block_equations.hpp"

namespace echomap::mapping {

namespace {

using geometry::square;

/// Corrections of the scans: x, y in metres, heading in radians.
using Corrections = std::vector<Eigen::Vector3d>;

/// The correction of a scan turns it about its centre.
geometry::Pose2 motion_of(const ScanSurfaces& scan, const Eigen::Vector3d& correction) {
  const Eigen::Vector2d to_m = scan.center_m + correction.head<2>();
  return geometry::Pose2(to_m.x(), to_m.y(), correction.z()) *
         geometry::Pose2(-scan.center_m.x(), -scan.center_m.y(), 0.0);
}

AlignedScans corrected(const std::vector<ScanSurfaces>& scans, const Corrections& by) {
  AlignedScans aligned;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    aligned.T_map_placed.push_back(motion_of(scans[i], by[i]));
    aligned.scans.push_back(moved(scans[i], aligned.T_map_placed.back()));
  }
  return aligned;
}

/// The scans' corrections, then the features. The first scan is where the map begins.
optimization::BlockEquations equations_over(std::size_t scans, std::size_t features) {
  optimization::BlockEquations equations;
  equations.add_fixed_block();
  for (std::size_t i = 1; i < scans; ++i) {
    equations.add_block(3);
  }
  for (std::size_t i = 0; i < features; ++i) {
    equations.add_block(2);
  }
  return equations;
}

/// An error of heading at one stop moves the next stop sideways.
void add_odometry(const std::vector<ScanSurfaces>& odometry,
                  const Corrections& corrections,
                  const ScanAlignmentParams& params,
                  optimization::BlockEquations& equations) {
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const Eigen::Vector2d offset_m = odometry[i].center_m - odometry[i - 1].center_m;
    const double position_stddev =
        params.position_stddev_m + params.position_stddev_per_m * offset_m.norm();
    const double heading_stddev =
        params.heading_stddev_rad + params.heading_stddev_rad_per_m * offset_m.norm();
    Eigen::Matrix3d by_before = -Eigen::Matrix3d::Identity();
    by_before.topRightCorner<2, 1>() = -geometry::perpendicular(offset_m);
    const Eigen::Vector3d residual = corrections[i] + by_before * corrections[i - 1];
    const Eigen::Vector3d variance(
        square(position_stddev), square(position_stddev), square(heading_stddev));
    equations.add<3, 3, 3>(residual,
                           variance.cwiseInverse().asDiagonal(),
                           {i - 1, by_before},
                           {i, Eigen::Matrix3d::Identity()});
  }
}

/// How range and bearing of a feature change with the correction of the scan that sees it: where a
/// stop stands counts as much as where the feature stands, with the opposite sign.
Eigen::Matrix<double, 2, 3> view_by_scan(const FeatureView& view, LandmarkKind kind) {
  const Eigen::Vector2d towards = geometry::unit_vector(view.bearing_rad);
  const double turn_per_m = kind == LandmarkKind::kWall ? 0.0 : 1.0 / view.range_m;
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << -towards.transpose(), 0.0, -turn_per_m * geometry::perpendicular(towards).transpose(),
      -1.0;
  return jacobian;
}

void add_sightings(const std::vector<ScanSurfaces>& placed,
                   const MatchedFeature& matched,
                   std::size_t feature_block,
                   const Eigen::Matrix2d& information,
                   optimization::BlockEquations& equations) {
  for (const auto& [scan, index] : matched.supporters) {
    const SonarSurface& surface = placed[scan].surfaces[index];
    const FeatureView view = view_from(placed[scan].center_m, matched.feature);
    const Eigen::Vector2d residual(view.range_m - surface.range_m,
                                   geometry::angle_between(surface.bearing_rad, view.bearing_rad));
    equations.add<2, 3, 2>(residual,
                           information,
                           {scan, view_by_scan(view, matched.feature.kind)},
                           {feature_block, view.jacobian});
  }
}

std::vector<MatchedFeature> well_supported(std::vector<MatchedFeature> features,
                                           std::size_t min_supporters) {
  std::erase_if(features, [min_supporters](const MatchedFeature& feature) {
    return feature.supporters.size() < min_supporters;
  });
  return features;
}

}  // namespace

AlignedScans align_scans(const std::vector<ScanSurfaces>& scans,
                         const SurfaceMatchingParams& matching,
                         const ScanAlignmentParams& params) {
  Corrections corrections(scans.size(), Eigen::Vector3d::Zero());
  const Eigen::Vector2d variance(square(matching.range_stddev_m),
                                 square(params.bearing_stddev_rad));
  const Eigen::Matrix2d information = variance.cwiseInverse().asDiagonal();
  for (int round = 0; round < params.rounds && scans.size() > 1; ++round) {
    const auto placed = corrected(scans, corrections).scans;
    const auto features =
        well_supported(match_surfaces(placed, matching).features, params.min_supporters);
    auto equations = equations_over(scans.size(), features.size());
    add_odometry(scans, corrections, params, equations);
    for (std::size_t i = 0; i < features.size(); ++i) {
      add_sightings(placed, features[i], scans.size() + i, information, equations);
    }
    if (const auto solution = equations.solve()) {
      for (std::size_t i = 0; i < scans.size(); ++i) {
        corrections[i] += solution->step_of<3>(i);
      }
    }
  }
  return corrected(scans, corrections);
}

}  // namespace echomap::mapping
