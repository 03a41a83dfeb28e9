// SPDX-License-Identifier: MIT
#include "tests/benchmarks/laser_to_sonar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::bench {

namespace {

/// A normal is fitted to points up to this far along the wall, to either side.
constexpr double kNormalReachM = 0.2;
/// Neighbours farther apart are of two things.
constexpr double kGapM = 0.1;
constexpr double kGapSpacings = 4.0;
/// A wall for a second bounce joins neighbours no farther apart than this.
constexpr double kWallGapM = 0.3;
/// A second wall so near is the first one.
constexpr double kSecondWallM = 0.05;
constexpr double kMinRangeM = 0.02;
constexpr double kNeverM = std::numeric_limits<double>::infinity();

/// Where one beam meets something.
struct Hit {
  double bearing_rad = 0.0;
  double range_m = 0.0;
  Eigen::Vector2d point_m;
  /// Empty at an edge.
  std::optional<Eigen::Vector2d> normal;
  bool smooth = false;

  double incidence_rad(const Eigen::Vector2d& direction) const {
    return normal ? std::acos(std::min(1.0, std::abs(normal->dot(direction)))) : 0.0;
  }
};

std::vector<Hit> hits_of(const sensors::RangeScan& laser) {
  std::vector<Hit> hits;
  for (const sensors::Beam& beam : laser.beams) {
    Hit hit;
    hit.bearing_rad = beam.bearing_rad;
    hit.range_m = beam.range_m.value_or(kNeverM);
    hit.point_m.fill(kNeverM);
    if (beam.range_m) {
      hit.point_m = *beam.range_m * geometry::unit_vector(beam.bearing_rad);
    }
    hits.push_back(hit);
  }
  return hits;
}

/// The last of the neighbours, in direction `step`, that belong to one wall with hit `i`.
std::size_t last_neighbour(const std::vector<Hit>& hits, std::size_t i, int step) {
  const double spacing_m = hits[i].range_m * std::abs(hits[1].bearing_rad - hits[0].bearing_rad);
  std::size_t last = i;
  while ((step > 0 ? last + 1 < hits.size() : last > 0) &&
         (hits[last].point_m - hits[i].point_m).norm() <= kNormalReachM) {
    const std::size_t next = step > 0 ? last + 1 : last - 1;
    const double gap_m = (hits[next].point_m - hits[last].point_m).norm();
    if (!(gap_m <= std::max(kGapM, kGapSpacings * spacing_m))) {
      break;
    }
    last = next;
  }
  return last;
}

/// Fits a line to the hit and its neighbours.
void find_normal(std::vector<Hit>& hits, std::size_t i, double smooth_residual_m) {
  const std::size_t first = last_neighbour(hits, i, -1);
  const std::size_t last = last_neighbour(hits, i, 1);
  if (first == i || last == i) {
    return;
  }
  const auto count = static_cast<double>(last - first + 1);
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  for (std::size_t k = first; k <= last; ++k) {
    middle_m += hits[k].point_m / count;
  }
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t k = first; k <= last; ++k) {
    const Eigen::Vector2d offset_m = hits[k].point_m - middle_m;
    scatter += offset_m * offset_m.transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(scatter);
  hits[i].normal = axes.eigenvectors().col(0);
  hits[i].smooth = std::sqrt(std::max(0.0, axes.eigenvalues()[0])) < smooth_residual_m;
}

/// How far a ray goes until it meets the line between two neighbouring hits at a right incidence;
/// infinite where it does not come back.
double second_leg_m(const std::vector<Hit>& hits,
                    const Hit& first,
                    const LaserToSonarParams& params) {
  const Eigen::Vector2d direction = geometry::unit_vector(first.bearing_rad);
  const Eigen::Vector2d mirrored = direction - 2.0 * direction.dot(*first.normal) * *first.normal;
  double nearest_m = kNeverM;
  double back_m = kNeverM;
  for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
    const Eigen::Vector2d edge = hits[i + 1].point_m - hits[i].point_m;
    if (!(edge.norm() <= kWallGapM)) {
      continue;
    }
    const Eigen::Vector2d to_edge = hits[i].point_m - first.point_m;
    const double cross = mirrored.x() * edge.y() - mirrored.y() * edge.x();
    const double distance_m = (to_edge.x() * edge.y() - to_edge.y() * edge.x()) / cross;
    const double share = (to_edge.x() * mirrored.y() - to_edge.y() * mirrored.x()) / cross;
    if (distance_m > kSecondWallM && distance_m < nearest_m && share >= 0.0 && share <= 1.0) {
      nearest_m = distance_m;
      back_m = hits[i].incidence_rad(mirrored) <= params.smooth_limit_rad ? distance_m : kNeverM;
    }
  }
  return back_m;
}

/// From how far away a beam answers; infinite where it does not.
double answer_m(const std::vector<Hit>& hits,
                const Hit& hit,
                const LaserToSonarParams& params,
                std::mt19937& random) {
  if (!std::isfinite(hit.range_m) || hit.range_m > params.max_range_m) {
    return kNeverM;
  }
  const double limit_rad = hit.smooth ? params.smooth_limit_rad : params.rough_limit_rad;
  if (!params.specular || hit.incidence_rad(geometry::unit_vector(hit.bearing_rad)) <= limit_rad) {
    return hit.range_m;
  }
  const bool bounces =
      std::uniform_real_distribution<>(0.0, 1.0)(random) < params.second_bounce_chance;
  return hit.smooth && bounces ? hit.range_m + second_leg_m(hits, hit, params) : kNeverM;
}

/// An answer, and where it came from.
struct Answer {
  double range_m = kNeverM;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
};

/// What one direction hears.
std::optional<Answer> heard(const std::vector<Hit>& hits,
                            double axis_rad,
                            const LaserToSonarParams& params,
                            std::mt19937& random) {
  Answer nearest;
  for (const Hit& hit : hits) {
    if (std::abs(hit.bearing_rad - axis_rad) <= params.beam_half_angle_rad) {
      const double range_m = answer_m(hits, hit, params, random);
      nearest = range_m < nearest.range_m ? Answer{range_m, hit.point_m} : nearest;
    }
  }
  if (nearest.range_m > params.max_range_m) {
    return std::nullopt;
  }
  const double sigma_m = params.noise_m + params.noise_share * nearest.range_m;
  nearest.range_m += std::normal_distribution<>(0.0, 1.0)(random) * sigma_m;
  if (nearest.range_m > params.max_range_m) {
    return std::nullopt;
  }
  nearest.range_m = std::max(nearest.range_m, kMinRangeM);
  return nearest;
}

void check(const sensors::RangeScan& laser, const LaserToSonarParams& params) {
  const bool params_ok = params.directions > 0 && params.beam_half_angle_rad > 0.0 &&
                         params.max_range_m > 0.0 && params.noise_m >= 0.0 &&
                         params.noise_share >= 0.0;
  if (!params_ok || laser.beams.size() < 2) {
    throw std::invalid_argument("laser to sonar: a parameter is out of range");
  }
  const double field_rad = laser.beams.back().bearing_rad - laser.beams.front().bearing_rad;
  if (field_rad <= 0.0) {
    throw std::invalid_argument("laser to sonar: the beams do not go counter-clockwise");
  }
}

}  // namespace

HeardScan heard_scan(const sensors::RangeScan& laser,
                     const LaserToSonarParams& params,
                     std::mt19937& random) {
  check(laser, params);
  std::vector<Hit> hits = hits_of(laser);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (std::isfinite(hits[i].range_m)) {
      find_normal(hits, i, params.smooth_residual_m);
    }
  }
  HeardScan sonar{{laser.stamp_s,
                   laser.T_robot_sensor,
                   {},
                   2.0 * params.beam_half_angle_rad,
                   params.max_range_m},
                  {}};
  const double first_rad = hits.front().bearing_rad;
  const double field_rad = hits.back().bearing_rad - first_rad;
  const auto directions = static_cast<double>(params.directions);
  for (std::size_t k = 0; k < params.directions; ++k) {
    const double axis_rad = first_rad + (static_cast<double>(k) + 0.5) / directions * field_rad;
    const auto answer = heard(hits, axis_rad, params, random);
    sonar.scan.beams.push_back({axis_rad, std::nullopt});
    if (answer) {
      sonar.scan.beams.back().range_m = answer->range_m;
      sonar.origins_m.push_back(answer->origin_m);
    }
  }
  return sonar;
}

}  // namespace echomap::bench
