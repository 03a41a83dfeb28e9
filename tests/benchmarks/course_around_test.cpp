// SPDX-License-Identifier: MIT
#include "tests/benchmarks/course_around.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/strategies/course_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

using exploration::Waypoint;
using geometry::Polygon;

const Polygon kBox{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {0.0, 1.5}};
const Polygon kL{{0.0, 0.0}, {3.5, 0.0}, {3.5, 1.5}, {1.6, 1.5}, {1.6, 3.5}, {0.0, 3.5}};

TEST(CourseAround, GoesCounterClockwiseFromTheNearestCornerAndBack) {
  const auto course = course_around(kBox, {1.7, 0.3, 1.0});
  ASSERT_EQ(course.waypoints.size(), 5U);
  const std::vector<Eigen::Vector2d> expected_m{
      {1.75, 0.25}, {1.75, 1.25}, {0.25, 1.25}, {0.25, 0.25}, {1.7, 0.3}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR((course.waypoints[i].position_m - expected_m[i]).norm(), 0.0, 1e-9) << i;
  }
  EXPECT_EQ(course.waypoints.front().name, "corner 1");
  EXPECT_EQ(course.waypoints.back().name, "start");
  EXPECT_EQ(course.waypoints.back().position_m, expected_m.back());
}

TEST(CourseAround, KnowsTheRoomsSidesAndHasAGridAroundThem) {
  const auto course = course_around(kL, {0.7, 0.7, 0.0});
  EXPECT_EQ(course.known_walls.size(), 6U);
  EXPECT_EQ(course.known_walls.back().to_m, kL.front());
  const mapping::CellBounds& cells = course.cells;
  EXPECT_EQ(cells.min, (geometry::CellIndex{-4, -4}));
  EXPECT_EQ(cells.max, (geometry::CellIndex{74, 74}));
}

TEST(CourseAround, LeavesOutWhatTheRoomHasNoPlaceFor) {
  const auto course = course_around(kL, {0.7, 0.7, 0.0});
  for (const Waypoint& waypoint : course.waypoints) {
    EXPECT_TRUE(geometry::contains(kL, waypoint.position_m)) << waypoint.name;
    EXPECT_NE(waypoint.name, "corner 3");
  }
}

TEST(CourseAround, HasNoLegLongerThanTheSpacing) {
  const Polygon hall{{0.0, 0.0}, {9.0, 0.0}, {9.0, 4.0}, {0.0, 4.0}};
  const auto course = course_around(hall, {1.0, 1.0, 0.0});
  Eigen::Vector2d from_m(1.0, 1.0);
  for (const Waypoint& waypoint : course.waypoints) {
    EXPECT_LE((waypoint.position_m - from_m).norm(), 1.5 + 1e-9) << waypoint.name;
    from_m = waypoint.position_m;
  }
  EXPECT_EQ(from_m, Eigen::Vector2d(1.0, 1.0));
}

TEST(CourseAround, RefusesWhatHasNoCorners) {
  EXPECT_THROW(course_around({{0.0, 0.0}, {1.0, 0.0}}, {}), std::invalid_argument);
  EXPECT_THROW(course_around({{0.0, 0.0}, {0.3, 0.0}, {0.3, 0.3}, {0.0, 0.3}}, {}),
               std::invalid_argument);
  EXPECT_THROW(course_around(kBox, {}, {.spacing_m = 0.0}), std::invalid_argument);
}

TEST(CourseAround, IsReadAsItWasWritten) {
  const tests::ScratchFolder folder;
  const geometry::Polygon outline_m{{-1.0, -0.5}, {2.0, -0.5}, {2.0, 2.6}, {-1.0, 2.6}};
  auto course = course_around(outline_m, {0.1, 0.2, 0.7});
  course.name = "my \"room\"";
  write_course(folder / "course.toml", course);
  const auto read = strategies::load_course(folder / "course.toml");
  EXPECT_EQ(read.name, course.name);
  EXPECT_EQ(read.cells.min, course.cells.min);
  EXPECT_EQ(read.cells.max, course.cells.max);
  EXPECT_EQ(read.cell_m, course.cell_m);
  EXPECT_NEAR(read.T_course_start.heading_rad(), 0.7, 1e-12);
  ASSERT_EQ(read.known_walls.size(), course.known_walls.size());
  ASSERT_EQ(read.waypoints.size(), course.waypoints.size());
  for (std::size_t i = 0; i < read.waypoints.size(); ++i) {
    EXPECT_EQ(read.waypoints[i].name, course.waypoints[i].name);
    EXPECT_EQ(read.waypoints[i].position_m, course.waypoints[i].position_m);
  }
}

}  // namespace
}  // namespace echomap::bench
