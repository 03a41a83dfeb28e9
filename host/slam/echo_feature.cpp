// SPDX-License-Identifier: MIT
#include "host/slam/echo_feature.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

/// Between two directions that are tried for a wall's normal.
const double direction_step_rad = geometry::radians(4.0);

WallLine line_of(const EchoFeature& wall) { return {wall.value.y(), wall.value.x()}; }

FeatureEcho echo_of_wall(const EchoFeature& wall, const Echo& echo, double most_slant_rad) {
  const WallView view = view_of_wall(echo, line_of(wall));
  return {view.range_m,
          view.by_line.reverse(),
          wall.value.y(),
          {0.0, 1.0},
          echo.half_opening_rad + most_slant_rad};
}

FeatureEcho echo_of_point(const Eigen::Vector2d& point_m, const Echo& echo) {
  const Eigen::Vector2d way_m = point_m - echo.sensor_m;
  const double range_m = way_m.norm();
  return {range_m,
          way_m / range_m,
          std::atan2(way_m.y(), way_m.x()),
          quarter_turned(way_m) / (range_m * range_m),
          echo.half_opening_rad};
}

/// How far out the wall with that normal lies that the echo has measured.
double offset_m(const Echo& echo, double normal_rad) {
  const WallView at_origin = view_of_wall(echo, {normal_rad, 0.0});
  return (echo.range_m - at_origin.range_m) / at_origin.by_line[1];
}

/// One wall for each stretch of normals along which the offsets agree, or between which they change
/// sides: there, or in the middle.
void add_walls(const Echo& first,
               const Echo& second,
               const HearingParams& hearing,
               std::vector<EchoFeature>& features) {
  const double apart_rad = geometry::angle_between(first.axis_rad, second.axis_rad);
  const double first_reach_rad = first.half_opening_rad + hearing.most_slant_rad;
  const double second_reach_rad = second.half_opening_rad + hearing.most_slant_rad;
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
    const double next_rad = std::min(turn_rad + direction_step_rad, to_rad);
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
  const Eigen::Vector2d way_m = second.sensor_m - first.sensor_m;
  const double way2_m2 = way_m.squaredNorm();
  if (way_m.norm() <= hearing.tolerance_m) {
    if (std::abs(first.range_m - second.range_m) <= hearing.tolerance_m) {
      const double turn_rad = geometry::angle_between(first.axis_rad, second.axis_rad) / 2.0;
      add_if_heard(first.sensor_m +
                   first.range_m * geometry::unit_vector(first.axis_rad + turn_rad));
    }
    return;
  }
  const double squares_m2 = first.range_m * first.range_m - second.range_m * second.range_m;
  const double share = 0.5 * (1.0 + squares_m2 / way2_m2);
  const double height2 = first.range_m * first.range_m / way2_m2 - share * share;
  if (height2 > 0.0) {
    const Eigen::Vector2d height_m = std::sqrt(height2) * quarter_turned(way_m);
    add_if_heard(first.sensor_m + share * way_m + height_m);
    add_if_heard(first.sensor_m + share * way_m - height_m);
  }
}

}  // namespace

std::optional<FeatureEcho> echo_of(const EchoFeature& feature,
                                   const Echo& echo,
                                   double most_slant_rad) {
  const FeatureEcho answer = feature.kind == LandmarkKind::kWall
                                 ? echo_of_wall(feature, echo, most_slant_rad)
                                 : echo_of_point(feature.value, echo);
  const double off_axis_rad = std::abs(geometry::angle_between(echo.axis_rad, answer.bearing_rad));
  if (!(answer.range_m > 0.0) || off_axis_rad > answer.widest_off_axis_rad) {
    return std::nullopt;
  }
  return answer;
}

double along_m(const EchoFeature& wall, const Echo& echo) {
  const WallView view = view_of_wall(echo, line_of(wall));
  return quarter_turned(geometry::unit_vector(wall.value.y()))
      .dot(echo.sensor_m + view.range_m * geometry::unit_vector(view.contact_rad));
}

std::vector<EchoFeature> features_through(const Echo& first,
                                          const Echo& second,
                                          const HearingParams& hearing) {
  std::vector<EchoFeature> features;
  add_walls(first, second, hearing, features);
  add_points(first, second, hearing, features);
  return features;
}

}  // namespace echomap::slam
