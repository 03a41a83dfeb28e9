// SPDX-License-Identifier: MIT
#include "host/slam/stop_heading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/square.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/slam/mean_turn.hpp"

namespace echomap::slam {

namespace {

using mapping::MatchedWall;

/// Off the edge of the beam by more edges than this, nothing is measured.
constexpr double kMaxEdges = 6.0;
/// An echo that is nearer than a surface by more deviations than this came from before it.
constexpr double kNearerStddevs = 3.0;
/// What hides a point ends so far before it and within the ends of the wall.
constexpr double kHidingShare = 0.97;
constexpr double kHidingEndM = 0.03;
/// Density of echoes from elsewhere, over some metres.
constexpr double kClutterPerM = 0.5;

Eigen::Vector2d center_m(const mapping::Scan& readings) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const mapping::PlacedReading& reading : readings) {
    sum_m += reading.T_map_sonar.position_m();
  }
  return sum_m / static_cast<double>(readings.size());
}

bool extends_to(const MatchedWall& wall, double along_m, double slack_m) {
  return std::any_of(wall.pieces.begin(), wall.pieces.end(), [&](const MatchedWall::Piece& piece) {
    return along_m > piece.from_m - slack_m && along_m < piece.to_m + slack_m;
  });
}

}  // namespace

void validate(const StopHeadingParams& params) {
  geometry::ParameterValidator("stop heading")
      .positive("beam_half_angle_rad", params.beam_half_angle_rad)
      .at_least("max_incidence_rad", params.max_incidence_rad, 0.0)
      .positive("wall_edge_rad", params.wall_edge_rad)
      .positive("post_edge_rad", params.post_edge_rad)
      .positive("clutter_chance", params.clutter_chance)
      .below("clutter_chance", params.clutter_chance, 1.0)
      .within("wall_chance", params.wall_chance, 0.0, 1.0)
      .within("post_chance", params.post_chance, 0.0, 1.0)
      .at_least("min_readings", params.min_readings, 1)
      .positive("range_stddev_m", params.range_stddev_m)
      .positive("step_rad", params.step_rad)
      .at_least("max_turn_rad", params.max_turn_rad, params.step_rad);
}

SonarScene::SonarScene(const mapping::MatchedSurfaces& matched, const StopHeadingParams& params)
    : walls_(matched.walls), params_(params) {
  for (const mapping::MatchedFeature& feature : matched.features) {
    if (feature.feature.kind == mapping::LandmarkKind::kPoint) {
      points_.push_back(feature.feature);
    }
  }
}

bool SonarScene::is_hidden(const Eigen::Vector2d& from_m, const Eigen::Vector2d& point_m) const {
  return std::any_of(walls_.begin(), walls_.end(), [&](const MatchedWall& wall) {
    const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
    const double before_m = normal.dot(from_m) - wall.offset_m;
    const double behind_m = normal.dot(point_m) - wall.offset_m;
    if (before_m * behind_m >= 0.0) {
      return false;
    }
    const double share = before_m / (before_m - behind_m);
    const Eigen::Vector2d crossed_m = from_m + share * (point_m - from_m);
    return share < kHidingShare &&
           extends_to(wall, geometry::perpendicular(normal).dot(crossed_m), -kHidingEndM);
  });
}

std::vector<SonarScene::Facing> SonarScene::facing_from(const Eigen::Vector2d& sonar_m) const {
  std::vector<Facing> facing;
  for (const MatchedWall& wall : walls_) {
    const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
    const double range_m = wall.offset_m - normal.dot(sonar_m);
    if (range_m > 0.0 && range_m < params_.max_range_m &&
        extends_to(wall, geometry::perpendicular(normal).dot(sonar_m), params_.wall_end_m) &&
        !is_hidden(sonar_m, sonar_m + range_m * normal)) {
      facing.push_back({range_m,
                        wall.normal_rad,
                        params_.beam_half_angle_rad + params_.max_incidence_rad,
                        params_.wall_edge_rad,
                        params_.wall_chance,
                        true});
    }
  }
  for (const mapping::EchoFeature& point : points_) {
    const mapping::FeatureView view = view_from(sonar_m, point);
    if (view.range_m > 0.0 && view.range_m < params_.max_range_m &&
        !is_hidden(sonar_m, sonar_m + view.range_m * geometry::unit_vector(view.bearing_rad))) {
      facing.push_back({view.range_m,
                        view.bearing_rad,
                        params_.beam_half_angle_rad,
                        params_.post_edge_rad,
                        point.radius_m > 0.0 ? params_.wall_chance : params_.post_chance,
                        false});
    }
  }
  std::sort(facing.begin(), facing.end(), [](const Facing& a, const Facing& b) {
    return a.range_m < b.range_m;
  });
  return facing;
}

double SonarScene::log_likelihood(const std::vector<Facing>& facing,
                                  double axis_rad,
                                  const std::optional<double>& range_m) const {
  double silent_so_far = 1.0;
  double density_per_m = 0.0;
  for (const Facing& one : facing) {
    const double off_rad = std::abs(geometry::angle_between(axis_rad, one.bearing_rad));
    if (off_rad > one.width_rad + kMaxEdges * one.edge_rad) {
      continue;
    }
    const double chance = one.chance / (1.0 + std::exp((off_rad - one.width_rad) / one.edge_rad));
    if (range_m) {
      const double slant_rad =
          one.is_wall ? std::max(0.0, off_rad - params_.beam_half_angle_rad) : 0.0;
      const double stddevs =
          (*range_m - one.range_m / std::cos(slant_rad)) / params_.range_stddev_m;
      density_per_m += silent_so_far * chance * std::exp(-0.5 * stddevs * stddevs) /
                       (params_.range_stddev_m * std::sqrt(2.0 * std::numbers::pi));
      if (stddevs < -kNearerStddevs) {
        break;
      }
    }
    silent_so_far *= 1.0 - chance;
  }
  const double explained = range_m ? density_per_m : silent_so_far;
  const double unexplained = range_m ? kClutterPerM : 1.0;
  return std::log((1.0 - params_.clutter_chance) * explained +
                  params_.clutter_chance * unexplained);
}

double SonarScene::log_likelihood(const std::vector<Facing>& facing,
                                  const mapping::Scan& readings,
                                  double turn_rad) const {
  double sum = 0.0;
  for (const mapping::PlacedReading& reading : readings) {
    sum += log_likelihood(facing, reading.T_map_sonar.heading_rad() + turn_rad, reading.range_m);
  }
  return sum;
}

double SonarScene::log_likelihood_of(const mapping::Scan& readings) const {
  return log_likelihood(facing_from(center_m(readings)), readings, 0.0);
}

std::vector<double> SonarScene::log_likelihoods_of(const mapping::Scan& readings) const {
  const std::vector<Facing> facing = facing_from(center_m(readings));
  std::vector<double> log_likelihoods;
  log_likelihoods.reserve(readings.size());
  for (const mapping::PlacedReading& reading : readings) {
    log_likelihoods.push_back(
        log_likelihood(facing, reading.T_map_sonar.heading_rad(), reading.range_m));
  }
  return log_likelihoods;
}

std::optional<HeadingEstimate> SonarScene::heading_of(const mapping::Scan& readings) const {
  if (readings.size() < params_.min_readings) {
    return std::nullopt;
  }
  const std::vector<Facing> facing = facing_from(center_m(readings));
  if (facing.empty()) {
    return std::nullopt;
  }
  std::vector<double> log_likelihoods;
  const int steps = static_cast<int>(std::lround(params_.max_turn_rad / params_.step_rad));
  for (int step = -steps; step <= steps; ++step) {
    log_likelihoods.push_back(log_likelihood(facing, readings, step * params_.step_rad));
  }
  const TurnEstimate turn = mean_turn(log_likelihoods, params_.step_rad);
  return HeadingEstimate{
      geometry::wrap_angle(readings.front().T_map_robot.heading_rad() + turn.turn_rad),
      turn.stddev_rad};
}

}  // namespace echomap::slam
