// SPDX-License-Identifier: MIT
#include "host/evaluation/map_alignment.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/point_set.hpp"
#include "host/mapping/pose_climb.hpp"
#include "host/mapping/wall_distance.hpp"

namespace echomap::evaluation {
namespace {

using geometry::Pose2;
using mapping::WallDistance;
using Points = std::vector<Eigen::Vector2d>;

constexpr double kCoarseStepM = 0.1;
constexpr double kCoarseStepRad = 0.0436;  // 2.5 degrees: 0.1 m at 2.3 m.
/// The coarse steps are bridged by walls as wide as this.
constexpr double kCoarseStddevM = 0.15;
constexpr std::size_t kCoarsePoints = 150;
constexpr std::size_t kRefined = 12;
constexpr double kFinestStepM = 0.002;
/// Four coarse standard deviations: walls farther apart do not agree at all.
constexpr double kMaxM = 4.0 * kCoarseStddevM;

double agreement_of(const Points& points_m,
                    const Pose2& T_walls_points,
                    const WallDistance& walls,
                    double stddev_m) {
  double sum = 0.0;
  for (const Eigen::Vector2d& point_m : points_m) {
    const double off = walls.at_m(T_walls_points * point_m) / stddev_m;
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

  double agreement(const Pose2& T_a_b, double stddev_m) const {
    return std::sqrt(agreement_of(b_m, T_a_b, to_a, stddev_m) *
                     agreement_of(a_m, T_a_b.inverse(), to_b, stddev_m));
  }
};

/// The best pose near by.
MapAlignment refined(const MapAlignment& coarse, const Walls& walls, double stddev_m) {
  const mapping::PoseClimbSteps steps{
      0.5 * kCoarseStepM, kFinestStepM, kCoarseStepRad / kCoarseStepM};
  const auto agreement = [&](const Pose2& T_a_b) { return walls.agreement(T_a_b, stddev_m); };
  const Pose2 T_a_b = mapping::climbed(coarse.T_a_b, Eigen::Vector2d::Zero(), steps, agreement);
  return {T_a_b, agreement(T_a_b)};
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
        found.push_back({T_a_b, walls.agreement(T_a_b, kCoarseStddevM)});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& first, const auto& second) {
    return first.agreement > second.agreement;
  });
  return found;
}

}  // namespace

std::optional<MapAlignment> align_maps(const mapping::RasterMap& a,
                                       const mapping::RasterMap& b,
                                       const MapAlignmentParams& params) {
  geometry::ParameterValidator("map alignment")
      .positive("reach_m", params.reach_m)
      .positive("reach_rad", params.reach_rad)
      .positive("wall_stddev_m", params.wall_stddev_m);
  const Points a_m = centers_m(a, mapping::CellState::kOccupied);
  const Points b_m = centers_m(b, mapping::CellState::kOccupied);
  if (a_m.empty() || b_m.empty()) {
    return std::nullopt;
  }
  Walls walls{mapping::some_of(a_m, kCoarsePoints),
              mapping::some_of(b_m, kCoarsePoints),
              WallDistance(a, kMaxM),
              WallDistance(b, kMaxM)};
  auto candidates = coarse_search(walls, mapping::mean_of(b_m), params);
  candidates.resize(std::min(candidates.size(), kRefined));
  walls.a_m = a_m;
  walls.b_m = b_m;
  MapAlignment best;
  for (const MapAlignment& candidate : candidates) {
    const MapAlignment climbed = refined(candidate, walls, params.wall_stddev_m);
    best = climbed.agreement > best.agreement ? climbed : best;
  }
  return best.agreement >= params.min_agreement ? std::optional(best) : std::nullopt;
}

}  // namespace echomap::evaluation
