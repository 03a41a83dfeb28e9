// SPDX-License-Identifier: MIT
#include "host/mapping/scan_alignment.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {

namespace {

/// Corrections of the scans: x, y in metres, heading in radians, three rows a scan.
using Corrections = Eigen::VectorXd;

Eigen::Index row_of_scan(std::size_t scan) { return 3 * static_cast<Eigen::Index>(scan); }

/// The correction of a scan turns it about its centre.
geometry::Pose2 motion_of(const ScanSurfaces& scan, const Eigen::Vector3d& correction) {
  const Eigen::Vector2d to_m = scan.center_m + correction.head<2>();
  return geometry::Pose2(to_m.x(), to_m.y(), correction.z()) *
         geometry::Pose2(-scan.center_m.x(), -scan.center_m.y(), 0.0);
}

AlignedScans corrected(const std::vector<ScanSurfaces>& scans, const Corrections& by) {
  AlignedScans aligned;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    aligned.T_map_placed.push_back(motion_of(scans[i], by.segment<3>(row_of_scan(i))));
    aligned.scans.push_back(moved(scans[i], aligned.T_map_placed.back()));
  }
  return aligned;
}

/// The normal equations of one step of Gauss and Newton over scans and features.
class NormalEquations {
 public:
  NormalEquations(std::size_t scans, std::size_t features)
      : scans_(scans),
        information_(Eigen::MatrixXd::Zero(size(features), size(features))),
        gradient_(Eigen::VectorXd::Zero(size(features))) {
    // The first scan is where the map begins.
    constexpr double kFixed = 1e12;
    information_.diagonal().head<3>().setConstant(kFixed);
  }

  Eigen::Index row_of_feature(std::size_t feature) const {
    return row_of_scan(scans_) + 2 * static_cast<Eigen::Index>(feature);
  }

  /// Adds a residual with its derivatives by the blocks that begin at rows `a` and `b`.
  template <int kA, int kB>
  void add(double residual,
           double sd,
           Eigen::Index a,
           const Eigen::Matrix<double, 1, kA>& by_a,
           Eigen::Index b,
           const Eigen::Matrix<double, 1, kB>& by_b) {
    const double weight = 1.0 / (sd * sd);
    information_.block<kA, kA>(a, a) += weight * by_a.transpose() * by_a;
    information_.block<kB, kB>(b, b) += weight * by_b.transpose() * by_b;
    information_.block<kA, kB>(a, b) += weight * by_a.transpose() * by_b;
    information_.block<kB, kA>(b, a) += weight * by_b.transpose() * by_a;
    gradient_.segment<kA>(a) += weight * residual * by_a.transpose();
    gradient_.segment<kB>(b) += weight * residual * by_b.transpose();
  }

  /// The change of the scans' corrections.
  Corrections solve() const {
    return -information_.ldlt().solve(gradient_).head(row_of_scan(scans_));
  }

 private:
  Eigen::Index size(std::size_t features) const { return row_of_feature(features); }

  std::size_t scans_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
};

/// An error of heading at one stop moves the next stop sideways.
void add_odometry(const std::vector<ScanSurfaces>& odometry,
                  const Corrections& corrections,
                  const ScanAlignmentParams& params,
                  NormalEquations& equations) {
  using Row = Eigen::Matrix<double, 1, 3>;
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const Eigen::Index here = row_of_scan(i);
    const Eigen::Index before = row_of_scan(i - 1);
    const Eigen::Vector2d way_m = odometry[i].center_m - odometry[i - 1].center_m;
    const Eigen::Vector2d sideways_m(-way_m.y(), way_m.x());
    const double position_sd = params.position_sd_m + params.position_sd_per_m * way_m.norm();
    const double heading_sd = params.heading_sd_rad + params.heading_sd_rad_per_m * way_m.norm();
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const double residual = corrections[here + axis] - corrections[before + axis] -
                              corrections[before + 2] * sideways_m[axis];
      Row by_before = -Row::Unit(axis);
      by_before[2] = -sideways_m[axis];
      equations.add<3, 3>(residual, position_sd, before, by_before, here, Row::Unit(axis));
    }
    equations.add<3, 3>(corrections[here + 2] - corrections[before + 2],
                        heading_sd,
                        before,
                        -Row::Unit(2),
                        here,
                        Row::Unit(2));
  }
}

struct PlacedSighting {
  const ScanSurfaces& scan;
  const SonarSurface& surface;
  Eigen::Index row;
};

/// Where a stop stands counts for what it sees as much as where the feature stands, with the
/// opposite sign.
void add_sighting(const PlacedSighting& sighting,
                  const SonarFeature& feature,
                  Eigen::Index feature_row,
                  double range_sd_m,
                  double bearing_sd_rad,
                  NormalEquations& equations) {
  const FeatureView view = view_from(sighting.scan.center_m, feature);
  const Eigen::Vector2d towards(std::cos(view.bearing_rad), std::sin(view.bearing_rad));
  const Eigen::RowVector3d range_by_scan(-towards.x(), -towards.y(), 0.0);
  equations.add<3, 2>(view.range_m - sighting.surface.range_m,
                      range_sd_m,
                      sighting.row,
                      range_by_scan,
                      feature_row,
                      view.jacobian.row(1));
  const double turn_per_m = feature.is_wall ? 0.0 : 1.0 / view.range_m;
  const Eigen::RowVector3d bearing_by_scan(
      turn_per_m * towards.y(), -turn_per_m * towards.x(), -1.0);
  equations.add<3, 2>(geometry::angle_between(sighting.surface.bearing_rad, view.bearing_rad),
                      bearing_sd_rad,
                      sighting.row,
                      bearing_by_scan,
                      feature_row,
                      view.jacobian.row(0));
}

std::vector<MatchedFeature> well_supported(std::vector<MatchedFeature> features,
                                           std::size_t least_supporters) {
  std::erase_if(features, [least_supporters](const MatchedFeature& feature) {
    return feature.supporters.size() < least_supporters;
  });
  return features;
}

}  // namespace

AlignedScans align_scans(const std::vector<ScanSurfaces>& scans,
                         const SurfaceMatchingParams& matching,
                         const ScanAlignmentParams& params) {
  Corrections corrections = Corrections::Zero(row_of_scan(scans.size()));
  for (int round = 0; round < params.rounds && scans.size() > 1; ++round) {
    const auto placed = corrected(scans, corrections).scans;
    const MatchedSurfaces matched = match_surfaces(placed, matching);
    const auto features = well_supported(matched.features, params.least_supporters);
    NormalEquations equations(scans.size(), features.size());
    add_odometry(scans, corrections, params, equations);
    for (std::size_t i = 0; i < features.size(); ++i) {
      for (const auto& [scan, index] : features[i].supporters) {
        add_sighting({placed[scan], placed[scan].surfaces[index], row_of_scan(scan)},
                     features[i].feature,
                     equations.row_of_feature(i),
                     matching.range_sd_m,
                     params.bearing_sd_rad,
                     equations);
      }
    }
    corrections += equations.solve();
  }
  return corrected(scans, corrections);
}

}  // namespace echomap::mapping
