// SPDX-License-Identifier: MIT
#include "host/geometry/polygon_simplification.hpp"

#include <algorithm>
#include <cstddef>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <gtest/gtest.h>

#include "tests/support/random_polygon.hpp"

namespace echomap::geometry {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostWay = bg::model::linestring<BoostPoint>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, false>;

BoostPolygon to_boost(const Polygon& polygon) {
  BoostPolygon other;
  for (const auto& corner : polygon) {
    other.outer().emplace_back(corner.x(), corner.y());
  }
  return other;
}

Polygon simplified(const Polygon& ring, double tolerance_m) {
  return SimplifiedRing(ring, tolerance_m).polygon();
}

/// What Boost leaves of the way along `ring` from one of its corners to another, the latter left
/// out.
Polygon simplified_by_boost(const Polygon& ring,
                            std::size_t first,
                            std::size_t last,
                            double tolerance_m) {
  BoostWay path;
  for (std::size_t i = first; i != last; i = (i + 1) % ring.size()) {
    path.emplace_back(ring[i].x(), ring[i].y());
  }
  path.emplace_back(ring[last].x(), ring[last].y());
  BoostWay simple;
  bg::simplify(path, simple, tolerance_m);
  Polygon corners;
  for (const BoostPoint& point : simple) {
    corners.emplace_back(point.x(), point.y());
  }
  corners.pop_back();
  return corners;
}

std::size_t max_from(const Polygon& ring, const Eigen::Vector2d& place_m) {
  const auto farthest = std::max_element(ring.begin(), ring.end(), [&](auto& one, auto& other) {
    return (one - place_m).squaredNorm() < (other - place_m).squaredNorm();
  });
  return static_cast<std::size_t>(farthest - ring.begin());
}

TEST(PolygonSimplification, FindsTheFourCornersOfARectangleWithPointsOnItsSides) {
  Polygon dense;
  for (int i = 0; i < 40; ++i) {
    dense.emplace_back(0.1 * i, i % 2 == 0 ? 0.0 : 0.01);
  }
  for (const Eigen::Vector2d& corner : Polygon{{4, 0}, {4, 3}, {2, 3.01}, {0, 3}, {0, 1.5}}) {
    dense.push_back(corner);
  }
  EXPECT_EQ(simplified(dense, 0.05).size(), 4U);
}

TEST(PolygonSimplification, KeepsTheSameCornersAsBoostBetweenTwoFarApart) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon ring = tests::random_polygon(random, 40);
    const double tolerance_m = 0.1 + 0.01 * trial;
    const std::size_t first = max_from(ring, ring.front());
    const std::size_t middle = max_from(ring, ring[first]);
    Polygon expected = simplified_by_boost(ring, first, middle, tolerance_m);
    const Polygon back = simplified_by_boost(ring, middle, first, tolerance_m);
    expected.insert(expected.end(), back.begin(), back.end());
    EXPECT_EQ(simplified(ring, tolerance_m), expected) << trial;
  }
}

TEST(PolygonSimplification, StaysWithinTheTolerance) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon polygon = tests::random_polygon(random, 60);
    const double tolerance_m = 0.002 * trial;
    const Polygon simple = simplified(polygon, tolerance_m);
    ASSERT_GE(simple.size(), 2U);
    for (const auto& corner : polygon) {
      EXPECT_LE(distance_to_sides_m(simple, corner), tolerance_m + 1e-12) << trial;
    }
  }
}

TEST(PolygonSimplification, SplitsASideAtItsFarthestCornerUntilNoneIsDropped) {
  const Polygon ring{{0, 0}, {1, 0.2}, {2, 0.3}, {3, 0.1}, {4, 0}, {4, 2}, {0, 2}};
  SimplifiedRing simple(ring, 0.5);
  ASSERT_EQ(simple.polygon().size(), 4U);
  for (std::size_t side = 0; side < 4; ++side) {
    if (simple.split(side)) {
      EXPECT_EQ(simple.polygon()[side + 1], Eigen::Vector2d(2, 0.3));
      EXPECT_TRUE(simple.split(side + 1));
      EXPECT_TRUE(simple.split(side));
      EXPECT_FALSE(simple.split(side));
    }
  }
  EXPECT_EQ(simple.polygon().size(), ring.size());
}

TEST(Polygon, HasTheAreaThatBoostFinds) {
  std::mt19937 random(13);
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon polygon = tests::random_polygon(random, 3 + static_cast<std::size_t>(trial % 50));
    EXPECT_NEAR(signed_area_m2(polygon), bg::area(to_boost(polygon)), 1e-9) << trial;
  }
}

TEST(Polygon, HoldsThePointsThatBoostFindsInside) {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> place_m(-3.0, 3.0);
  for (int trial = 0; trial < 100; ++trial) {
    const Polygon polygon = tests::random_polygon(random, 3 + static_cast<std::size_t>(trial % 30));
    const BoostPolygon other = to_boost(polygon);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector2d point(place_m(random), place_m(random));
      EXPECT_EQ(contains(polygon, point), bg::within(BoostPoint(point.x(), point.y()), other))
          << trial << ": " << point.transpose();
    }
  }
}

TEST(Polygon, HasAFaultWhereBoostCallsItInvalid) {
  std::mt19937 random(15);
  std::uniform_real_distribution<double> place_m(-3.0, 3.0);
  int faults = 0;
  for (int trial = 0; trial < 500; ++trial) {
    Polygon polygon;
    for (int i = 0; i < 3 + trial % 5; ++i) {
      polygon.emplace_back(place_m(random), place_m(random));
    }
    if (signed_area_m2(polygon) < 0.0) {
      std::reverse(polygon.begin(), polygon.end());
    }
    const bool fault = polygon_fault(polygon).has_value();
    EXPECT_EQ(fault, !bg::is_valid(to_boost(polygon))) << trial;
    faults += fault ? 1 : 0;
  }
  EXPECT_GT(faults, 50);
  EXPECT_LT(faults, 450);
}

}  // namespace
}  // namespace echomap::geometry
