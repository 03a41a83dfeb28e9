// SPDX-License-Identifier: MIT
#include "host/evaluation/floor_outline.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "host/geometry/straight_corners.hpp"

namespace echomap::evaluation {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false>;
using BoostPolygons = bg::model::multi_polygon<BoostPolygon>;

/// Where two obstacles meet at a wall there is no corner.
constexpr double kStraightM = 0.001;

BoostPolygon boost_polygon(const geometry::Polygon& ring_m) {
  BoostPolygon polygon;
  for (const Eigen::Vector2d& corner_m : ring_m) {
    bg::append(polygon.outer(), BoostPoint(corner_m.x(), corner_m.y()));
  }
  bg::correct(polygon);
  return polygon;
}

}  // namespace

geometry::Polygon floor_outline(const std::vector<geometry::Polygon>& rings) {
  if (rings.empty()) {
    return {};
  }
  BoostPolygons floor{boost_polygon(rings.front())};
  for (std::size_t i = 1; i < rings.size(); ++i) {
    BoostPolygons rest;
    bg::difference(floor, boost_polygon(rings[i]), rest);
    floor = rest;
  }
  const auto largest = std::max_element(
      floor.begin(), floor.end(), [](const BoostPolygon& a, const BoostPolygon& b) {
        return bg::area(a) < bg::area(b);
      });
  geometry::Polygon outline_m;
  for (std::size_t i = 1; largest != floor.end() && i < largest->outer().size(); ++i) {
    outline_m.emplace_back(largest->outer()[i].x(), largest->outer()[i].y());
  }
  return geometry::without_straight_corners(std::move(outline_m), kStraightM);
}

}  // namespace echomap::evaluation
