// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

/// Distances all around a place, by bearing in the map frame.
class BearingProfile {
 public:
  /// Half a degree: a third of a cell at 2 m.
  static constexpr std::size_t kBearings = 720;
  static constexpr double kStepRad = 2.0 * std::numbers::pi / kBearings;

  explicit BearingProfile(double distance_m) { distances_m_.fill(distance_m); }

  static std::size_t index(double bearing_rad);
  /// The middle of a step.
  static double bearing_rad(std::size_t index);
  /// Calls `visit(index)` for the steps whose middles lie within `half_rad` of a bearing.
  template <class Visit>
  static void visit_about(double bearing_rad, double half_rad, Visit&& visit) {
    const double from = (bearing_rad - half_rad + std::numbers::pi) / kStepRad - 0.5;
    const double to = (bearing_rad + half_rad + std::numbers::pi) / kStepRad - 0.5;
    constexpr auto kAll = static_cast<std::int64_t>(kBearings);
    const auto first = static_cast<std::int64_t>(std::ceil(from));
    const auto last = std::min(static_cast<std::int64_t>(std::floor(to)), first + kAll - 1);
    for (std::int64_t i = first; i <= last; ++i) {
      visit(static_cast<std::size_t>(((i % kAll) + kAll) % kAll));
    }
  }

  double& operator[](std::size_t index) { return distances_m_[index]; }
  double operator[](std::size_t index) const { return distances_m_[index]; }
  double max_m() const;

 private:
  std::array<double, kBearings> distances_m_;
};

/// The nearest that was heard within `half_rad` of each direction: infinity for silence, 0 where
/// nobody has listened. The bearings of `looks` are in the map frame.
BearingProfile heard_within(const std::vector<sensors::Beam>& looks, double half_rad);

}  // namespace echomap::mapping
