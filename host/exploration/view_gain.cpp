// SPDX-License-Identifier: MIT
#include "host/exploration/view_gain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/exploration/unknown_islands.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::exploration {

namespace {

using geometry::CellIndex;
using mapping::CellState;

constexpr double kSectorRad = geometry::kFullTurnRad / ViewGain::kSectors;

double bearing_of(std::size_t sector) {
  return -std::numbers::pi + (static_cast<double>(sector) + 0.5) * kSectorRad;
}

std::size_t sector_of(double bearing_rad) {
  const auto sector = static_cast<std::size_t>((bearing_rad + std::numbers::pi) / kSectorRad);
  return std::min(sector, ViewGain::kSectors - 1);
}

/// std::floor is a call where the processor need not have SSE 4.1.
std::int32_t rounded_down(double value) {
  const auto towards_zero = static_cast<std::int32_t>(value);
  return towards_zero - (value < towards_zero ? 1 : 0);
}

/// All round but for the widest gap between two bearings, where that is wider than a beam.
PastView view_of(const mapping::Scan& scan) {
  constexpr double kBeamRad = 0.45;
  std::vector<double> bearings_rad;
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const mapping::PlacedReading& reading : scan) {
    bearings_rad.push_back(geometry::wrap_angle(reading.T_map_sonar.heading_rad()));
    sum_m += reading.T_map_sonar.position_m();
  }
  std::sort(bearings_rad.begin(), bearings_rad.end());
  double first_rad = bearings_rad.front();
  double gap_rad = geometry::kFullTurnRad - (bearings_rad.back() - bearings_rad.front());
  for (std::size_t i = 1; i < bearings_rad.size(); ++i) {
    if (bearings_rad[i] - bearings_rad[i - 1] > gap_rad) {
      first_rad = bearings_rad[i];
      gap_rad = bearings_rad[i] - bearings_rad[i - 1];
    }
  }
  const double half_width_rad =
      gap_rad > kBeamRad ? 0.5 * (geometry::kFullTurnRad - gap_rad) : std::numbers::pi;
  return {sum_m / static_cast<double>(scan.size()),
          geometry::wrap_angle(first_rad + 0.5 * (geometry::kFullTurnRad - gap_rad)),
          half_width_rad};
}

}  // namespace

bool PastView::covers(double bearing_rad) const {
  return std::abs(geometry::angle_between(middle_rad, bearing_rad)) <= half_width_rad;
}

std::vector<PastView> views_of(const std::vector<mapping::Scan>& scans) {
  std::vector<PastView> views;
  for (const mapping::Scan& scan : scans) {
    if (!scan.empty()) {
      views.push_back(view_of(scan));
    }
  }
  return views;
}

ViewGain::ViewGain(const mapping::RasterMap& map,
                   const std::vector<PastView>& past,
                   const std::vector<geometry::Segment>& unobserved,
                   const ViewGainParams& params)
    : map_(map),
      params_(params),
      worth_(static_cast<std::size_t>(map.columns()) * static_cast<std::size_t>(map.rows()), 1.0F),
      occupied_rim_(occupied_rim_shares(map)),
      looks_(worth_.size()),
      seen_(worth_.size()),
      unobserved_(unobserved_walls(unobserved, params.depth_m, params.unobserved)) {
  geometry::ParameterValidator("view gain")
      .positive("reach_m", params.reach_m)
      .positive("fade_m", params.fade_m)
      .positive("look_fade_m", params.look_fade_m)
      .positive("depth_m", params.depth_m)
      .positive("left_by_look", params.left_by_look)
      .at_most("left_by_look", params.left_by_look, 1.0)
      .within("min_island_look", params.min_island_look, 0.0, 1.0)
      .within("island_floor", params.island_floor, 0.0, 1.0)
      .positive("novel_m", params.novel_m)
      .within("unobserved.floor_chance", params.unobserved.floor_chance, 0.0, 1.0)
      .positive("unobserved.min_length_m", params.unobserved.min_length_m)
      .above("unobserved.door_m", params.unobserved.door_m, params.unobserved.min_length_m)
      .at_least("unobserved.inside_m", params.unobserved.inside_m, 0.0)
      .positive("unobserved.max_distance_m", params.unobserved.max_distance_m);
  const double step_m = map.resolution_m();
  const auto steps = static_cast<int>(params.reach_m / step_m);
  for (int i = 0; i <= steps; ++i) {
    const double range_m = i * step_m;
    shown_m2_.push_back(std::exp(-range_m / params.fade_m) * range_m * kSectorRad * step_m);
    look_.push_back(static_cast<float>(std::exp(-range_m / params.look_fade_m)));
  }
  for (const PastView& view : past) {
    look(view);
  }
  weight_by_walls();
  weight_by_looks();
}

/// Calls `visit(cell, step)` for the unknown cells along a ray, in steps of one cell's edge.
template <typename Visitor>
void ViewGain::follow(const Eigen::Vector2d& from_m, double bearing_rad, Visitor&& visit) const {
  const double step_m = map_.resolution_m();
  const Eigen::Vector2d step_cells = geometry::unit_vector(bearing_rad);
  Eigen::Vector2d at_cells = (from_m - map_.origin_m()) / step_m;
  auto unknown_steps = static_cast<int>(std::lround(params_.depth_m / step_m));
  for (std::size_t i = 0; i < shown_m2_.size(); ++i, at_cells += step_cells) {
    const CellIndex cell{rounded_down(at_cells.x()), rounded_down(at_cells.y())};
    const CellState state = map_.state(cell);
    if (state == CellState::kOccupied) {
      return;
    }
    if (state == CellState::kUnknown) {
      visit(cell, i);
      if (--unknown_steps == 0) {
        return;
      }
    }
  }
}

void ViewGain::weight_by_walls() {
  if (params_.beside_wall_m <= 0.0) {
    return;
  }
  const mapping::DistanceField to_wall(map_, params_.beside_wall_m);
  const auto beside_cells = static_cast<float>(params_.beside_wall_m / map_.resolution_m());
  for (int y = 0; y < map_.rows(); ++y) {
    const float* distances = to_wall.row(y);
    float* worths = &worth_[index({0, y})];
    for (int x = 0; x < map_.columns(); ++x) {
      worths[x] = std::min(1.0F, distances[x] / beside_cells);
    }
  }
}

void ViewGain::weight_by_looks() {
  const auto min_look = static_cast<float>(params_.min_island_look);
  const auto log_left = static_cast<float>(std::log(params_.left_by_look));
  for_each_cell(map_, [&](CellIndex cell) {
    if (const float looks = looks_[index(cell)]; looks > 0.0F) {
      worth_[index(cell)] *= std::exp(log_left * looks * std::max(min_look, occupied_rim_[cell]));
    }
  });
}

/// Its rays run on through unknown floor: it shows what lies behind the first half metre as well.
void ViewGain::leave_to(const PromisedLook& promised) {
  const double step_m = map_.resolution_m();
  const auto steps = static_cast<int>(promised.reach_m / step_m);
  const auto rays = static_cast<int>(geometry::kFullTurnRad * promised.reach_m / step_m) + 1;
  ++views_;
  for (int ray = 0; ray < rays; ++ray) {
    const double bearing_rad = ray * geometry::kFullTurnRad / rays;
    const Eigen::Vector2d step_cells = geometry::unit_vector(bearing_rad);
    Eigen::Vector2d at_cells = (promised.at_m - map_.origin_m()) / step_m;
    for (int step = 0; step < steps; ++step, at_cells += step_cells) {
      const CellIndex cell{rounded_down(at_cells.x()), rounded_down(at_cells.y())};
      if (!map_.contains(cell) || map_.state(cell) == CellState::kOccupied) {
        break;
      }
      if (seen_[index(cell)] != views_) {
        seen_[index(cell)] = views_;
        worth_[index(cell)] *= static_cast<float>(step) / static_cast<float>(steps);
      }
    }
  }
  for (UnobservedWall& unobserved : unobserved_) {
    if (facing_rad(map_, promised.at_m, unobserved.wall, params_.unobserved)) {
      unobserved.floor_m2 *= params_.left_by_look;
    }
  }
}

/// As many rays as hit each cell at the far end.
void ViewGain::look(const PastView& view) {
  ++views_;
  looked_from_m_.push_back(view.from_m);
  for (UnobservedWall& unobserved : unobserved_) {
    const auto bearing_rad = facing_rad(map_, view.from_m, unobserved.wall, params_.unobserved);
    if (bearing_rad && view.covers(*bearing_rad)) {
      unobserved.floor_m2 *= params_.left_by_look;
    }
  }
  const double step_rad = map_.resolution_m() / params_.reach_m;
  const int rays = 1 + static_cast<int>(2.0 * view.half_width_rad / step_rad);
  for (int i = 0; i < rays; ++i) {
    const double bearing_rad = view.middle_rad - view.half_width_rad + i * step_rad;
    follow(view.from_m, bearing_rad, [this](CellIndex cell, std::size_t step) {
      if (map_.contains(cell) && seen_[index(cell)] != views_) {
        seen_[index(cell)] = views_;
        looks_[index(cell)] += look_[step];
      }
    });
  }
}

std::vector<double> ViewGain::by_sector_m2(const Eigen::Vector2d& from_m) const {
  std::vector<double> gains_m2(kSectors);
  for (std::size_t sector = 0; sector < kSectors; ++sector) {
    double& gain_m2 = gains_m2[sector];
    follow(from_m, bearing_of(sector), [&](CellIndex cell, std::size_t step) {
      const double worth = map_.contains(cell) ? static_cast<double>(worth_[index(cell)]) : 1.0;
      gain_m2 += worth * shown_m2_[step];
    });
  }
  for (const UnobservedWall& unobserved : unobserved_) {
    if (const auto bearing_rad = facing_rad(map_, from_m, unobserved.wall, params_.unobserved)) {
      gains_m2[sector_of(*bearing_rad)] += unobserved.floor_m2;
    }
  }
  const double share = novelty(from_m);
  for (double& gain_m2 : gains_m2) {
    gain_m2 *= share;
  }
  return gains_m2;
}

/// How much of what a sweep shows none before has.
double ViewGain::novelty(const Eigen::Vector2d& from_m) const {
  double nearest_m = params_.novel_m;
  for (const Eigen::Vector2d& other_m : looked_from_m_) {
    nearest_m = std::min(nearest_m, (other_m - from_m).norm());
  }
  return nearest_m / params_.novel_m;
}

BestView best_view(const std::vector<double>& by_sector_m2, double width_rad) {
  const std::size_t count = by_sector_m2.size();
  const auto wide = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::lround(width_rad / kSectorRad)), 1, count);
  BestView best{-1.0, 0.0, static_cast<double>(wide) * kSectorRad};
  for (std::size_t first = 0; first < count; ++first) {
    double gain_m2 = 0.0;
    for (std::size_t i = 0; i < wide; ++i) {
      gain_m2 += by_sector_m2[(first + i) % count];
    }
    if (gain_m2 > best.gain_m2) {
      best.gain_m2 = gain_m2;
      best.middle_rad = geometry::wrap_angle(
          -std::numbers::pi +
          (static_cast<double>(first) + 0.5 * static_cast<double>(wide)) * kSectorRad);
    }
  }
  return best;
}

}  // namespace echomap::exploration
