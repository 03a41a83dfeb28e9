// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// The cells that a straight piece runs through.
std::set<CellIndex> cells_along(const OccupancyGrid& grid,
                                const Eigen::Vector2d& from_m,
                                const Eigen::Vector2d& to_m) {
  constexpr double kStepsPerCell = 5.0;
  const double length_m = (to_m - from_m).norm();
  const int steps = 1 + static_cast<int>(kStepsPerCell * length_m / grid.resolution_m());
  std::set<CellIndex> cells;
  for (int i = 0; i <= steps; ++i) {
    cells.insert(grid.cell_at(from_m + static_cast<double>(i) / steps * (to_m - from_m)));
  }
  return cells;
}

/// An echo from where no floor ends came another way.
bool borders_floor(const OccupancyGrid& floor, CellIndex cell) {
  for (std::int32_t y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (std::int32_t x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (floor.state({x, y}) == CellState::kFree) {
        return true;
      }
    }
  }
  return false;
}

/// How a scan has moved as a whole; empty where it was bent by more than a fraction of what a sonar
/// tells, or is another one.
std::optional<geometry::Pose2> rigid_motion(const Scan& from, const Scan& to) {
  constexpr double kBentM = 0.003;
  constexpr double kBentRad = 0.003;
  if (from.empty() || from.size() != to.size()) {
    return std::nullopt;
  }
  const geometry::Pose2 T_to_from = to.front().T_map_sonar * from.front().T_map_sonar.inverse();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const geometry::Pose2 off = to[i].T_map_sonar.inverse() * T_to_from * from[i].T_map_sonar;
    if (from[i].range_m != to[i].range_m || off.position_m().norm() > kBentM ||
        std::abs(off.heading_rad()) > kBentRad) {
      return std::nullopt;
    }
  }
  return T_to_from;
}

}  // namespace

SonarMapper::SonarMapper(const SonarMapperParams& params) : params_(params) {
  const auto& surfaces = params.surfaces;
  geometry::ParameterValidator("sonar mapper")
      .positive("surfaces.beam_half_angle_rad", surfaces.beam_half_angle_rad)
      .at_most("surfaces.beam_half_angle_rad", surfaces.beam_half_angle_rad, kMaxBeamHalfAngleRad)
      .positive("surfaces.depth_tolerance_m", surfaces.depth_tolerance_m)
      .at_least("floor.margin_m", params.floor.margin_m, 0.0)
      .positive("fade_m", params.fade_m)
      .positive("matching.range_tolerance_m", params.matching.range_tolerance_m)
      .positive("free_centilogits", params.free_centilogits)
      .positive("occupied_centilogits", params.occupied_centilogits)
      .at_least("post_centilogits", params.post_centilogits, 0)
      .positive("matched_centilogits", params.matched_centilogits);
}

void SonarMapper::add(const Scan& scan) {
  scans_.push_back({scan, find_surfaces(scan, params_.surfaces)});
  std::vector<ScanSurfaces> placed;
  placed.reserve(scans_.size());
  for (const KnownScan& known : scans_) {
    placed.push_back(known.surfaces);
  }
  match(placed);
}

void SonarMapper::take(const std::vector<Scan>& scans) {
  scans_.resize(scans.size());
  std::vector<ScanSurfaces> placed;
  placed.reserve(scans_.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const auto T_new_old = rigid_motion(scans_[i].readings, scans[i]);
    if (!T_new_old) {
      scans_[i] = {scans[i], find_surfaces(scans[i], params_.surfaces)};
    }
    placed.push_back(moved(scans_[i].surfaces, T_new_old.value_or(geometry::Pose2())));
  }
  match(placed);
}

void SonarMapper::match(const std::vector<ScanSurfaces>& placed) {
  const AlignedScans aligned = align_scans(placed, params_.matching, params_.alignment);
  T_map_placed_ = aligned.T_map_placed;
  matched_ = match_surfaces(aligned.scans, params_.matching);
}

OccupancyGrid SonarMapper::grid() const {
  OccupancyGrid floor(params_.grid);
  const auto walls = joined_at_corners(matched_.walls, matched_.scans, params_.corners);
  const CellSet solid = solid_cells(floor);
  for (const auto& scan : matched_.scans) {
    add_floor(scan, walls, solid, floor);
  }
  OccupancyGrid grid = floor;
  for (const auto& scan : matched_.scans) {
    add_surfaces(scan, floor, grid);
  }
  for (const CellIndex cell : solid) {
    if (borders_floor(floor, cell)) {
      grid.add(cell, params_.matched_centilogits);
    }
  }
  return grid;
}

SonarFeatures SonarMapper::features() const {
  SonarFeatures features;
  for (const MatchedWall& wall : joined_at_corners(matched_.walls, matched_.scans, params_.corners)) {
    const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
    const Eigen::Vector2d along = geometry::perpendicular(normal);
    const Eigen::Vector2d foot_m = wall.offset_m * normal;
    for (const auto& piece : wall.pieces) {
      features.walls.push_back({foot_m + piece.from_m * along, foot_m + piece.to_m * along});
    }
  }
  return features;
}

void SonarMapper::add_floor(const ScanSurfaces& scan,
                            const std::vector<MatchedWall>& walls,
                            const CellSet& solid,
                            OccupancyGrid& grid) const {
  const StopFloor floor(scan, walls, params_.surfaces, params_.floor);
  const double reach_m = floor.max_m();
  const CellIndex low = grid.cell_at(scan.center_m.array() - reach_m);
  const CellIndex high = grid.cell_at(scan.center_m.array() + reach_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d offset_m = grid.center_m({x, y}) - scan.center_m;
      const double distance_m = offset_m.norm();
      if (distance_m < floor.reach_m(std::atan2(offset_m.y(), offset_m.x())) &&
          !solid.contains({x, y})) {
        grid.add({x, y}, -faded(params_.free_centilogits, distance_m));
      }
    }
  }
}

void SonarMapper::add_surfaces(const ScanSurfaces& scan,
                               const OccupancyGrid& floor,
                               OccupancyGrid& grid) const {
  for (const auto& surface : scan.surfaces) {
    const Eigen::Vector2d normal = geometry::unit_vector(surface.bearing_rad);
    const Eigen::Vector2d half_m = surface.half_length_m * geometry::perpendicular(normal);
    const Eigen::Vector2d middle_m = scan.center_m + surface.range_m * normal;
    const int evidence =
        surface.half_length_m > 0.0 ? params_.occupied_centilogits : params_.post_centilogits;
    for (const CellIndex cell : cells_along(grid, middle_m - half_m, middle_m + half_m)) {
      if (borders_floor(floor, cell)) {
        grid.add(cell, faded(evidence, surface.range_m));
      }
    }
  }
}

SonarMapper::CellSet SonarMapper::solid_cells(const OccupancyGrid& grid) const {
  CellSet cells;
  for (const auto& wall : matched_.walls) {
    const Eigen::Vector2d normal = geometry::unit_vector(wall.normal_rad);
    const Eigen::Vector2d along = geometry::perpendicular(normal);
    const Eigen::Vector2d foot_m = (wall.offset_m + params_.drawn_behind_m) * normal;
    for (const auto& piece : wall.pieces) {
      cells.merge(cells_along(grid, foot_m + piece.from_m * along, foot_m + piece.to_m * along));
    }
  }
  for (const auto& post_m : matched_.posts_m) {
    cells.insert(grid.cell_at(post_m));
  }
  return cells;
}

int SonarMapper::faded(int centilogits, double distance_m) const {
  return static_cast<int>(std::lround(centilogits * std::exp(-distance_m / params_.fade_m)));
}

}  // namespace echomap::mapping
