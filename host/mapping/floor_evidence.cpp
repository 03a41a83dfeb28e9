// SPDX-License-Identifier: MIT
#include "host/mapping/floor_evidence.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

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
  return cells_around(low_m - resolution_m, high_m + resolution_m, resolution_m);
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
  const double max_m = reach.silent_m.max_m() + 2.0 * resolution_m_;
  const CellBounds cells =
      cells_around(center_m.array() - max_m, center_m.array() + max_m, resolution_m_);
  change_all(*stop, sums_.can_hold(cells) ? reach : FloorReach());
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
  sums_.hold(cells);
  for (std::int32_t y = cells.min.y; y <= cells.max.y; ++y) {
    for (std::int32_t x = cells.min.x; x <= cells.max.x; ++x) {
      const Eigen::Vector2d offset_m =
          resolution_m_ * Eigen::Vector2d(x + 0.5, y + 0.5) - stop.center_m;
      const std::size_t step = BearingProfile::index(std::atan2(offset_m.y(), offset_m.x()));
      const double distance_m = offset_m.norm();
      if (step >= from && step < to) {
        const int change =
            evidence(reach, step, distance_m) - evidence(stop.reach, step, distance_m);
        sums_.add({x, y}, change);
      }
    }
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

int FloorEvidence::faded(double distance_m) const {
  return static_cast<int>(
      std::lround(params_.free_centilogits * std::exp(-distance_m / params_.fade_m)));
}

}  // namespace echomap::mapping
