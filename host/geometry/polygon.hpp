// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"

namespace echomap::geometry {

/// Corners in order, in metres; the last is joined to the first.
using Polygon = std::vector<Eigen::Vector2d>;

/// The side from corner `index` to the next one.
Segment side(const Polygon& polygon, std::size_t index);

/// Positive where the corners run counter-clockwise.
double signed_area_m2(const Polygon& polygon);

/// Distance from a point to the nearest side.
double distance_to_sides_m(const Polygon& polygon, const Eigen::Vector2d& point_m);

/// Whether a point is strictly inside; what lies on a side belongs to neither side.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point_m);

/// Whether no corner of `inner` is outside of `outer` and no sides cross; they may touch.
bool contains(const Polygon& outer, const Polygon& inner);

/// Why no polygon has these corners: too few, or two in a row that are the same.
std::optional<std::string> corner_fault(const Polygon& polygon);

/// Why the corners do not bound an area: a `corner_fault`, or sides that cross or touch.
std::optional<std::string> polygon_fault(const Polygon& polygon);

}  // namespace echomap::geometry
