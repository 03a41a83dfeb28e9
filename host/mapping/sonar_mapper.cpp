// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/cell_field.hpp"
#include "host/mapping/cell_insertion.hpp"
#include "host/mapping/visit_cells.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// Readings of a scan that tell whether it was bent.
constexpr std::size_t kProbes = 6;

/// What features make of a cell: nothing (0), the inside of something round, a face.
constexpr float kInside = 0.5F;
constexpr float kFace = 1.0F;

void mark_along(const geometry::Segment& piece, CellField& solid) {
  visit_along(piece, solid.resolution_m(), [&](CellIndex cell) {
    if (solid.holds(cell)) {
      solid[solid.index(cell)] = kFace;
    }
  });
}

/// Marks where walls and the seen rims of round things are drawn.
void mark_faces(const SonarFeatures& features, double drawn_behind_m, CellField& solid) {
  for (const geometry::Segment& wall : features.walls) {
    const Eigen::Vector2d behind_m = -drawn_behind_m * geometry::left_normal(wall);
    mark_along({wall.from_m + behind_m, wall.to_m + behind_m}, solid);
  }
  for (const FittedCircle& circle : features.circles) {
    for (std::size_t i = 0; i < FittedCircle::kSectors; ++i) {
      if (circle.seen[i]) {
        mark_along({circle.rim_m(i), circle.rim_m(i + 1)}, solid);
      }
    }
  }
}

/// Marks what a round thing encloses.
void mark_inside(const FittedCircle& circle, CellField& solid) {
  const CellIndex low = solid.cell_at(circle.center_m.array() - circle.radius_m);
  const CellIndex high = solid.cell_at(circle.center_m.array() + circle.radius_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      if (solid.holds({x, y}) &&
          (solid.center_m({x, y}) - circle.center_m).norm() < circle.radius_m) {
        solid[solid.index({x, y})] = kInside;
      }
    }
  }
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
  constexpr double kBentM = 0.005;
  constexpr double kBentRad = 0.012;
  if (from.size() != to.size()) {
    return std::nullopt;
  }
  if (from.empty()) {
    return geometry::Pose2();
  }
  const geometry::Pose2 T_to_from = to.front().T_map_sonar * from.front().T_map_sonar.inverse();
  for (std::size_t probe = 0; probe < kProbes; ++probe) {
    const std::size_t i = probe * (from.size() - 1) / (kProbes - 1);
    const geometry::Pose2 off = to[i].T_map_sonar.inverse() * T_to_from * from[i].T_map_sonar;
    if (from[i].range_m != to[i].range_m || off.position_m().norm() > kBentM ||
        std::abs(off.heading_rad()) > kBentRad) {
      return std::nullopt;
    }
  }
  return T_to_from;
}

bool is_near(const Eigen::Vector2d& one_m, const Eigen::Vector2d& other_m, double within_m) {
  return (one_m - other_m).norm() <= within_m;
}

bool is_still(const geometry::Segment& one, const geometry::Segment& other, double within_m) {
  return is_near(one.from_m, other.from_m, within_m) && is_near(one.to_m, other.to_m, within_m);
}

bool is_still(const FittedCircle& one, const FittedCircle& other, double within_m) {
  return is_near(one.center_m, other.center_m, within_m) &&
         std::abs(one.radius_m - other.radius_m) <= within_m && one.seen == other.seen;
}

/// Things that have not moved stay where they were.
template <class Thing>
void hold_still(const std::vector<Thing>& before, double within_m, std::vector<Thing>& now) {
  for (Thing& thing : now) {
    const auto same = std::find_if(before.begin(), before.end(), [&](const Thing& known) {
      return is_still(known, thing, within_m);
    });
    thing = same == before.end() ? thing : *same;
  }
}

/// Where something came or went: pieces that are in one of the two lists alone.
void add_changes(const SonarFeatures& one,
                 const SonarFeatures& other,
                 std::vector<geometry::Segment>& changes) {
  for (const geometry::Segment& wall : one.walls) {
    if (std::none_of(other.walls.begin(), other.walls.end(), [&](const auto& known) {
          return is_still(known, wall, 0.0);
        })) {
      changes.push_back(wall);
    }
  }
  for (const FittedCircle& circle : one.circles) {
    if (std::none_of(other.circles.begin(), other.circles.end(), [&](const auto& known) {
          return is_still(known, circle, 0.0);
        })) {
      changes.push_back({circle.center_m, circle.center_m});
    }
  }
}

}  // namespace

SonarMapper::SonarMapper(const SonarMapperParams& params)
    : params_(params),
      matcher_(params.matching),
      evidence_(params.evidence, params.grid.resolution_m),
      lone_(params.lone, params.grid.resolution_m) {
  const auto& surfaces = params.surfaces;
  geometry::ParameterValidator("sonar mapper")
      .positive("surfaces.beam_half_angle_rad", surfaces.beam_half_angle_rad)
      .at_most("surfaces.beam_half_angle_rad", surfaces.beam_half_angle_rad, kMaxBeamHalfAngleRad)
      .positive("surfaces.depth_tolerance_m", surfaces.depth_tolerance_m)
      .at_least("surfaces.max_longer_m", surfaces.max_longer_m, 0.0)
      .positive("features.completion.told_apart_m", params.features.completion.told_apart_m)
      .positive_finite("features.completion.doors.door_m", params.features.completion.doors.door_m)
      .positive_finite("features.completion.doors.step_m", params.features.completion.doors.step_m)
      .positive_finite("features.completion.doors.range_scale_m",
                       params.features.completion.doors.range_scale_m)
      .positive_finite("features.completion.doors.range_degrees_of_freedom",
                       params.features.completion.doors.range_degrees_of_freedom)
      .positive_finite("floor.max_range_m", params.floor.max_range_m)
      .positive("floor.max_gap_rad", params.floor.max_gap_rad)
      .at_least("floor.looks_half_angle_rad", params.floor.looks_half_angle_rad, 0.0)
      .at_least("floor.echo_half_angle_rad", params.floor.echo_half_angle_rad, 0.0)
      .positive("floor.open_half_angle_rad", params.floor.open_half_angle_rad)
      .within("floor.open_share", params.floor.open_share, 0.0, 1.0)
      .within("evidence.silent_share", params.evidence.silent_share, 0.0, 1.0)
      .positive("features.completion.min_angle_rad", params.features.completion.min_angle_rad)
      .at_least(
          "features.completion.faced_inside_m", params.features.completion.faced_inside_m, 0.0)
      .positive("features.completion.faced_range_m", params.features.completion.faced_range_m)
      .positive("features.completion.faced_half_angle_rad",
                params.features.completion.faced_half_angle_rad)
      .at_least("floor.margin_m", params.floor.margin_m, 0.0)
      .positive("evidence.fade_m", params.evidence.fade_m)
      .positive("evidence.free_centilogits", params.evidence.free_centilogits)
      .at_least("lone.depth_m", params.lone.depth_m, 0.0)
      .positive("matched_centilogits", params.matched_centilogits)
      .at_least("still_m", params.still_m, 0.0)
      .at_least("still_rad", params.still_rad, 0.0);
}

void SonarMapper::take(const std::vector<Scan>& scans,
                       const std::vector<Eigen::Vector2d>& track_m) {
  const std::vector<std::size_t> moved = place(scans);
  matcher_.update(surfaces_, moved);
  matched_ = matcher_.matched();
  SonarFeatures features = sonar_features(matched_, surfaces_, track_m, params_.features);
  hold_still(features_.walls, params_.still_m, features.walls);
  hold_still(features_.circles, params_.still_m, features.circles);
  const SonarFeatures before = std::exchange(features_, std::move(features));
  update_floor(before, moved);
  update_lone();
}

std::vector<std::size_t> SonarMapper::place(const std::vector<Scan>& scans) {
  const std::size_t known = std::min(readings_.size(), scans.size());
  readings_.resize(known);
  surfaces_.resize(known);
  floors_.erase(floors_.begin() + static_cast<std::ptrdiff_t>(known), floors_.end());
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const bool is_new = i >= known;
    const auto T_new_old = is_new ? std::nullopt : rigid_motion(readings_[i], scans[i]);
    if (T_new_old &&
        is_near(*T_new_old * surfaces_[i].center_m, surfaces_[i].center_m, params_.still_m) &&
        std::abs(T_new_old->heading_rad()) <= params_.still_rad) {
      continue;
    }
    moved.push_back(i);
    ScanSurfaces surfaces = T_new_old ? mapping::moved(surfaces_[i], *T_new_old)
                                      : find_surfaces(scans[i], params_.surfaces);
    StopFloor floor(surfaces, params_.surfaces, params_.floor);
    if (is_new) {
      readings_.push_back(scans[i]);
      surfaces_.push_back(std::move(surfaces));
      floors_.push_back(floor);
    } else {
      // The scan that its surfaces were found in, or else small bends would add up.
      readings_[i] = T_new_old ? mapping::moved(readings_[i], *T_new_old) : scans[i];
      surfaces_[i] = std::move(surfaces);
      floors_[i] = floor;
    }
  }
  return moved;
}

void SonarMapper::update_floor(const SonarFeatures& before, const std::vector<std::size_t>& moved) {
  evidence_.resize(floors_.size());
  std::vector<geometry::Segment> changes;
  add_changes(before, features_, changes);
  add_changes(features_, before, changes);
  const double reach_m = params_.floor.max_range_m + params_.matching.max_radius_m;
  for (std::size_t i = 0; i < floors_.size(); ++i) {
    const bool is_about =
        std::binary_search(moved.begin(), moved.end(), i) ||
        std::any_of(changes.begin(), changes.end(), [&](const geometry::Segment& change) {
          return geometry::distance_m(change, floors_[i].center_m()) <= reach_m;
        });
    if (is_about) {
      evidence_.set(i, floors_[i].center_m(), floors_[i].reach(features_));
    }
  }
}

void SonarMapper::update_lone() {
  std::vector<std::vector<bool>> is_explained;
  is_explained.reserve(surfaces_.size());
  for (const ScanSurfaces& scan : surfaces_) {
    is_explained.emplace_back(scan.surfaces.size(), false);
  }
  for (const MatchedFeature& feature : matched_.features) {
    const bool is_post =
        feature.feature.kind == LandmarkKind::kPoint && feature.feature.radius_m <= 0.0;
    for (const auto& [scan, surface] : feature.supporters) {
      // A post may be the edge of anything.
      is_explained[scan][surface] = is_explained[scan][surface] || !is_post;
    }
  }
  lone_.resize(surfaces_.size());
  for (std::size_t scan = 0; scan < surfaces_.size(); ++scan) {
    std::vector<LoneSurface> lone;
    for (std::size_t i = 0; i < surfaces_[scan].surfaces.size(); ++i) {
      const SonarSurface& surface = surfaces_[scan].surfaces[i];
      if (!is_explained[scan][i]) {
        lone.push_back({surfaces_[scan].center_m, surface, evidence_.faded(surface.range_m)});
      }
    }
    lone_.set(scan, std::move(lone));
  }
}

OccupancyGrid SonarMapper::grid() const {
  CellField solid(evidence_.bounds(), params_.grid.resolution_m);
  for (const FittedCircle& circle : features_.circles) {
    mark_inside(circle, solid);
  }
  mark_faces(features_, params_.drawn_behind_m, solid);
  OccupancyGrid floor(params_.grid);
  // More than the whole range counts as that; equal neighbours are inserted faster.
  const int range_centilogits = 2 * params_.grid.clamp_centilogits;
  insert_cells(
      evidence_.bounds(),
      [&](CellIndex cell) {
        const int evidence = evidence_.centilogits(cell) - lone_.centilogits(cell);
        return evidence > 0 && solid[solid.index(cell)] == 0.0F
                   ? -std::min(evidence, range_centilogits)
                   : 0;
      },
      floor);
  OccupancyGrid grid = floor;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (solid[i] == kFace && borders_floor(floor, solid.cell(i))) {
      grid.add(solid.cell(i), params_.matched_centilogits);
    }
  }
  return grid;
}

}  // namespace echomap::mapping
