// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/polygon.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// A corner as the floor sees it: less than half a turn of floor, as in the corner of a room, or
/// more, as around the edge of a cupboard (Mukherjee et al., section IV-B).
enum class CornerKind : std::uint8_t { kNonReflex, kReflex };

/// A room as an outline of straight walls (Mukherjee et al.), and what stands in it as holes. In
/// metres of the map frame, the floor always to the left: the outline runs counter-clockwise, the
/// holes clockwise.
class PolygonMap {
 public:
  /// Takes rings of either sense. Throws std::invalid_argument where sides of any of them cross or
  /// touch, or a hole is not inside of the outline.
  explicit PolygonMap(geometry::Polygon outline_m, std::vector<geometry::Polygon> holes_m = {});

  const geometry::Polygon& outline_m() const { return outline_m_; }
  const std::vector<geometry::Polygon>& holes_m() const { return holes_m_; }

  /// Whether a point lies on the floor; the walls do not.
  bool contains(const Eigen::Vector2d& point_m) const;
  /// Of the floor.
  double area_m2() const;

 private:
  geometry::Polygon outline_m_;
  std::vector<geometry::Polygon> holes_m_;
};

/// The kind of corner `index` of a ring of a PolygonMap.
CornerKind corner_kind(const geometry::Polygon& ring, std::size_t index);

/// How much of a border is detail.
struct PolygonMapParams {
  /// Corners are dropped as long as none of them lies farther from the new outline. 7.5 cm are one
  /// and a half cells of a grid of 5 cm, so that the stairs of a slanted wall go.
  double tolerance_m = 0.075;
  /// A smaller hole is a cell or two that no echo has told of, not something that stands there.
  double min_hole_m2 = 0.02;
};

/// The map of the largest connected piece of free floor; empty where no cell is free. Throws
/// std::invalid_argument for a negative parameter.
std::optional<PolygonMap> polygon_from_raster(const RasterMap& map,
                                              const PolygonMapParams& params = {});

}  // namespace echomap::mapping
