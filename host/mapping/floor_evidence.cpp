// SPDX-License-Identifier: MIT
#include "host/mapping/floor_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

/// Bounds grow by so many cells at once.
constexpr std::int32_t kGrowth = 64;
/// Cells farther off fall into the last one that is counted.
constexpr double kFar = 1 << 30;
/// A field of more cells is not made: 200 by 200 m at 5 cm take 64 MB.
constexpr std::int64_t kMaxCells = std::int64_t{1} << 24;

CellBounds around(const Eigen::Array2d& low_m, const Eigen::Array2d& high_m, double resolution_m) {
  const auto cell = [&](double at_m) {
    return static_cast<std::int32_t>(std::clamp(std::floor(at_m / resolution_m), -kFar, kFar));
  };
  return {{cell(low_m.x()), cell(low_m.y())}, {cell(high_m.x()), cell(high_m.y())}};
}

/// Around what differs between two profiles from one step to another.
CellBounds between(const Eigen::Vector2d& center_m,
                   const FloorReach& one,
                   const FloorReach& other,
                   std::pair<std::size_t, std::size_t> steps,
                   double resolution_m) {
  Eigen::Array2d low_m = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high_m = -low_m;
  for (std::size_t i = steps.first; i < steps.second; ++i) {
    for (const double edge : {-0.5, 0.5}) {
      const Eigen::Vector2d direction =
          geometry::unit_vector(BearingProfile::bearing_rad(i) + edge * BearingProfile::kStepRad);
      for (const double distance_m :
           {one.heard_m[i], other.heard_m[i], one.silent_m[i], other.silent_m[i]}) {
        const Eigen::Array2d point_m = center_m + distance_m * direction;
        low_m = low_m.min(point_m);
        high_m = high_m.max(point_m);
      }
    }
  }
  return around(low_m - resolution_m, high_m + resolution_m, resolution_m);
}

bool is_other(const FloorReach& one, const FloorReach& other, std::size_t step) {
  return one.heard_m[step] != other.heard_m[step] || one.silent_m[step] != other.silent_m[step];
}

}  // namespace

void FloorEvidence::set(std::size_t index,
                        const Eigen::Vector2d& center_m,
                        const FloorReach& reach) {
  if (index >= stops_.size()) {
    stops_.resize(index + 1);
  }
  auto& stop = stops_[index];
  if (stop && stop->center_m != center_m) {
    change_all(*stop, FloorReach());
    stop.reset();
  }
  if (!stop) {
    stop.emplace(Stop{center_m, FloorReach()});
  }
  change_all(*stop, can_hold(center_m, reach.silent_m.max_m()) ? reach : FloorReach());
}

void FloorEvidence::resize(std::size_t stops) {
  for (std::size_t i = stops; i < stops_.size(); ++i) {
    if (stops_[i]) {
      change_all(*stops_[i], FloorReach());
    }
  }
  stops_.resize(stops);
}

void FloorEvidence::change_all(Stop& stop, const FloorReach& reach) {
  std::size_t from = 0;
  while (from < BearingProfile::kBearings) {
    std::size_t to = from;
    while (to < BearingProfile::kBearings && is_other(stop.reach, reach, to)) {
      ++to;
    }
    if (to > from) {
      change(stop, reach, from, to);
    }
    from = to + 1;
  }
  stop.reach = reach;
}

void FloorEvidence::change(Stop& stop, const FloorReach& reach, std::size_t from, std::size_t to) {
  const CellBounds cells = between(stop.center_m, stop.reach, reach, {from, to}, resolution_m_);
  hold(cells);
  for (std::int32_t y = cells.min.y; y <= cells.max.y; ++y) {
    for (std::int32_t x = cells.min.x; x <= cells.max.x; ++x) {
      const Eigen::Vector2d offset_m =
          resolution_m_ * Eigen::Vector2d(x + 0.5, y + 0.5) - stop.center_m;
      const std::size_t step = BearingProfile::index(std::atan2(offset_m.y(), offset_m.x()));
      const double distance_m = offset_m.norm();
      if (step >= from && step < to) {
        const int change =
            evidence(reach, step, distance_m) - evidence(stop.reach, step, distance_m);
        values_[position({x, y})] += change;
      }
    }
  }
}

bool FloorEvidence::can_hold(const Eigen::Vector2d& center_m, double reach_m) const {
  const double max_m = reach_m + 2.0 * resolution_m_;
  const CellBounds all =
      united(bounds_, around(center_m.array() - max_m, center_m.array() + max_m, resolution_m_));
  const std::int64_t columns = std::int64_t{all.max.x} - all.min.x + 1 + 2 * kGrowth;
  const std::int64_t rows = std::int64_t{all.max.y} - all.min.y + 1 + 2 * kGrowth;
  return columns <= kMaxCells && rows <= kMaxCells && columns * rows <= kMaxCells;
}

void FloorEvidence::hold(const CellBounds& bounds) {
  const CellBounds wanted = united(bounds_, bounds);
  if (!bounds_.empty() && wanted.columns() == bounds_.columns() &&
      wanted.rows() == bounds_.rows()) {
    return;
  }
  const CellBounds before = bounds_;
  const std::vector<std::int32_t> values = std::move(values_);
  bounds_ = {{wanted.min.x - kGrowth, wanted.min.y - kGrowth},
             {wanted.max.x + kGrowth, wanted.max.y + kGrowth}};
  values_.assign(
      static_cast<std::size_t>(bounds_.columns()) * static_cast<std::size_t>(bounds_.rows()), 0);
  auto row = values.begin();
  for (std::int32_t y = before.min.y; y <= before.max.y; ++y) {
    std::copy(row,
              row + before.columns(),
              values_.begin() + static_cast<std::ptrdiff_t>(position({before.min.x, y})));
    row += before.columns();
  }
}

int FloorEvidence::evidence(const FloorReach& reach, std::size_t step, double distance_m) const {
  if (distance_m >= reach.silent_m[step]) {
    return 0;
  }
  const int full = faded(distance_m);
  return distance_m < reach.heard_m[step]
             ? full
             : static_cast<int>(std::lround(params_.silent_share * full));
}

std::size_t FloorEvidence::position(geometry::CellIndex cell) const {
  return static_cast<std::size_t>(cell.y - bounds_.min.y) *
             static_cast<std::size_t>(bounds_.columns()) +
         static_cast<std::size_t>(cell.x - bounds_.min.x);
}

int FloorEvidence::faded(double distance_m) const {
  return static_cast<int>(
      std::lround(params_.free_centilogits * std::exp(-distance_m / params_.fade_m)));
}

}  // namespace echomap::mapping
