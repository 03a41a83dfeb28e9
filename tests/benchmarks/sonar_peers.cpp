// SPDX-License-Identifier: MIT
#include "tests/benchmarks/sonar_peers.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "host/geometry/angle.hpp"
#include "host/models/gaussian_patch.hpp"
#include "host/models/occupied_sector.hpp"

namespace echomap::bench {

namespace {

using geometry::CellIndex;
using mapping::OccupancyGrid;
using mapping::PlacedReading;
using mapping::Scan;

constexpr double kCentilogits = 100.0;
constexpr int kCertainCentilogits = 500;
constexpr double kOccupiedConfidence = 1.0;

/// Calls `visit(cell, center_m)` for the cells of a square.
template <typename Visitor>
void for_cells_around(const OccupancyGrid& grid,
                      const Eigen::Vector2d& middle_m,
                      double reach_m,
                      Visitor&& visit) {
  const CellIndex low = grid.cell_at(middle_m.array() - reach_m);
  const CellIndex high = grid.cell_at(middle_m.array() + reach_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      visit(CellIndex{x, y}, grid.center_m({x, y}));
    }
  }
}

models::PolarPoint seen_from(const PlacedReading& reading, const Eigen::Vector2d& point_m) {
  return models::polar_point(reading.T_map_sonar.inverse() * point_m);
}

/// Line 5 of Algorithm 3: the beam nearest to the bearing of a cell.
const PlacedReading& nearest_beam(const Scan& sweep, const Eigen::Vector2d& point_m) {
  const PlacedReading* nearest = &sweep.front();
  double min_rad = std::numeric_limits<double>::infinity();
  const Eigen::Vector2d offset_m = point_m - sweep.front().T_map_sonar.position_m();
  const double bearing_rad = std::atan2(offset_m.y(), offset_m.x());
  for (const PlacedReading& reading : sweep) {
    const double off_rad =
        std::abs(geometry::angle_between(reading.T_map_sonar.heading_rad(), bearing_rad));
    if (off_rad < min_rad) {
      min_rad = off_rad;
      nearest = &reading;
    }
  }
  return *nearest;
}

}  // namespace

OccupancyGrid paper002_grid(const std::vector<Scan>& sweeps, const PeerSonar& sonar) {
  models::OccupiedSectorParams params;
  params.beam_width_rad = 2.0 * sonar.beam_half_angle_rad;
  params.max_range_m = sonar.max_range_m;
  const models::OccupiedSector model(params);
  OccupancyGrid grid;
  for (const Scan& sweep : sweeps) {
    for_cells_around(grid,
                     sweep.front().T_map_sonar.position_m(),
                     sonar.max_range_m,
                     [&](CellIndex cell, const Eigen::Vector2d& center_m) {
                       const PlacedReading& beam = nearest_beam(sweep, center_m);
                       const double log_odds =
                           model.evidence({beam.range_m}, seen_from(beam, center_m));
                       grid.add(cell, static_cast<int>(std::lround(kCentilogits * log_odds)));
                     });
  }
  return grid;
}

OccupancyGrid paper002_single_grid(const std::vector<Scan>& sweeps, const PeerSonar& sonar) {
  std::vector<Scan> single;
  for (const Scan& sweep : sweeps) {
    for (const PlacedReading& reading : sweep) {
      single.push_back({reading});
    }
  }
  return paper002_grid(single, sonar);
}

OccupancyGrid paper003_grid(const std::vector<Scan>& sweeps) {
  const models::GaussianPatch model;
  OccupancyGrid grid;
  std::map<CellIndex, double> confidence;
  for (const Scan& sweep : sweeps) {
    for (const PlacedReading& reading : sweep) {
      const auto echo_m = mapping::echo_point_m(reading);
      if (!echo_m) {
        continue;
      }
      for_cells_around(grid,
                       *echo_m,
                       model.reach_m({0.0}),
                       [&](CellIndex cell, const Eigen::Vector2d& center_m) {
                         confidence[cell] +=
                             model.evidence({reading.range_m}, seen_from(reading, center_m));
                       });
    }
  }
  for (const auto& [cell, sum] : confidence) {
    grid.add(cell, sum >= kOccupiedConfidence ? kCertainCentilogits : -kCertainCentilogits);
  }
  const auto field = grid.bounds();
  for (std::int32_t y = field.min.y; y <= field.max.y; ++y) {
    for (std::int32_t x = field.min.x; x <= field.max.x; ++x) {
      if (!grid.centilogits({x, y})) {
        grid.add({x, y}, -kCertainCentilogits);
      }
    }
  }
  return grid;
}

}  // namespace echomap::bench
