// SPDX-License-Identifier: MIT
#include "host/mapping/ray_insertion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

using geometry::CellIndex;

/// A lattice's corner lies so many tiles before the sensor's tile: far enough for the longest ray.
constexpr std::int32_t kTilesBefore = kMaxWindowCells / kTileSide / 2;
constexpr int kLatticeTileBits = kLatticeBits + kTileBits;

/// The odd lattice coordinates of a point that is so many cells, above 0, from the lattice's
/// corner.
LatticePoint on_lattice(const Eigen::Vector2d& cells) {
  constexpr double kHalfCell = 1 << (kLatticeBits - 1);
  return {2 * static_cast<std::int32_t>(cells.x() * kHalfCell) + 1,
          2 * static_cast<std::int32_t>(cells.y() * kHalfCell) + 1};
}

/// Right shift by `bits` of a point's coordinates.
CellIndex shifted(LatticePoint point, int bits) { return {point.x >> bits, point.y >> bits}; }

CellIndex sum(CellIndex one, CellIndex other) { return {one.x + other.x, one.y + other.y}; }

}  // namespace

RayInserter::RayInserter(const RayInsertionParams& params) : params_(params) {
  geometry::ParameterValidator("ray insertion")
      .at_least("hit_centilogits", params.hit_centilogits, kStepCentilogits)
      .at_most("free_centilogits", params.free_centilogits, -kStepCentilogits);
}

void RayInserter::insert(const geometry::Pose2& T_map_sensor,
                         std::span<const Ray> rays,
                         OccupancyGrid& grid) {
  if (!T_map_sensor.position_m().allFinite() || !std::isfinite(T_map_sensor.heading_rad())) {
    return;
  }
  const CellIndex cell = grid.cell_at(T_map_sensor.position_m());
  const CellIndex origin{((cell.x >> kTileBits) - kTilesBefore) << kTileBits,
                         ((cell.y >> kTileBits) - kTilesBefore) << kTileBits};
  place(T_map_sensor, rays, origin, grid.resolution_m());
  if (rays_.empty()) {
    return;
  }
  const LatticePoint sensor = on_lattice(T_map_sensor.position_m() / grid.resolution_m() -
                                         Eigen::Vector2d(origin.x, origin.y));
  LatticePoint low = sensor;
  LatticePoint high = sensor;
  for (const LatticeRay& ray : rays_) {
    low = {std::min(low.x, ray.end.x), std::min(low.y, ray.end.y)};
    high = {std::max(high.x, ray.end.x), std::max(high.y, ray.end.y)};
  }
  const CellBounds tiles{shifted(low, kLatticeTileBits), shifted(high, kLatticeTileBits)};
  mark(sensor, tiles);
  grid.begin_insertion();
  const CellIndex first_tile{origin.x >> kTileBits, origin.y >> kTileBits};
  add_to_grid({sum(first_tile, tiles.min), sum(first_tile, tiles.max)}, grid);
  grid.end_insertion(
      {sum(origin, shifted(low, kLatticeBits)), sum(origin, shifted(high, kLatticeBits))});
}

void RayInserter::place(const geometry::Pose2& T_map_sensor,
                        std::span<const Ray> rays,
                        CellIndex origin,
                        double resolution_m) {
  const Eigen::Vector2d ahead = geometry::unit_vector(T_map_sensor.heading_rad()) / resolution_m;
  const Eigen::Vector2d sensor =
      T_map_sensor.position_m() / resolution_m - Eigen::Vector2d(origin.x, origin.y);
  rays_.clear();
  for (const Ray& ray : rays) {
    Eigen::Vector2d direction =
        ray.end_m.x() * ahead + ray.end_m.y() * geometry::perpendicular(ahead);
    const double square = direction.squaredNorm();
    if (!std::isfinite(square)) {
      continue;
    }
    const bool is_cut = square > kMaxRayCells * kMaxRayCells;
    if (is_cut) {
      direction *= kMaxRayCells / std::sqrt(square);
    }
    rays_.push_back({on_lattice(sensor + direction), ray.is_hit && !is_cut});
  }
}

void RayInserter::mark(LatticePoint sensor, const CellBounds& tiles) {
  const LatticePoint corner{tiles.min.x << kLatticeTileBits, tiles.min.y << kLatticeTileBits};
  const LatticePoint from{sensor.x - corner.x, sensor.y - corner.y};
  crossed_.reset(tiles.columns(), tiles.rows());
  hits_.assign(static_cast<std::size_t>(tiles.columns()) * static_cast<std::size_t>(tiles.rows()),
               TileBits{});
  directions_.clear();
  for (const LatticeRay& ray : rays_) {
    const LatticePoint direction{ray.end.x - sensor.x, ray.end.y - sensor.y};
    if (direction.x != 0 || direction.y != 0) {
      directions_.push_back(direction);
    }
  }
  add_fan(from);
  crossed_.add_rays(from, directions_, fan_.covered_shares());
  for (const LatticeRay& ray : rays_) {
    const LatticePoint to{ray.end.x - corner.x, ray.end.y - corner.y};
    if (ray.is_hit) {
      const CellIndex tile = shifted(to, kLatticeTileBits);
      const CellIndex cell = shifted(to, kLatticeBits);
      const std::int32_t number = tile.y * tiles.columns() + tile.x;
      TileBits& hits = hits_[static_cast<std::size_t>(number)];
      hits[static_cast<std::size_t>(cell.y & (kTileSide - 1))] |= std::uint64_t{1}
                                                                  << (cell.x & (kTileSide - 1));
    }
  }
}

void RayInserter::add_fan(LatticePoint sensor) {
  fan_.reset(directions_);
  for (const Quadrant quadrant :
       {Quadrant::kRightUp, Quadrant::kLeftUp, Quadrant::kLeftDown, Quadrant::kRightDown}) {
    crossed_.add_quadrant(sensor, quadrant, fan_.radius(quadrant));
  }
  constexpr std::array<LatticePoint, 1> kNowhere{};
  constexpr std::array<double, 1> kNothing{};
  crossed_.add_rays(sensor, kNowhere, kNothing);
}

void RayInserter::add_to_grid(const CellBounds& tiles, OccupancyGrid& grid) const {
  const StepPair steps{grid.steps(params_.hit_centilogits).up,
                       grid.steps(params_.free_centilogits).down};
  auto hits = hits_.begin();
  for (std::int32_t y = tiles.min.y; y <= tiles.max.y; ++y) {
    for (std::int32_t x = tiles.min.x; x <= tiles.max.x; ++x, ++hits) {
      const TileBits crossed = crossed_.tile(x - tiles.min.x, y - tiles.min.y);
      std::uint64_t any = 0;
      for (const std::uint64_t row : crossed) {
        any |= row;
      }
      if (any != 0) {
        add_scan(crossed, *hits, steps, grid.limits(), grid.writable_tile({x, y}));
      }
    }
  }
}

}  // namespace echomap::mapping
