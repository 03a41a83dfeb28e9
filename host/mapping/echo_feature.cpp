// SPDX-License-Identifier: MIT
#include "host/mapping/echo_feature.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

/// Between two directions that are tried for a wall's normal.
const double kDirectionStepRad = geometry::radians(4.0);

/// A shorter baseline turns a centimetre of range error into more than four degrees of bearing.
constexpr double kMinBaselineM = 0.15;

WallLine line_of(const EchoFeature& wall) { return {wall.value.y(), wall.value.x()}; }

double offset_m(const Echo& echo, double normal_rad) {
  return wall_through(echo, normal_rad).offset_m;
}

FeatureView view_of_wall_from(const Eigen::Vector2d& sensor_m, const WallLine& wall) {
  const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
  FeatureView view;
  view.range_m = wall.offset_m - normal.dot(sensor_m);
  view.bearing_rad = wall.normal_rad;
  view.jacobian << 1.0, -geometry::perpendicular(normal).dot(sensor_m), 0.0, 1.0;
  return view;
}

FeatureView view_of_point_from(const Eigen::Vector2d& sensor_m, const EchoFeature& point) {
  const Eigen::Vector2d offset_m = point.value - sensor_m;
  const double range_m = offset_m.norm();
  FeatureView view;
  view.range_m = range_m - point.radius_m;
  view.bearing_rad = std::atan2(offset_m.y(), offset_m.x());
  view.jacobian << offset_m.transpose() / range_m,
      geometry::perpendicular(offset_m).transpose() / (range_m * range_m);
  return view;
}

/// Where two circles of range cross, as seen from the first centre towards the second: to the left,
/// then to the right. None where they do not.
std::vector<Eigen::Vector2d> crossings_m(const RangeCircle& first, const RangeCircle& second) {
  const Eigen::Vector2d baseline_m = second.center_m - first.center_m;
  const double length2_m2 = baseline_m.squaredNorm();
  const double squares_m2 = first.range_m * first.range_m - second.range_m * second.range_m;
  const double share = 0.5 * (1.0 + squares_m2 / length2_m2);
  const double height2 = first.range_m * first.range_m / length2_m2 - share * share;
  if (!(height2 > 0.0)) {
    return {};
  }
  const Eigen::Vector2d foot_m = first.center_m + share * baseline_m;
  const Eigen::Vector2d height_m = std::sqrt(height2) * geometry::perpendicular(baseline_m);
  return {foot_m + height_m, foot_m - height_m};
}

/// One wall for each stretch of normals along which the offsets agree, or between which they change
/// sides: there, or in the middle.
void add_walls(const Echo& first,
               const Echo& second,
               const HearingParams& hearing,
               std::vector<EchoFeature>& features) {
  const double apart_rad = geometry::angle_between(first.axis_rad, second.axis_rad);
  const double first_reach_rad = first.beam_half_angle_rad + hearing.max_incidence_rad;
  const double second_reach_rad = second.beam_half_angle_rad + hearing.max_incidence_rad;
  const double from_rad = std::max(-first_reach_rad, apart_rad - second_reach_rad);
  const double to_rad = std::min(first_reach_rad, apart_rad + second_reach_rad);
  const auto difference_m = [&](double turn_rad) {
    return offset_m(first, first.axis_rad + turn_rad) - offset_m(second, first.axis_rad + turn_rad);
  };
  const auto add = [&](double turn_rad) {
    const double normal_rad = geometry::wrap_angle(first.axis_rad + turn_rad);
    features.push_back({LandmarkKind::kWall, {offset_m(first, normal_rad), normal_rad}});
  };
  double before_m = difference_m(from_rad);
  bool was_alike = false;
  double alike_from_rad = from_rad;
  for (double turn_rad = from_rad; turn_rad < to_rad;) {
    const double next_rad = std::min(turn_rad + kDirectionStepRad, to_rad);
    const double after_m = difference_m(next_rad);
    const bool is_alike = std::max(std::abs(before_m), std::abs(after_m)) <= hearing.tolerance_m;
    if (before_m * after_m < 0.0) {
      add(turn_rad + before_m / (before_m - after_m) * (next_rad - turn_rad));
    }
    if (is_alike && !was_alike) {
      alike_from_rad = turn_rad;
    }
    if (is_alike ? next_rad == to_rad : was_alike) {
      add(0.5 * (alike_from_rad + (is_alike ? next_rad : turn_rad)));
    }
    was_alike = is_alike;
    turn_rad = next_rad;
    before_m = after_m;
  }
}

/// Where the two circles of range cross; where they are one, in the middle between the axes.
void add_points(const Echo& first,
                const Echo& second,
                const HearingParams& hearing,
                std::vector<EchoFeature>& features) {
  const auto add_if_heard = [&](const Eigen::Vector2d& point_m) {
    const EchoFeature point{LandmarkKind::kPoint, point_m};
    if (echo_of(point, first, 0.0) && echo_of(point, second, 0.0)) {
      features.push_back(point);
    }
  };
  if ((second.sensor_m - first.sensor_m).norm() > hearing.tolerance_m) {
    for (const Eigen::Vector2d& point_m :
         crossings_m({first.sensor_m, first.range_m}, {second.sensor_m, second.range_m})) {
      add_if_heard(point_m);
    }
  } else if (std::abs(first.range_m - second.range_m) <= hearing.tolerance_m) {
    const double turn_rad = geometry::angle_between(first.axis_rad, second.axis_rad) / 2.0;
    add_if_heard(first.sensor_m + first.range_m * geometry::unit_vector(first.axis_rad + turn_rad));
  }
}

}  // namespace

FeatureView view_from(const Eigen::Vector2d& sensor_m, const EchoFeature& feature) {
  return feature.kind == LandmarkKind::kWall ? view_of_wall_from(sensor_m, line_of(feature))
                                             : view_of_point_from(sensor_m, feature);
}

std::optional<FeatureEcho> echo_of(const EchoFeature& feature,
                                   const Echo& echo,
                                   double max_incidence_rad) {
  FeatureEcho answer{view_from(echo.sensor_m, feature), echo.beam_half_angle_rad};
  if (feature.kind == LandmarkKind::kWall) {
    const WallView in_beam = view_of_wall(echo, line_of(feature));
    answer.range_m = in_beam.range_m;
    answer.jacobian.row(0) = in_beam.by_line.reverse().transpose();
    answer.max_off_axis_rad += max_incidence_rad;
  }
  const double off_axis_rad = std::abs(geometry::angle_between(echo.axis_rad, answer.bearing_rad));
  if (!(answer.range_m > 0.0) || off_axis_rad > answer.max_off_axis_rad) {
    return std::nullopt;
  }
  return answer;
}

double along_m(const EchoFeature& wall, const Echo& echo) {
  const WallView view = view_of_wall(echo, line_of(wall));
  return geometry::perpendicular(geometry::unit_vector(wall.value.y()))
      .dot(echo.sensor_m + view.range_m * geometry::unit_vector(view.contact_rad));
}

std::vector<EchoFeature> features_through(const RangeCircle& first, const RangeCircle& second) {
  const Eigen::Vector2d baseline_m = second.center_m - first.center_m;
  if (baseline_m.norm() < kMinBaselineM) {
    return {};
  }
  std::vector<EchoFeature> features;
  const double cosine = (first.range_m - second.range_m) / baseline_m.norm();
  if (std::abs(cosine) <= 1.0) {
    for (const double sign : {1.0, -1.0}) {
      const double normal_rad =
          std::atan2(baseline_m.y(), baseline_m.x()) + sign * std::acos(cosine);
      const double offset_m = geometry::unit_vector(normal_rad).dot(first.center_m) + first.range_m;
      features.push_back({LandmarkKind::kWall, {offset_m, normal_rad}});
    }
  }
  for (const EchoFeature& point : circles_through(first, second, 0.0)) {
    features.push_back(point);
  }
  return features;
}

std::vector<EchoFeature> circles_through(const RangeCircle& first,
                                         const RangeCircle& second,
                                         double radius_m) {
  std::vector<EchoFeature> circles;
  if ((second.center_m - first.center_m).norm() >= kMinBaselineM) {
    for (const Eigen::Vector2d& middle_m :
         crossings_m({first.center_m, first.range_m + radius_m},
                     {second.center_m, second.range_m + radius_m})) {
      circles.push_back({LandmarkKind::kPoint, middle_m, radius_m});
    }
  }
  return circles;
}

std::vector<EchoFeature> features_through(const Echo& first,
                                          const Echo& second,
                                          const HearingParams& hearing) {
  std::vector<EchoFeature> features;
  add_walls(first, second, hearing, features);
  add_points(first, second, hearing, features);
  return features;
}

}  // namespace echomap::mapping
