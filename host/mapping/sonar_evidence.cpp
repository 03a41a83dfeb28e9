// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// Four fields of them take 1.6 GB; a square kilometre at 10 cm.
constexpr double kMostCells = 1e8;
/// Cells in front of a place that its own wall may fill.
constexpr double kOwnCells = 1.0;
constexpr double kOwnArcCells = 2.0;
/// Belief below this does not stop any sound.
constexpr float kOpaqueBelief = 0.5F;
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
  if (!((high - low + 1.0).prod() <= kMostCells)) {
    throw std::length_error("sonar readings: the poses lie too far apart for one map");
  }
  return {{static_cast<std::int32_t>(low.x()), static_cast<std::int32_t>(low.y())},
          {static_cast<std::int32_t>(high.x()), static_cast<std::int32_t>(high.y())}};
}

/// Calls `visit(cell)` for all cells of the square around a view.
template <typename Visitor>
void for_cells_around(const CellField& field,
                      const Eigen::Vector2d& origin_m,
                      double reach_m,
                      Visitor&& visit) {
  const CellIndex low = field.cell_at(origin_m.array() - reach_m);
  const CellIndex high = field.cell_at(origin_m.array() + reach_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      visit(CellIndex{x, y});
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
      free_(bounds_around(views,
                          cone.params().max_range_m + cone.params().arc_half_thickness_m,
                          params.grid.resolution_m),
            params.grid.resolution_m),
      occupied_(free_),
      wall_(free_),
      of_one_view_(free_) {
  draw_walls(walls);
  for (const SonarView& view : views) {
    auto& arcs = arcs_.emplace_back();
    for (const SonarBeam& beam : view.beams) {
      if (beam.range_m && *beam.range_m <= cone.params().max_range_m) {
        arcs.push_back(arc_of(view, beam));
      }
    }
  }
}

void SonarEvidence::find() {
  for (int round = 0; round < params_.rounds; ++round) {
    hear_free_floor();
    occupied_.clear();
    for (auto& arcs : arcs_) {
      for (Arc& arc : arcs) {
        share_out(arc);
      }
      add_arcs(arcs);
    }
  }
  hear_free_floor();
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
            std::min(params_.most_wall_evidence, evidence + params_.wall_evidence));
      }
      last = cell;
    }
  }
}

SonarEvidence::Arc SonarEvidence::arc_of(const SonarView& view, const SonarBeam& beam) const {
  Arc arc;
  const models::SensorReading reading{beam.range_m};
  for_cells_around(free_, view.origin_m, cone_.reach_m(reading), [&](CellIndex cell) {
    const Eigen::Vector2d way_m = free_.center_m(cell) - view.origin_m;
    const models::PolarPoint point{
        way_m.norm(), geometry::angle_between(beam.bearing_rad, std::atan2(way_m.y(), way_m.x()))};
    if (cone_.on_arc(reading, point)) {
      arc.cells.push_back(free_.index(cell));
      arc.weight.push_back(static_cast<float>(cone_.weight(point.off_axis_rad)));
    }
  });
  arc.reached.assign(arc.cells.size(), 1.0F);
  arc.share.assign(arc.cells.size(), 0.0F);
  return arc;
}

void SonarEvidence::hear_free_floor() {
  CellField free(free_.bounds(), free_.resolution_m());
  for (std::size_t i = 0; i < views_.size(); ++i) {
    SonarFan fan(views_[i], cone_, free_.resolution_m());
    fan.look([this](const Eigen::Vector2d& point_m) { return opacity(point_m); });
    add_free_floor(fan, views_[i], free);
    look_along_arcs(fan, arcs_[i]);
  }
  free_ = std::move(free);
}

double SonarEvidence::opacity(const Eigen::Vector2d& point_m) const {
  const CellIndex cell = free_.cell_at(point_m);
  if (!free_.holds(cell)) {
    return 0.0;
  }
  const std::size_t index = free_.index(cell);
  if (wall_[index] > 0.0F) {
    return params_.wall_opacity;
  }
  const float log_odds = free_[index] + occupied_[index];
  return log_odds > kOpaqueBelief ? 1.0 / (1.0 + std::exp(-log_odds)) : 0.0;
}

void SonarEvidence::add_free_floor(const SonarFan& fan,
                                   const SonarView& view,
                                   CellField& free) const {
  for_cells_around(free, view.origin_m, cone_.params().max_range_m, [&](CellIndex cell) {
    const auto place = fan.place(free.center_m(cell));
    if (!place) {
      return;
    }
    const std::size_t index = free.index(cell);
    const double own = wall_[index] > 0.0F ? 1.0 - params_.wall_opacity : 1.0;
    const double reached = own * fan.reached(*place, kOwnCells * free.resolution_m());
    free[index] += static_cast<float>(std::log(1.0 - reached * (1.0 - fan.miss_chance(*place))));
  });
}

void SonarEvidence::look_along_arcs(const SonarFan& fan, std::vector<Arc>& arcs) const {
  for (Arc& arc : arcs) {
    for (std::size_t i = 0; i < arc.cells.size(); ++i) {
      const auto place = fan.place(free_.center_m(free_.cell(arc.cells[i])));
      arc.reached[i] = static_cast<float>(
          place ? fan.reached(*place, kOwnArcCells * free_.resolution_m()) : 0.0);
    }
  }
}

void SonarEvidence::share_out(Arc& arc) const {
  double whole = 0.0;
  double farthest = 0.0;
  double likeliest = 0.0;
  for (std::size_t i = 0; i < arc.cells.size(); ++i) {
    const double not_free = std::exp(static_cast<double>(free_[arc.cells[i]]));
    farthest = std::max<double>(farthest, arc.reached[i]);
    likeliest = std::max(likeliest, not_free);
    arc.share[i] = static_cast<float>(arc.weight[i] * arc.reached[i] * not_free);
    whole += arc.share[i];
  }
  arc.behind_wall = farthest < kBehindWall;
  arc.seen_through = !arc.behind_wall && likeliest < params_.ghost_chance;
  const bool ghost = arc.behind_wall || arc.seen_through;
  const auto& cone = cone_.params();
  for (float& share : arc.share) {
    share =
        ghost ? 0.0F
              : static_cast<float>(std::min(cone.cell_evidence, cone.arc_evidence * share / whole));
  }
}

void SonarEvidence::add_arcs(const std::vector<Arc>& arcs) {
  std::vector<std::size_t> cells;
  for (const Arc& arc : arcs) {
    for (std::size_t i = 0; i < arc.cells.size(); ++i) {
      float& most = of_one_view_[arc.cells[i]];
      most = std::max(most, arc.share[i]);
      cells.push_back(arc.cells[i]);
    }
  }
  for (const std::size_t cell : cells) {
    occupied_[cell] += std::exchange(of_one_view_[cell], 0.0F);
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
