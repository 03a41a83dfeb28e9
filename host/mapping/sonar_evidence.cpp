// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// Four fields of them take 1.6 GB; a square kilometre at 10 cm.
constexpr double kMaxCells = 1e8;
/// Cells in front of a place that its own wall may fill.
constexpr double kOwnCells = 1.0;
constexpr double kOwnArcCells = 2.0;
/// Belief below this does not stop any sound.
constexpr float kOpaqueBelief = 0.5F;
/// What sound reaches with less chance it says nothing of.
constexpr float kMinReached = 1e-3F;
/// An arc that sound reaches with less chance lies behind a wall.
constexpr double kBehindWall = 0.5;
constexpr double kCentilogits = 100.0;
/// A wall is drawn in steps of this share of a cell.
constexpr double kStepsPerCell = 4.0;

CellBounds bounds_around(const std::vector<SonarView>& views, double reach_m, double resolution_m) {
  Eigen::Array2d low = views.front().origin_m;
  Eigen::Array2d high = low;
  for (const SonarView& view : views) {
    low = low.min(view.origin_m.array());
    high = high.max(view.origin_m.array());
  }
  low = ((low - reach_m) / resolution_m).floor() - 1.0;
  high = ((high + reach_m) / resolution_m).floor() + 1.0;
  if (!((high - low + 1.0).prod() <= kMaxCells)) {
    throw std::length_error("sonar readings: the poses lie too far apart for one map");
  }
  return {{static_cast<std::int32_t>(low.x()), static_cast<std::int32_t>(low.y())},
          {static_cast<std::int32_t>(high.x()), static_cast<std::int32_t>(high.y())}};
}

/// The corners of a box around an echo's arc, seen from its sonar.
std::pair<Eigen::Array2d, Eigen::Array2d> box_of_arc_m(const SonarEcho& echo,
                                                       const models::SonarConeParams& cone) {
  const double far_m = echo.range_m + cone.arc_half_thickness_m;
  Eigen::Array2d low = far_m * geometry::unit_vector(echo.bearing_rad);
  Eigen::Array2d high = low;
  const auto widen = [&](double bearing_rad, double range_m) {
    const Eigen::Array2d point_m = range_m * geometry::unit_vector(bearing_rad);
    low = low.min(point_m);
    high = high.max(point_m);
  };
  for (const double side_rad : {-cone.beam_half_angle_rad, cone.beam_half_angle_rad}) {
    widen(echo.bearing_rad + side_rad, far_m);
    widen(echo.bearing_rad + side_rad, echo.range_m - cone.arc_half_thickness_m);
  }
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double axis_rad = quarter * std::numbers::pi / 2.0;
    if (std::abs(geometry::angle_between(axis_rad, echo.bearing_rad)) <= cone.beam_half_angle_rad) {
      widen(axis_rad, far_m);
    }
  }
  return {low, high};
}

/// Calls `visit(cell, offset_m)` for the cells whose centres lie as far from the view as its echo,
/// and somewhere near the cone.
template <typename Visitor>
void for_cells_of_arc(const CellField& field,
                      const Eigen::Vector2d& origin_m,
                      const SonarEcho& echo,
                      const models::SonarConeParams& cone,
                      Visitor&& visit) {
  const auto [low_m, high_m] = box_of_arc_m(echo, cone);
  const CellIndex low = field.cell_at(origin_m.array() + low_m);
  const CellIndex high = field.cell_at(origin_m.array() + high_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d offset_m = field.center_m({x, y}) - origin_m;
      if (std::abs(offset_m.norm() - echo.range_m) <= cone.arc_half_thickness_m) {
        visit(CellIndex{x, y}, offset_m);
      }
    }
  }
}

}  // namespace

SonarEvidence::SonarEvidence(const std::vector<SonarView>& views,
                             const std::vector<geometry::Segment>& walls,
                             const models::SonarCone& cone,
                             const SonarConeMapperParams& params)
    : views_(views),
      cone_(cone),
      params_(params),
      rays_(cone.params().max_range_m, params.grid.resolution_m),
      free_(bounds_around(views,
                          cone.params().max_range_m + cone.params().arc_half_thickness_m,
                          params.grid.resolution_m),
            params.grid.resolution_m),
      occupied_(free_),
      wall_(free_),
      opacity_(free_),
      of_one_view_(free_) {
  draw_walls(walls);
  for (const SonarView& view : views) {
    auto& arcs = arcs_.emplace_back();
    for (const sensors::Beam& beam : view.beams) {
      if (beam.range_m && *beam.range_m <= cone.params().max_range_m) {
        arcs.push_back(arc_of(view, {beam.bearing_rad, *beam.range_m}));
      }
    }
  }
}

void SonarEvidence::find() {
  for (int round = 0; round < params_.rounds; ++round) {
    add_silent_floor();
    occupied_.clear();
    for (auto& arcs : arcs_) {
      for (Arc& arc : arcs) {
        share_out(arc);
      }
      add_arcs(arcs);
    }
  }
  add_silent_floor();
}

void SonarEvidence::draw_walls(const std::vector<geometry::Segment>& walls) {
  for (const auto& wall : walls) {
    const int steps = 1 + static_cast<int>(kStepsPerCell * wall.length_m() / free_.resolution_m());
    std::optional<CellIndex> last;
    for (int i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const CellIndex cell = free_.cell_at(wall.from_m + share * (wall.to_m - wall.from_m));
      if (cell != last && free_.holds(cell)) {
        float& evidence = wall_[wall_.index(cell)];
        evidence = static_cast<float>(
            std::min(params_.max_wall_evidence, evidence + params_.wall_evidence));
      }
      last = cell;
    }
  }
}

SonarEvidence::Arc SonarEvidence::arc_of(const SonarView& view, const SonarEcho& echo) const {
  Arc arc;
  const models::SensorReading reading{echo.range_m};
  const double own_m = kOwnArcCells * free_.resolution_m();
  for_cells_of_arc(
      free_,
      view.origin_m,
      echo,
      cone_.params(),
      [&](CellIndex cell, const Eigen::Vector2d& offset_m) {
        const double bearing_rad = std::atan2(offset_m.y(), offset_m.x());
        const models::PolarPoint point{offset_m.norm(),
                                       geometry::angle_between(echo.bearing_rad, bearing_rad)};
        if (cone_.on_arc(reading, point) && point.range_m <= cone_.params().max_range_m) {
          arc.cells.push_back({static_cast<std::uint32_t>(free_.index(cell)),
                               rays_.index(rays_.ray_at(bearing_rad), point.range_m - own_m),
                               static_cast<float>(cone_.weight(point.off_axis_rad))});
        }
      });
  return arc;
}

void SonarEvidence::add_silent_floor() {
  find_opacity();
  CellField free(free_.bounds(), free_.resolution_m());
  for (std::size_t i = 0; i < views_.size(); ++i) {
    SonarFan fan(views_[i], cone_, rays_);
    fan.look([this](const Eigen::Vector2d& point_m) { return opacity(point_m); });
    add_free_floor(fan, free);
    add_floor_under_robot(views_[i], free);
    for (Arc& arc : arcs_[i]) {
      for (ArcCell& on_arc : arc.cells) {
        on_arc.reached = fan.reached(on_arc.step);
      }
    }
  }
  free_ = std::move(free);
}

void SonarEvidence::find_opacity() {
  for (std::size_t i = 0; i < opacity_.size(); ++i) {
    const float log_odds = free_[i] + occupied_[i];
    const float believed = log_odds > kOpaqueBelief ? 1.0F / (1.0F + std::exp(-log_odds)) : 0.0F;
    opacity_[i] = wall_[i] > 0.0F ? static_cast<float>(params_.wall_opacity) : believed;
  }
}

float SonarEvidence::opacity(const Eigen::Vector2d& point_m) const {
  const CellIndex cell = opacity_.cell_at(point_m);
  return opacity_.holds(cell) ? opacity_[opacity_.index(cell)] : 0.0F;
}

void SonarEvidence::add_free_floor(const SonarFan& fan, CellField& free) const {
  const double own_m = kOwnCells * free.resolution_m();
  const auto past_wall = static_cast<float>(1.0 - params_.wall_weight);
  fan.for_cells(free, [&](CellIndex cell, const SonarFan::Place& place) {
    const std::size_t index = free.index(cell);
    const float own = wall_[index] > 0.0F ? past_wall : 1.0F;
    const float reached = own * fan.reached(place, own_m);
    if (reached > kMinReached) {
      const auto heard = static_cast<float>(1.0 - fan.miss_chance(place));
      free[index] += std::log(1.0F - reached * heard);
    }
  });
}

void SonarEvidence::add_floor_under_robot(const SonarView& view, CellField& free) const {
  if (!view.robot_m) {
    return;
  }
  const auto evidence = static_cast<float>(std::log(params_.under_robot_chance));
  const CellIndex low = free.cell_at(view.robot_m->array() - params_.robot_radius_m);
  const CellIndex high = free.cell_at(view.robot_m->array() + params_.robot_radius_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const double apart_m = (free.center_m({x, y}) - *view.robot_m).norm();
      if (apart_m <= params_.robot_radius_m && free.holds({x, y})) {
        free[free.index({x, y})] += evidence;
      }
    }
  }
}

void SonarEvidence::share_out(Arc& arc) const {
  float whole = 0.0F;
  float farthest = 0.0F;
  float likeliest = 0.0F;
  for (ArcCell& on_arc : arc.cells) {
    const float not_free = std::exp(free_[on_arc.cell]);
    farthest = std::max(farthest, on_arc.reached);
    likeliest = std::max(likeliest, on_arc.reached * not_free);
    on_arc.share = on_arc.weight * on_arc.reached * not_free;
    whole += on_arc.share;
  }
  arc.behind_wall = farthest < kBehindWall;
  arc.seen_through = !arc.behind_wall && likeliest < params_.ghost_chance;
  const bool ghost = arc.behind_wall || arc.seen_through;
  const auto whole_evidence = static_cast<float>(cone_.params().arc_evidence);
  const auto most = static_cast<float>(cone_.params().cell_evidence);
  for (ArcCell& on_arc : arc.cells) {
    on_arc.share = ghost ? 0.0F : std::min(most, whole_evidence * on_arc.share / whole);
  }
}

void SonarEvidence::add_arcs(const std::vector<Arc>& arcs) {
  for (const Arc& arc : arcs) {
    for (const ArcCell& on_arc : arc.cells) {
      float& most = of_one_view_[on_arc.cell];
      most = std::max(most, on_arc.share);
    }
  }
  for (const Arc& arc : arcs) {
    for (const ArcCell& on_arc : arc.cells) {
      occupied_[on_arc.cell] += std::exchange(of_one_view_[on_arc.cell], 0.0F);
    }
  }
}

OccupancyGrid SonarEvidence::grid() const {
  OccupancyGrid grid(params_.grid);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const double log_odds = free_[i] + occupied_[i] + wall_[i];
    grid.add(free_.cell(i), static_cast<int>(std::lround(kCentilogits * log_odds)));
  }
  return grid;
}

SonarReadingCounts SonarEvidence::counts() const {
  SonarReadingCounts counts;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    counts.readings += views_[i].beams.size();
    counts.silent += views_[i].beams.size() - arcs_[i].size();
    for (const Arc& arc : arcs_[i]) {
      counts.behind_wall += arc.behind_wall ? 1 : 0;
      counts.seen_through += arc.seen_through ? 1 : 0;
    }
  }
  return counts;
}

}  // namespace echomap::mapping
