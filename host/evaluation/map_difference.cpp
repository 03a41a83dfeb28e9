// SPDX-License-Identifier: MIT
#include "host/evaluation/map_difference.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::evaluation {
namespace {

using geometry::CellIndex;
using geometry::Pose2;
using mapping::CellState;
using mapping::RasterMap;

/// Whether a cell of that kind has its centre nearer than `reach_m` to a point.
template <class Is>
bool has_near(const RasterMap& map, const Eigen::Vector2d& point_m, double reach_m, const Is& is) {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(reach_m);
  const CellIndex low = map.cell_at(point_m - reach);
  const CellIndex high = map.cell_at(point_m + reach);
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (is(map.state({x, y})) && (map.center_m({x, y}) - point_m).norm() < reach_m) {
        return true;
      }
    }
  }
  return false;
}

bool is_free(CellState state) { return state == CellState::kFree; }
bool is_not_free(CellState state) { return state != CellState::kFree; }
bool is_occupied(CellState state) { return state == CellState::kOccupied; }

/// Cells of one map's floor that the other has not; true where it has a wall there.
using LostFloor = std::map<CellIndex, bool>;

LostFloor lost_floor(const RasterMap& floor,
                     const RasterMap& other,
                     const Pose2& T_other_floor,
                     const MapDifferenceParams& params) {
  LostFloor lost;
  for (int y = 0; y < floor.rows(); ++y) {
    for (int x = 0; x < floor.columns(); ++x) {
      const Eigen::Vector2d here_m = floor.center_m({x, y});
      const Eigen::Vector2d there_m = T_other_floor * here_m;
      if (is_not_free(floor.state({x, y})) || is_free(other.state(other.cell_at(there_m))) ||
          has_near(floor, here_m, params.border_m, is_not_free)) {
        continue;
      }
      lost[{x, y}] = has_near(other, there_m, params.wall_reach_m, is_occupied) &&
                     !has_near(floor, here_m, params.same_wall_m, is_occupied);
    }
  }
  return lost;
}

/// Takes the piece that `seed` belongs to out of the lost floor.
LostFloor take_piece(LostFloor& lost, CellIndex seed) {
  LostFloor piece;
  std::vector<CellIndex> waiting{seed};
  while (!waiting.empty()) {
    const CellIndex cell = waiting.back();
    waiting.pop_back();
    const auto found = lost.find(cell);
    if (found == lost.end()) {
      continue;
    }
    piece.insert(*found);
    lost.erase(found);
    for (const int y : {-1, 0, 1}) {
      for (const int x : {-1, 0, 1}) {
        waiting.push_back({cell.x + x, cell.y + y});
      }
    }
  }
  return piece;
}

/// Centres of the cells of a piece that are near one of its walls.
std::vector<Eigen::Vector2d> near_walls_m(const LostFloor& piece,
                                          const RasterMap& floor,
                                          double reach_m) {
  std::vector<Eigen::Vector2d> walls_m;
  for (const auto& [cell, has_wall] : piece) {
    if (has_wall) {
      walls_m.push_back(floor.center_m(cell));
    }
  }
  std::vector<Eigen::Vector2d> cells_m;
  for (const auto& [cell, has_wall] : piece) {
    const Eigen::Vector2d center_m = floor.center_m(cell);
    if (std::any_of(walls_m.begin(), walls_m.end(), [&](const Eigen::Vector2d& wall_m) {
          return (wall_m - center_m).norm() < reach_m;
        })) {
      cells_m.push_back(center_m);
    }
  }
  return cells_m;
}

ChangedRegion region_of(const std::vector<Eigen::Vector2d>& cells_m,
                        double cell_m,
                        const MapDifferenceParams& params) {
  ChangedRegion region;
  Eigen::Vector2d low_m = cells_m.front();
  Eigen::Vector2d high_m = low_m;
  for (const Eigen::Vector2d& center_m : cells_m) {
    low_m = low_m.cwiseMin(center_m);
    high_m = high_m.cwiseMax(center_m);
  }
  region.cells_m = cells_m;
  region.center_m = 0.5 * (low_m + high_m);
  region.size_m = high_m - low_m + Eigen::Vector2d::Constant(cell_m);
  region.area_m2 = static_cast<double>(cells_m.size()) * cell_m * cell_m;
  region.confidence = 1.0 - std::exp(-region.area_m2 / params.area_scale_m2);
  return region;
}

/// What stands in `other` on the floor of `floor`; in the frame of the first map.
void add_regions(LostFloor lost,
                 const RasterMap& floor,
                 const Pose2& T_before_floor,
                 const MapDifferenceParams& params,
                 std::vector<ChangedRegion>& regions) {
  while (!lost.empty()) {
    auto cells_m = near_walls_m(take_piece(lost, lost.begin()->first), floor, params.reach_m);
    if (cells_m.empty()) {
      continue;
    }
    for (Eigen::Vector2d& center_m : cells_m) {
      center_m = T_before_floor * center_m;
    }
    const ChangedRegion region = region_of(cells_m, floor.resolution_m(), params);
    if (region.confidence >= params.min_confidence) {
      regions.push_back(region);
    }
  }
}

void validate(const MapDifferenceParams& params) {
  geometry::ParameterValidator("map difference")
      .positive("border_m", params.border_m)
      .positive("same_wall_m", params.same_wall_m)
      .positive("wall_reach_m", params.wall_reach_m)
      .positive("reach_m", params.reach_m)
      .positive("area_scale_m2", params.area_scale_m2);
}

}  // namespace

std::optional<MapDifference> find_difference(const RasterMap& before,
                                             const RasterMap& after,
                                             const MapDifferenceParams& params) {
  validate(params);
  const auto alignment = align_maps(before, after, params.alignment);
  if (!alignment) {
    return std::nullopt;
  }
  const Pose2& T_before_after = alignment->T_a_b;
  const Pose2 T_after_before = T_before_after.inverse();
  MapDifference difference{*alignment, {}};
  auto& regions = difference.regions;
  add_regions(
      lost_floor(after, before, T_before_after, params), after, T_before_after, params, regions);
  for (ChangedRegion& region : regions) {
    region.kind = ChangeKind::kVanished;
  }
  add_regions(lost_floor(before, after, T_after_before, params), before, {}, params, regions);
  std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return a.confidence > b.confidence;
  });
  return difference;
}

}  // namespace echomap::evaluation
