// SPDX-License-Identifier: MIT
#include "host/geometry/reflex_outline.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <gtest/gtest.h>

#include "tests/support/random_polygon.hpp"

namespace echomap::geometry {
namespace {

using BoostPoint = boost::geometry::model::d2::point_xy<double>;
using BoostPolygon = boost::geometry::model::polygon<BoostPoint>;

BoostPolygon to_boost(const Polygon& outline_m) {
  BoostPolygon polygon;
  for (const Eigen::Vector2d& corner_m : outline_m) {
    boost::geometry::append(polygon.outer(), BoostPoint(corner_m.x(), corner_m.y()));
  }
  boost::geometry::correct(polygon);
  return polygon;
}

/// How many of many points around an outline are told apart otherwise than by Boost.Geometry.
int differences(const Polygon& outline_m, std::mt19937& random, int points) {
  const ReflexOutline outline(outline_m);
  const BoostPolygon reference = to_boost(outline_m);
  std::uniform_real_distribution<double> any(-3.2, 3.2);
  int count = 0;
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector2d point_m(any(random), any(random));
    const bool within = boost::geometry::within(BoostPoint(point_m.x(), point_m.y()), reference);
    count += outline.contains(point_m) != within ? 1 : 0;
  }
  return count;
}

/// Corridors that wind around each other so often, all of the same width: the cut of a cut.
Polygon spiral(int turns) {
  constexpr double kWidthM = 0.1;
  Polygon outer_m;
  Polygon inner_m;
  for (int i = 0; i < 4 * turns; ++i) {
    const double radius_m = 2.5 - 0.08 * i;
    const double way_rad = 0.25 * std::numbers::pi + 0.5 * std::numbers::pi * i;
    outer_m.emplace_back(radius_m * unit_vector(way_rad));
    inner_m.emplace_back((radius_m - kWidthM) * unit_vector(way_rad));
  }
  outer_m.insert(outer_m.end(), inner_m.rbegin(), inner_m.rend());
  return outer_m;
}

TEST(ReflexOutline, AgreesWithBoostOnRandomPolygons) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Polygon outline_m = tests::random_polygon(random, 3 + static_cast<std::size_t>(i) % 40);
    ASSERT_EQ(differences(outline_m, random, 100), 0) << "polygon " << i;
  }
}

TEST(ReflexOutline, AgreesWithBoostWhereCutsLieInEachOther) {
  std::mt19937 random(1);
  for (int turns = 1; turns <= 5; ++turns) {
    ASSERT_EQ(polygon_fault(spiral(turns)), std::nullopt);
    EXPECT_EQ(differences(spiral(turns), random, 5000), 0) << turns;
  }
}

TEST(ReflexOutline, TakesOutlinesOfEitherSense) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    Polygon outline_m = tests::random_polygon(random, 12);
    std::reverse(outline_m.begin(), outline_m.end());
    ASSERT_EQ(differences(outline_m, random, 50), 0) << "polygon " << i;
  }
}

TEST(ReflexOutline, NoPointOfADiagonalIsLost) {
  // A star of whole numbers, whose diagonals meet in points that are exact.
  const Polygon star{{2.0, 0.0},
                     {1.0, 1.0},
                     {0.0, 2.0},
                     {-1.0, 1.0},
                     {-2.0, 0.0},
                     {-1.0, -1.0},
                     {0.0, -2.0},
                     {1.0, -1.0}};
  const ReflexOutline outline(star);
  for (double x_m = -1.75; x_m < 2.0; x_m += 0.25) {
    for (double y_m = -1.75; y_m < 2.0; y_m += 0.25) {
      if (std::abs(x_m) + std::abs(y_m) < 2.0) {
        EXPECT_TRUE(outline.contains({x_m, y_m})) << x_m << ", " << y_m;
      }
    }
  }
}

TEST(ReflexCut, IsThatOfThePapersFigureSix) {
  // A room with a buttress of two reflex corners.
  const Polygon room{{0.0, 0.0},
                     {4.0, 0.0},
                     {4.0, 3.0},
                     {3.0, 3.0},
                     {2.5, 2.0},
                     {1.5, 2.0},
                     {1.0, 3.0},
                     {0.0, 3.0}};
  const ReflexCut cut = cut_reflex_corners(room);
  EXPECT_EQ(cut.outer_m,
            (Polygon{{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {3.0, 3.0}, {1.0, 3.0}, {0.0, 3.0}}));
  ASSERT_EQ(cut.parts_m.size(), 1U);
  EXPECT_EQ(cut.parts_m[0], (Polygon{{3.0, 3.0}, {2.5, 2.0}, {1.5, 2.0}, {1.0, 3.0}}));
  const ReflexOutline outline(room);
  EXPECT_EQ(outline.triangles().size(), 6U);
  EXPECT_TRUE(outline.contains({2.0, 1.9}));
  EXPECT_FALSE(outline.contains({2.0, 2.5}));
  EXPECT_TRUE(outline.contains({0.5, 2.9}));
}

TEST(ReflexCut, LeavesAConvexRoomWhole) {
  const Polygon room{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}};
  EXPECT_TRUE(cut_reflex_corners(room).parts_m.empty());
  EXPECT_EQ(cut_reflex_corners(room).outer_m, room);
}

TEST(ReflexOutline, RefusesAnOutlineThatCrossesItself) {
  EXPECT_THROW(ReflexOutline({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::geometry
