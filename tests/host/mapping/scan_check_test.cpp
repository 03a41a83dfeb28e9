// SPDX-License-Identifier: MIT
#include "host/mapping/scan_check.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::mapping {
namespace {

using geometry::Pose2;

/// Sixty readings all round from a place of the map.
Scan scan_from(const Pose2& T_map_robot,
               const std::function<std::optional<double>(double bearing_rad)>& range_m) {
  Scan scan;
  for (int i = 0; i < 60; ++i) {
    const Pose2 T_map_sonar = T_map_robot * Pose2(0.0, 0.0, geometry::radians(6.0 * i));
    scan.push_back({T_map_robot, T_map_sonar, range_m(T_map_sonar.heading_rad())});
  }
  return scan;
}

/// As far as the walls of a room from -1 to 2 m along x and from -1 to 1 m along y.
double to_walls_m(const Eigen::Vector2d& from_m, double bearing_rad) {
  const double x = std::cos(bearing_rad);
  const double y = std::sin(bearing_rad);
  const double along_x_m = (x > 0.0 ? 2.0 - from_m.x() : 1.0 + from_m.x()) / std::abs(x);
  const double along_y_m = (y > 0.0 ? 1.0 - from_m.y() : 1.0 + from_m.y()) / std::abs(y);
  return std::min(along_x_m, along_y_m);
}

/// The map of that room, whose floor has so much evidence.
OccupancyGrid room(int floor_centilogits = -400) {
  OccupancyGrid grid;
  for (geometry::CellIndex cell{-21, -21}; cell.y <= 20; ++cell.y) {
    for (cell.x = -21; cell.x <= 40; ++cell.x) {
      const bool is_wall = cell.x == -21 || cell.x == 40 || cell.y == -21 || cell.y == 20;
      grid.add(cell, is_wall ? 400 : floor_centilogits);
    }
  }
  return grid;
}

/// Read at `truly`, while the robot believes to be at `believed`.
ScanFault fault_where(const Pose2& truly,
                      const Pose2& believed,
                      const OccupancyGrid& map = room()) {
  const auto scan = scan_from(believed, [&](double bearing_rad) {
    return to_walls_m(truly.position_m(),
                      bearing_rad - believed.heading_rad() + truly.heading_rad());
  });
  return fault_of(scan, map);
}

TEST(ScanCheck, AScanOfThePlaceHasNoFault) {
  EXPECT_EQ(fault_where({}, {}), ScanFault::kNone);
  EXPECT_EQ(fault_where({1.2, 0.3, 1.0}, {1.2, 0.3, 1.0}), ScanFault::kNone);
  EXPECT_EQ(fault_where({1.2, 0.3, 1.0}, {1.25, 0.26, 1.05}), ScanFault::kNone)
      << "as far off as odometry is between two stops";
}

/// Of a map without a wall: what its stops have heard is compared as well, as long as they are few.
TEST(ScanCheck, AYoungMapHasWhatItsStopsHaveHeard) {
  const auto floor = std::make_shared<OccupancyGrid>();
  for (geometry::CellIndex cell{-40, -40}; cell.y <= 40; ++cell.y) {
    for (cell.x = -40; cell.x <= 60; ++cell.x) {
      floor->add(cell, -200);
    }
  }
  const auto from = [](const Pose2& place) {
    return scan_from(
        place, [&](double bearing_rad) { return to_walls_m(place.position_m(), bearing_rad); });
  };
  const Scan first = from({0.2, 0.1, 0.0});
  const Scan next = from({0.8, -0.3, 1.0});
  EXPECT_EQ(fault_of(next, *floor), ScanFault::kElsewhere);
  EXPECT_EQ(fault_of(next, *compared_map(floor, {first})), ScanFault::kNone);
  Scan of_another_room = next;
  for (PlacedReading& reading : of_another_room) {
    reading.range_m = 0.45;
  }
  EXPECT_EQ(fault_of(of_another_room, *compared_map(floor, {first})), ScanFault::kStuck);
  for (std::size_t i = 0; i < of_another_room.size(); ++i) {
    of_another_room[i].range_m = 0.4 + 0.02 * static_cast<double>(i % 7);
  }
  EXPECT_EQ(fault_of(of_another_room, *compared_map(floor, {first})), ScanFault::kElsewhere);
  EXPECT_EQ(compared_map(floor, {first, first, first}), floor) << "it has walls of its own";
}

/// Every third column of the room's floor is unknown.
OccupancyGrid striped(int floor_centilogits) {
  OccupancyGrid stripes = room(floor_centilogits);
  for (geometry::CellIndex cell{-21, -20}; cell.x < 40; cell.x += 3) {
    for (cell.y = -20; cell.y < 20; ++cell.y) {
      stripes.add(cell, -stripes.centilogits(cell).value_or(0));
    }
  }
  return stripes;
}

TEST(ScanCheck, FloorWithGapsContradictsWhereMoreThanOneStopHasSeenIt) {
  const Pose2 truly(-0.6, 0.6, 0.0);
  const Pose2 believed(1.3, -0.4, 1.0);
  EXPECT_EQ(fault_where(truly, believed, room(-220)), ScanFault::kElsewhere) << "no gaps";
  EXPECT_EQ(fault_where(truly, believed, striped(-220)), ScanFault::kNone);
  EXPECT_EQ(fault_where(truly, believed, striped(-400)), ScanFault::kElsewhere);
}

TEST(ScanCheck, AScanOfAnotherPlaceIsNotOfHere) {
  EXPECT_EQ(fault_where({-0.6, 0.6, 0.0}, {1.3, -0.4, 1.0}), ScanFault::kElsewhere);
  EXPECT_EQ(fault_where({1.4, 0.6, 0.0}, {0.0, 0.0, 0.8}), ScanFault::kElsewhere);
}

TEST(ScanCheck, WhereTheMapKnowsNothingAnyScanWillDo) {
  const auto scan =
      scan_from({}, [](double bearing_rad) { return 1.0 + std::sin(bearing_rad) / 2; });
  EXPECT_EQ(fault_of(scan, OccupancyGrid{}), ScanFault::kNone);
  EXPECT_EQ(fit_of(scan, OccupancyGrid{}).on_floor, 0U);
}

TEST(ScanCheck, SilenceIsNoFaultOfAScan) {
  const auto silent = [](double) { return std::optional<double>(); };
  EXPECT_EQ(fault_of(scan_from({}, silent), room()), ScanFault::kNone);
}

TEST(ScanCheck, OneRangeOverMoreThanAQuarterTurnIsASonarThatHangs) {
  const auto hangs_over = [](double to_rad) {
    return scan_from({}, [=](double bearing_rad) {
      return std::abs(bearing_rad) <= 0.5 * to_rad ? 0.7 : to_walls_m({0.0, 0.0}, bearing_rad);
    });
  };
  EXPECT_EQ(fault_of(hangs_over(7.0), room()), ScanFault::kStuck);
  EXPECT_EQ(fault_of(hangs_over(geometry::radians(60.0)), OccupancyGrid{}), ScanFault::kNone)
      << "a wall as wide as a beam";
}

TEST(ScanCheck, TheNoiseOfASonarInARoundRoomIsNoHanging) {
  const auto scan =
      scan_from({}, [](double bearing_rad) { return 1.0 + 0.02 * std::sin(37.0 * bearing_rad); });
  EXPECT_EQ(fault_of(scan, OccupancyGrid{}), ScanFault::kNone);
}

}  // namespace
}  // namespace echomap::mapping
