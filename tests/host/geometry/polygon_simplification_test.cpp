// SPDX-License-Identifier: MIT
#include "host/geometry/polygon_simplification.hpp"

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

TEST(PolygonSimplification, DropsWhatLiesOnAStraightWay) {
  EXPECT_EQ(simplified_way({{0, 0}, {1, 0.01}, {2, -0.01}, {3, 0}, {3, 2}}, 0.02).size(), 3U);
  EXPECT_EQ(simplified_way({{0, 0}, {1, 0.03}, {2, 0}}, 0.02).size(), 3U);
}

TEST(PolygonSimplification, LeavesShortWaysAlone) {
  EXPECT_TRUE(simplified_way({}, 1.0).empty());
  EXPECT_EQ(simplified_way({{0, 0}, {1, 0}}, 1.0).size(), 2U);
}

TEST(PolygonSimplification, FindsTheFourCornersOfARectangleWithPointsOnItsSides) {
  Polygon dense;
  for (int i = 0; i < 40; ++i) {
    dense.emplace_back(0.1 * i, i % 2 == 0 ? 0.0 : 0.01);
  }
  for (const Eigen::Vector2d& corner : Polygon{{4, 0}, {4, 3}, {2, 3.01}, {0, 3}, {0, 1.5}}) {
    dense.push_back(corner);
  }
  EXPECT_EQ(simplified_polygon(dense, 0.05).size(), 4U);
}

TEST(PolygonSimplification, KeepsTheSameWaysAsBoost) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon way = tests::random_polygon(random, 40);
    BoostWay other;
    for (const auto& point : way) {
      other.emplace_back(point.x(), point.y());
    }
    const double tolerance_m = 0.1 + 0.01 * trial;
    BoostWay expected;
    bg::simplify(other, expected, tolerance_m);
    const auto simple = simplified_way(way, tolerance_m);
    ASSERT_EQ(simple.size(), expected.size()) << trial;
    for (std::size_t i = 0; i < simple.size(); ++i) {
      EXPECT_EQ(simple[i], Eigen::Vector2d(expected[i].x(), expected[i].y())) << trial;
    }
  }
}

TEST(PolygonSimplification, StaysWithinTheTolerance) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon polygon = tests::random_polygon(random, 60);
    const double tolerance_m = 0.002 * trial;
    const Polygon simple = simplified_polygon(polygon, tolerance_m);
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
