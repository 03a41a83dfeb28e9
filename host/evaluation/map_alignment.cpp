// SPDX-License-Identifier: MIT
#include "host/evaluation/map_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/evaluation/map_agreement.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using mapping::RasterMap;
using Points = std::vector<Eigen::Vector2d>;

constexpr double kCoarseStepM = 0.1;
constexpr double kCoarseStepRad = 0.0436;  // 2.5 degrees: 0.1 m at 2.3 m.
/// The coarse steps are bridged by walls as wide as this.
constexpr double kCoarseSdM = 0.15;
constexpr std::size_t kCoarsePoints = 150;
constexpr std::size_t kRefined = 12;
constexpr double kFinestStepM = 0.002;
/// Four coarse standard deviations: walls farther apart do not agree at all.
constexpr double kMostM = 4.0 * kCoarseSdM;

/// At most `count` of the points, evenly taken.
Points some_of(const Points& points, std::size_t count) {
  if (points.size() <= count) {
    return points;
  }
  Points some;
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(points[i * points.size() / count]);
  }
  return some;
}

/// How far it is to the nearest occupied cell, between the centres of cells by bilinear
/// interpolation.
class WallDistance {
 public:
  explicit WallDistance(const RasterMap& map) : field_(with_margin(map), kMostM) {}

  double at_m(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d place =
        (point_m - field_.origin_m()) / field_.resolution_m() - Eigen::Vector2d(0.5, 0.5);
    const Eigen::Vector2d low = place.array().floor();
    const bool inside = low.x() >= 0.0 && low.y() >= 0.0 && low.x() + 2.0 <= field_.columns() &&
                        low.y() + 2.0 <= field_.rows();
    if (!inside) {
      return kMostM;
    }
    const auto x = static_cast<int>(low.x());
    const auto y = static_cast<int>(low.y());
    const Eigen::Vector2d share = place - low;
    const auto along = [&](int row) {
      return (1.0 - share.x()) * field_.distance_cells({x, row}) +
             share.x() * field_.distance_cells({x + 1, row});
    };
    return field_.resolution_m() * ((1.0 - share.y()) * along(y) + share.y() * along(y + 1));
  }

 private:
  static RasterMap with_margin(const RasterMap& map) {
    const int margin = static_cast<int>(std::ceil(kMostM / map.resolution_m()));
    return mapping::cut_out(
        map, {{-margin, -margin}, {map.columns() - 1 + margin, map.rows() - 1 + margin}});
  }

  mapping::DistanceField field_;
};

double agreement_of(const Points& points_m,
                    const Pose2& T_walls_points,
                    const WallDistance& walls,
                    double sd_m) {
  double sum = 0.0;
  for (const Eigen::Vector2d& point_m : points_m) {
    const double off = walls.at_m(T_walls_points * point_m) / sd_m;
    sum += std::exp(-0.5 * off * off);
  }
  return sum / static_cast<double>(points_m.size());
}

/// Both maps' walls, as places and as distances, in their own frames.
struct Walls {
  Points a_m;
  Points b_m;
  WallDistance to_a;
  WallDistance to_b;

  double agreement(const Pose2& T_a_b, double sd_m) const {
    return std::sqrt(agreement_of(b_m, T_a_b, to_a, sd_m) *
                     agreement_of(a_m, T_a_b.inverse(), to_b, sd_m));
  }
};

/// Climbs to the best pose near by, by steps that become ever shorter.
MapAlignment refined(MapAlignment best, const Walls& walls, double sd_m) {
  best.agreement = walls.agreement(best.T_a_b, sd_m);
  for (double step_m = 0.5 * kCoarseStepM; step_m > kFinestStepM;) {
    const double step_rad = step_m * kCoarseStepRad / kCoarseStepM;
    bool better = false;
    for (const Eigen::Vector3d& step : {Eigen::Vector3d(step_m, 0, 0),
                                        Eigen::Vector3d(0, step_m, 0),
                                        Eigen::Vector3d(0, 0, step_rad)}) {
      for (const double sign : {1.0, -1.0}) {
        const Pose2 T_a_b(best.T_a_b.x_m() + sign * step.x(),
                          best.T_a_b.y_m() + sign * step.y(),
                          best.T_a_b.heading_rad() + sign * step.z());
        const double agreement = walls.agreement(T_a_b, sd_m);
        if (agreement > best.agreement) {
          best = {T_a_b, agreement};
          better = true;
        }
      }
    }
    step_m *= better ? 1.0 : 0.5;
  }
  return best;
}

/// Poses on the lattice, the best first.
std::vector<MapAlignment> coarse_search(const Walls& walls,
                                        const Eigen::Vector2d& pivot_m,
                                        const MapAlignmentParams& params) {
  const int steps = static_cast<int>(std::ceil(params.reach_m / kCoarseStepM));
  const int turns = static_cast<int>(std::ceil(params.reach_rad / kCoarseStepRad));
  std::vector<MapAlignment> found;
  for (int turn = -turns; turn <= turns; ++turn) {
    // Turns around the middle of the walls, so that it stays within reach.
    const Pose2 turned(0.0, 0.0, turn * kCoarseStepRad);
    const Eigen::Vector2d shift_m = pivot_m - turned * pivot_m;
    for (int x = -steps; x <= steps; ++x) {
      for (int y = -steps; y <= steps; ++y) {
        const Pose2 T_a_b(
            shift_m.x() + x * kCoarseStepM, shift_m.y() + y * kCoarseStepM, turn * kCoarseStepRad);
        found.push_back({T_a_b, walls.agreement(T_a_b, kCoarseSdM)});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& first, const auto& second) {
    return first.agreement > second.agreement;
  });
  return found;
}

Eigen::Vector2d mean_of(const Points& points_m) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point_m : points_m) {
    sum_m += point_m;
  }
  return sum_m / static_cast<double>(points_m.size());
}

}  // namespace

std::optional<MapAlignment> align_maps(const mapping::RasterMap& a,
                                       const mapping::RasterMap& b,
                                       const MapAlignmentParams& params) {
  if (!(params.reach_m > 0.0) || !(params.reach_rad > 0.0) || !(params.wall_sd_m > 0.0)) {
    throw std::invalid_argument("map alignment: reach and wall_sd_m must be above 0");
  }
  const Points a_m = occupied_centers_m(a);
  const Points b_m = occupied_centers_m(b);
  if (a_m.empty() || b_m.empty()) {
    return std::nullopt;
  }
  Walls walls{
      some_of(a_m, kCoarsePoints), some_of(b_m, kCoarsePoints), WallDistance(a), WallDistance(b)};
  auto candidates = coarse_search(walls, mean_of(b_m), params);
  candidates.resize(std::min(candidates.size(), kRefined));
  walls.a_m = a_m;
  walls.b_m = b_m;
  MapAlignment best;
  for (const MapAlignment& candidate : candidates) {
    const MapAlignment climbed = refined(candidate, walls, params.wall_sd_m);
    best = climbed.agreement > best.agreement ? climbed : best;
  }
  return best.agreement >= params.least_agreement ? std::optional(best) : std::nullopt;
}

}  // namespace echomap::evaluation
