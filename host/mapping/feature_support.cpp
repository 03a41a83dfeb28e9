// SPDX-License-Identifier: MIT
#include "host/mapping/feature_support.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/optimization/gauss_newton.hpp"
#include "host/optimization/normal_equations.hpp"

namespace echomap::mapping {
namespace {

constexpr int kFitSteps = 3;
/// Standard deviation of a radius before the fit.
constexpr double kRadiusStddevM = 0.1;
constexpr double kMinRadiusM = 0.02;

bool is_wall(const EchoFeature& feature) { return feature.kind == LandmarkKind::kWall; }

}  // namespace

void validate(const SurfaceMatchingParams& params) {
  geometry::ParameterValidator("surface matching")
      .positive("range_tolerance_m", params.range_tolerance_m)
      .positive("wall_bearing_tolerance_rad", params.wall_bearing_tolerance_rad)
      .positive("post_bearing_tolerance_rad", params.post_bearing_tolerance_rad)
      .at_least("foot_tolerance_m", params.foot_tolerance_m, 0.0)
      .positive("range_stddev_m", params.range_stddev_m)
      .positive("bearing_stddev_rad", params.bearing_stddev_rad)
      .positive("full_readings", params.full_readings)
      .positive("one_sided_rad", params.one_sided_rad)
      .at_least("contradiction_weight", params.contradiction_weight, 0.0)
      .positive("contradiction_half_angle_rad", params.contradiction_half_angle_rad)
      .at_least("contradiction_m", params.contradiction_m, 0.0)
      .positive("contradiction_range_m", params.contradiction_range_m)
      .at_least("max_radius_m", params.max_radius_m, kMinRadiusM)
      .at_least("settled_sightings", params.settled_sightings, 2)
      .require(std::all_of(params.radii_m.begin(),
                           params.radii_m.end(),
                           [](double radius_m) { return radius_m > 0.0; }),
               "radii_m are above 0");
}

Sighting sighting_of(const ScanSurfaces& scan, std::size_t scan_index, std::size_t index) {
  const SonarSurface& surface = scan.surfaces[index];
  return {scan_index,
          index,
          scan.center_m,
          surface,
          scan.center_m + surface.range_m * geometry::unit_vector(surface.bearing_rad)};
}

FeatureGauge::FeatureGauge(const EchoFeature& feature, const SurfaceMatchingParams& params)
    : feature_(feature), normal_(geometry::unit_vector(feature.value.y())), params_(params) {}

double FeatureGauge::range_m(const Eigen::Vector2d& from_m) const {
  return is_wall(feature_) ? feature_.value.x() - normal_.dot(from_m)
                           : (feature_.value - from_m).norm() - feature_.radius_m;
}

double FeatureGauge::bearing_rad(const Eigen::Vector2d& from_m) const {
  const Eigen::Vector2d offset_m = feature_.value - from_m;
  return is_wall(feature_) ? feature_.value.y() : std::atan2(offset_m.y(), offset_m.x());
}

std::optional<double> FeatureGauge::misfit_m(const Sighting& sighting) const {
  const double misfit_m = std::abs(range_m(sighting.center_m) - sighting.surface.range_m);
  if (misfit_m > params_.range_tolerance_m) {
    return std::nullopt;
  }
  const double off_rad = std::abs(
      geometry::angle_between(bearing_rad(sighting.center_m), sighting.surface.bearing_rad));
  const double tolerance_rad =
      is_wall(feature_) ? params_.wall_bearing_tolerance_rad : params_.post_bearing_tolerance_rad;
  return off_rad > tolerance_rad ? std::nullopt : std::optional(misfit_m);
}

double FeatureGauge::weight(const Sighting& sighting, double misfit_m) const {
  const auto readings = static_cast<double>(sighting.surface.readings);
  const double relative = misfit_m / params_.range_tolerance_m;
  const bool looks_like_wall = sighting.surface.half_length_m > 0.0;
  const bool is_of_kind = looks_like_wall == is_wall(feature_) || feature_.radius_m > 0.0;
  return std::min(1.0, readings / params_.full_readings) *
         (1.0 - 0.5 * geometry::square(relative)) * (is_of_kind ? 1.0 : params_.other_kind_weight);
}

double seen_over_rad(const Eigen::Vector2d& point_m, const std::vector<Sighting>& from) {
  double low_rad = 0.0;
  double high_rad = 0.0;
  std::optional<double> first_rad;
  for (const Sighting& sighting : from) {
    const Eigen::Vector2d offset_m = sighting.center_m - point_m;
    const double bearing_rad = std::atan2(offset_m.y(), offset_m.x());
    first_rad = first_rad.value_or(bearing_rad);
    const double off_rad = geometry::angle_between(*first_rad, bearing_rad);
    low_rad = std::min(low_rad, off_rad);
    high_rad = std::max(high_rad, off_rad);
  }
  return high_rad - low_rad;
}

EchoFeature fitted(EchoFeature feature,
                   const std::vector<Sighting>& sightings,
                   const SurfaceMatchingParams& params) {
  const Eigen::Vector2d variance(geometry::square(params.range_stddev_m),
                                 geometry::square(params.bearing_stddev_rad));
  const Eigen::Matrix2d information = variance.cwiseInverse().asDiagonal();
  const double proposed_m = feature.radius_m;
  const bool is_round = proposed_m > 0.0;
  const auto linearize = [&] {
    optimization::NormalEquations<3> equations;
    for (const Sighting& sighting : sightings) {
      const FeatureView view = view_from(sighting.center_m, feature);
      const Eigen::Vector2d residual(
          view.range_m - sighting.surface.range_m,
          geometry::angle_between(sighting.surface.bearing_rad, view.bearing_rad));
      Eigen::Matrix<double, 2, 3> jacobian;
      jacobian << view.jacobian, Eigen::Vector2d(is_round ? -1.0 : 0.0, 0.0);
      equations.add<2>(residual, jacobian, information);
    }
    equations.add(feature.radius_m - proposed_m,
                  Eigen::RowVector3d::UnitZ(),
                  1.0 / geometry::square(kRadiusStddevM));
    return equations;
  };
  optimization::gauss_newton(kFitSteps, linearize, [&](const Eigen::Vector3d& step) {
    feature.value += step.head<2>();
    if (is_round) {
      feature.radius_m = std::clamp(feature.radius_m + step.z(), kMinRadiusM, params.max_radius_m);
    }
    return false;
  });
  return feature;
}

}  // namespace echomap::mapping
