// SPDX-License-Identifier: MIT
#include "host/localization/range_table.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/localization/known_floor.hpp"
#include "host/mapping/ray_casting.hpp"

namespace echomap::localization {

namespace {

using geometry::CellIndex;

/// The nearest thing is seen aslant where it is one of so many rays at the edge of the cone.
constexpr std::ptrdiff_t kEdgeRays = 2;

const RangeTableParams& validated(const RangeTableParams& params, const mapping::RasterMap& map) {
  constexpr double kMaxCells = 2000.0;
  geometry::ParameterValidator("range table")
      .at_least("beam_half_angle_rad", params.beam_half_angle_rad, 0)
      .below("beam_half_angle_rad", params.beam_half_angle_rad, std::numbers::pi / 2.0)
      .positive("max_range_m", params.max_range_m)
      .at_most("max_range_m", params.max_range_m, kMaxCells * map.resolution_m());
  return params;
}

/// A cone is filled by two rays a heading; more than that are of no use to a thin beam.
std::vector<Eigen::Vector2f> directions(double beam_half_angle_rad) {
  const std::int32_t count = (beam_half_angle_rad > 0.0 ? 2 : 1) * RangeTable::kHeadings;
  std::vector<Eigen::Vector2f> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i) {
    directions.push_back(geometry::unit_vector(2.0 * std::numbers::pi * i / count).cast<float>());
  }
  return directions;
}

constexpr std::size_t tiles_along(std::int32_t cells) {
  return static_cast<std::size_t>((cells + RangeTable::kTileSide - 1) >> RangeTable::kTileBits);
}

std::size_t codes_begin(CellIndex cell) {
  constexpr std::int32_t kWithin = RangeTable::kTileSide - 1;
  const std::int32_t number = ((cell.y & kWithin) << RangeTable::kTileBits) + (cell.x & kWithin);
  return static_cast<std::size_t>(number) * RangeTable::kHeadings;
}

}  // namespace

RangeTable::RangeTable(const mapping::RasterMap& map, const RangeTableParams& params)
    : params_(validated(params, map)),
      map_(with_unknown_ring(map)),
      field_(map_, params.max_range_m),
      known_floor_(params.ends_with_known_floor
                       ? std::optional<mapping::DistanceField>(std::in_place,
                                                               mapping::with_unknown_occupied(map_),
                                                               params.max_range_m)
                       : std::nullopt),
      kinds_(params.ends_with_known_floor ? 3 : 2),
      parts_((kNothing - 2) / kinds_),
      tile_columns_(static_cast<std::int32_t>(tiles_along(map_.columns()))),
      directions_(directions(params.beam_half_angle_rad)),
      rays_aside_(static_cast<std::int32_t>(params.beam_half_angle_rad *
                                            static_cast<double>(directions_.size()) /
                                            (2.0 * std::numbers::pi))),
      tiles_(tiles_along(map_.columns()) * tiles_along(map_.rows())) {}

std::uint8_t RangeTable::code_of(const models::ExpectedRange& expected) const {
  if (!expected.range_m || *expected.range_m >= params_.max_range_m) {
    return kNothing;
  }
  const double part = std::max(0.0, *expected.range_m) / params_.max_range_m * parts_;
  const std::int32_t kind = expected.is_unseen ? 2 : expected.is_oblique ? 1 : 0;
  return static_cast<std::uint8_t>(1 + kinds_ * static_cast<std::int32_t>(part) + kind);
}

models::ExpectedRange RangeTable::expected_of(std::uint8_t code) const {
  if (code == kNothing) {
    return {};
  }
  const int part = (code - 1) / kinds_;
  const int kind = (code - 1) % kinds_;
  return {(part + 0.5) * params_.max_range_m / parts_, kind == 1, kind == 2};
}

void RangeTable::fill_tile(std::int32_t number) {
  const Tile*& tile = tiles_[static_cast<std::size_t>(number)];
  if (tile != nullptr) {
    return;
  }
  const CellIndex first{number % tile_columns_ * kTileSide, number / tile_columns_ * kTileSide};
  if (!has_floor(first)) {
    static const Tile without_floor{};
    tile = &without_floor;
    return;
  }
  filled_.push_back(std::make_unique<Tile>());
  fill(first, *filled_.back());
  tile = filled_.back().get();
}

std::span<const std::uint8_t, RangeTable::kHeadings> RangeTable::codes_at(CellIndex cell) const {
  const Tile& tile = *tiles_[static_cast<std::size_t>(tile_of(cell))];
  return std::span<const std::uint8_t, kHeadings>(&tile[codes_begin(cell)], kHeadings);
}

std::size_t RangeTable::memory_bytes() const {
  const auto cells = static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
  return filled_.size() * sizeof(Tile) + tiles_.capacity() * sizeof(Tile*) +
         cells * ((known_floor_ ? 2 : 1) * sizeof(float) + sizeof(mapping::CellState));
}

bool RangeTable::has_floor(CellIndex first) const {
  for (std::int32_t y = first.y; y < first.y + kTileSide; ++y) {
    for (std::int32_t x = first.x; x < first.x + kTileSide; ++x) {
      if (is_floor({x, y})) {
        return true;
      }
    }
  }
  return false;
}

void RangeTable::fill(CellIndex first, Tile& tile) const {
  tile.fill(kNoFloor);
  for (std::int32_t y = first.y; y < first.y + kTileSide; ++y) {
    for (std::int32_t x = first.x; x < first.x + kTileSide; ++x) {
      if (is_floor({x, y})) {
        look_round({x, y}, tile.data() + codes_begin({x, y}));
      }
    }
  }
}

void RangeTable::look_round(CellIndex cell, std::uint8_t* codes) const {
  constexpr std::size_t kMaxRays = 2 * std::size_t{kHeadings};
  std::array<float, 2 * kMaxRays> ranges_m{};
  const std::size_t rays = directions_.size();
  mapping::cast_rays(field_,
                     map_.center_m(cell),
                     directions_,
                     params_.max_range_m,
                     std::span(ranges_m).first(rays));
  // Once more round, so that a cone is a stretch of rays.
  std::copy_n(ranges_m.begin(), rays, ranges_m.begin() + static_cast<std::ptrdiff_t>(rays));
  std::array<float, kMaxRays> known_m{};
  known_m.fill(static_cast<float>(params_.max_range_m));
  if (known_floor_) {
    mapping::cast_rays(*known_floor_,
                       map_.center_m(cell),
                       directions_,
                       params_.max_range_m,
                       std::span(known_m).first(rays));
  }
  const std::size_t stride = rays / kHeadings;
  const std::ptrdiff_t in_cone = 2 * rays_aside_ + 1;
  for (std::size_t heading = 0; heading < kHeadings; ++heading) {
    const std::size_t first_ray =
        (heading * stride + rays - static_cast<std::size_t>(rays_aside_)) % rays;
    const float* const first = &ranges_m[first_ray];
    const std::ptrdiff_t nearest = std::min_element(first, first + in_cone) - first;
    const bool is_oblique =
        rays_aside_ > 0 && (nearest < kEdgeRays || nearest >= in_cone - kEdgeRays);
    const float known_on_axis_m = known_m[heading * stride];
    const bool is_unseen = leaves_known_floor(known_on_axis_m, first[nearest]);
    codes[heading] = code_of(is_unseen ? models::ExpectedRange{known_on_axis_m, false, true}
                                       : models::ExpectedRange{first[nearest], is_oblique});
  }
}

}  // namespace echomap::localization
