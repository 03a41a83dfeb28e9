// SPDX-License-Identifier: MIT
#include "host/exploration/loop_closure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/line_extraction.hpp"
#include "host/optimization/gauss_newton.hpp"
#include "host/optimization/normal_equations.hpp"

namespace echomap::exploration {

namespace {

using geometry::Pose2;
using mapping::FittedLine;

/// A place so far beyond the end of a wall is still beside it.
constexpr double kOverhangM = 0.1;
/// The robot goes along a wall, more or less.
constexpr double kSameDirectionRad = 0.6;
/// Errors of the wall sensor last for so long a way.
constexpr double kOneErrorM = 0.1;

/// What moves the end onto the beginning: a turn about `centre_m`, then a shift.
struct Shift {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
  double turn_rad = 0.0;

  Eigen::Vector2d operator()(const Eigen::Vector2d& place_m) const {
    return centre_m + shift_m + Eigen::Rotation2Dd(turn_rad) * (place_m - centre_m);
  }
};

void validate(const LoopClosureParams& params) {
  geometry::ParameterValidator("loop closure")
      .positive("reach_m", params.reach_m)
      .positive("position_stddev_m", params.position_stddev_m)
      .positive("heading_stddev_rad", params.heading_stddev_rad)
      .positive("wall_stddev_m", params.wall_stddev_m)
      .positive("lead_m", params.lead_m)
      .positive("rounds", params.rounds);
}

/// How far a point lies from a wall; empty where it is not beside it, or was walked by another way.
std::optional<double> away_m(const FittedLine& wall, const WallPoint& point) {
  const Eigen::Vector2d offset_m = wall.segment.to_m - wall.segment.from_m;
  const double along_m = offset_m.normalized().dot(point.place_m - wall.segment.from_m);
  const bool is_beside = along_m > -kOverhangM && along_m < offset_m.norm() + kOverhangM;
  const double turn_rad =
      geometry::angle_between(std::atan2(offset_m.y(), offset_m.x()), point.heading_rad);
  return is_beside && std::abs(turn_rad) < kSameDirectionRad
             ? std::optional(geometry::distance_m(wall.segment, point.place_m))
             : std::nullopt;
}

const FittedLine* nearest_wall(const std::vector<FittedLine>& walls,
                               const WallPoint& point,
                               double reach_m) {
  const FittedLine* nearest = nullptr;
  for (const FittedLine& wall : walls) {
    const auto distance_m = away_m(wall, point);
    if (distance_m && *distance_m < reach_m) {
      reach_m = *distance_m;
      nearest = &wall;
    }
  }
  return nearest;
}

/// The points' distances from their walls, and no farther astray than odometry may be.
optimization::NormalEquations<3> linearized(const Shift& shift,
                                            const std::vector<WallPoint>& points,
                                            const std::vector<FittedLine>& walls,
                                            const LoopClosureParams& params) {
  const double position_weight = 1.0 / (params.position_stddev_m * params.position_stddev_m);
  const double heading_weight = 1.0 / (params.heading_stddev_rad * params.heading_stddev_rad);
  const double independent = (points.back().travelled_m - points.front().travelled_m) / kOneErrorM;
  const double wall_weight = std::max(independent, 1.0) / static_cast<double>(points.size()) /
                             (params.wall_stddev_m * params.wall_stddev_m);
  optimization::NormalEquations<3> equations;
  equations.add_prior(
      {shift.shift_m.x(), shift.shift_m.y(), shift.turn_rad},
      Eigen::Vector3d(position_weight, position_weight, heading_weight).asDiagonal());
  for (const WallPoint& point : points) {
    const Eigen::Vector2d place_m = shift(point.place_m);
    const WallPoint moved{place_m, point.travelled_m, point.heading_rad + shift.turn_rad};
    if (const FittedLine* wall = nearest_wall(walls, moved, params.reach_m)) {
      const Eigen::Vector2d across = geometry::unit_vector(wall->normal_rad);
      const Eigen::Vector2d arm_m = place_m - shift.centre_m - shift.shift_m;
      equations.add(across.dot(place_m) - wall->offset_m,
                    {across.x(), across.y(), geometry::cross(arm_m, across)},
                    wall_weight);
    }
  }
  return equations;
}

/// Between the steps the walk is bent by the turn's share of the way, then shifted by its share of
/// what is left.
void bend(std::vector<WallStep>& steps, const Shift& shift, double end_m) {
  std::vector<Pose2> bent;
  Eigen::Vector2d at_m = steps.front().T_map_robot.position_m();
  Eigen::Vector2d before_m = at_m;
  Eigen::Vector2d astray_m = Eigen::Vector2d::Zero();
  for (const WallStep& step : steps) {
    const Pose2& pose = step.T_map_robot;
    const double turn_rad = shift.turn_rad * step.travelled_m / end_m;
    at_m += Eigen::Rotation2Dd(turn_rad) * (pose.position_m() - before_m);
    before_m = pose.position_m();
    bent.emplace_back(at_m.x(), at_m.y(), pose.heading_rad() + turn_rad);
    if (step.travelled_m <= end_m) {
      astray_m = shift(before_m) - at_m;
    }
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Eigen::Vector2d place_m = bent[i].position_m() + steps[i].travelled_m / end_m * astray_m;
    steps[i].T_map_robot = {place_m.x(), place_m.y(), bent[i].heading_rad()};
  }
}

}  // namespace

std::vector<WallStep> closed_walk(std::vector<WallStep> steps,
                                  double round_m,
                                  const Pose2& T_robot_sensor,
                                  const LoopClosureParams& params) {
  validate(params);
  const double first_m = steps.empty() ? 0.0 : steps.back().travelled_m - round_m + params.lead_m;
  std::vector<Eigen::Vector2d> first_places_m;
  std::vector<WallPoint> last;
  for (const WallPoint& point : wall_points(steps, T_robot_sensor)) {
    if (point.travelled_m <= first_m) {
      first_places_m.push_back(point.place_m);
    }
    if (point.travelled_m >= round_m) {
      last.push_back(point);
    }
  }
  mapping::LineExtractionParams straight;
  straight.split_distance_m = 0.02;
  straight.point_stddev_m = params.wall_stddev_m;
  const auto walls = mapping::extract_lines(first_places_m, straight);
  if (walls.empty() || last.empty()) {
    return steps;
  }
  Shift shift;
  double end_m = 0.0;
  for (const WallPoint& point : last) {
    shift.centre_m += point.place_m / static_cast<double>(last.size());
    end_m += point.travelled_m / static_cast<double>(last.size());
  }
  optimization::gauss_newton(
      params.rounds,
      [&] { return linearized(shift, last, walls, params); },
      [&shift](const Eigen::Vector3d& step) {
        shift.shift_m += step.head<2>();
        shift.turn_rad += step.z();
        return false;
      });
  bend(steps, shift, end_m);
  return steps;
}

}  // namespace echomap::exploration
