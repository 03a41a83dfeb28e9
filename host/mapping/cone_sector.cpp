// SPDX-License-Identifier: MIT
#include "host/mapping/cone_sector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/mapping/grid_tile.hpp"

namespace echomap::mapping {

namespace {

bool has_cells(const SectorRow& row) { return row.last >= row.first; }

/// The cosines of the bearings within `half_rad` of one that is `off_rad` off an axis.
ShareRange cosines(double off_rad, double half_rad) {
  const double off = std::abs(geometry::wrap_angle(off_rad));
  return {std::cos(std::min(off + half_rad, std::numbers::pi)),
          std::cos(std::max(off - half_rad, 0.0))};
}

}  // namespace

ConeSector::ConeSector(std::vector<std::uint8_t> steps_by_angle,
                       double half_opening_rad,
                       std::int32_t radius_cells)
    : steps_by_angle_(std::move(steps_by_angle)),
      half_opening_rad_(half_opening_rad),
      radius_cells_(radius_cells) {}

const FacingSector& ConeSector::facing(std::size_t bearing) {
  FacingSector& facing = facing_[bearing];
  if (facing.rows.empty()) {
    facing = lay_out(geometry::radians(static_cast<double>(bearing)));
  }
  return facing;
}

FacingSector ConeSector::lay_out(double axis_rad) const {
  FacingSector facing{-radius_cells_,
                      {},
                      std::vector<std::uint8_t>(kTileSide),
                      cosines(axis_rad, half_opening_rad_),
                      cosines(axis_rad - std::numbers::pi / 2.0, half_opening_rad_)};
  const Eigen::Vector2d axis = geometry::unit_vector(axis_rad);
  for (std::int32_t y = -radius_cells_; y <= radius_cells_; ++y) {
    SectorRow row{0, -1, static_cast<std::uint32_t>(facing.steps.size())};
    for (std::int32_t x = -radius_cells_; x <= radius_cells_; ++x) {
      const std::uint8_t steps = steps_at({x, y}, axis);
      if (steps != 0) {
        row.first = has_cells(row) ? row.first : static_cast<std::int16_t>(x);
        row.last = static_cast<std::int16_t>(x);
        facing.steps.push_back(steps);
      }
    }
    if (facing.rows.empty() && !has_cells(row)) {
      ++facing.first_row;
    } else {
      facing.rows.push_back(row);
    }
  }
  facing.steps.resize(facing.steps.size() + kTileSide);
  return facing;
}

std::uint8_t ConeSector::steps_at(const Eigen::Vector2d& from_apex,
                                  const Eigen::Vector2d& axis) const {
  if (from_apex.isZero(0.0)) {
    return steps_by_angle_.front();
  }
  const double ahead = axis.dot(from_apex);
  const double aside = std::abs(axis.x() * from_apex.y() - axis.y() * from_apex.x());
  if (ahead < 0.0 || from_apex.squaredNorm() > std::pow(radius_cells_, 2)) {
    return 0;
  }
  const double off_axis_rad = std::atan2(aside, ahead);
  const auto part = static_cast<std::size_t>(off_axis_rad / half_opening_rad_ *
                                             static_cast<double>(steps_by_angle_.size()));
  return part < steps_by_angle_.size() ? steps_by_angle_[part] : std::uint8_t{0};
}

}  // namespace echomap::mapping
