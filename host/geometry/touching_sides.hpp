// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "host/geometry/polygon.hpp"

namespace echomap::geometry {

/// One side of one of several rings.
struct RingSide {
  std::size_t ring = 0;
  std::size_t side = 0;

  auto operator<=>(const RingSide&) const = default;
};

/// Two sides that have a point in common.
struct TouchingSides {
  RingSide first;
  RingSide second;

  auto operator<=>(const TouchingSides&) const = default;
};

/// All pairs of sides that touch or cross, `first` before `second`, in their order. Sides of one
/// ring that follow each other always share a corner: they count where one folds back onto the
/// other. A sweep along x: what it costs beyond sorting goes with the sides that lie above each
/// other.
std::vector<TouchingSides> touching_sides(const std::vector<Polygon>& rings);

}  // namespace echomap::geometry
