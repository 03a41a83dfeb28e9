// SPDX-License-Identifier: MIT
#include "host/mapping/echo_arc.hpp"

#include <gtest/gtest.h>

namespace echomap::mapping {
namespace {

using geometry::Pose2;

/// Floor from the origin to `to_m` ahead, a metre to either side.
OccupancyGrid floor_ahead(double to_m, int centilogits) {
  OccupancyGrid map;
  for (double x_m = 0.0; x_m <= to_m; x_m += map.resolution_m()) {
    for (double y_m = -1.0; y_m <= 1.0; y_m += map.resolution_m()) {
      map.add(map.cell_at({x_m, y_m}), centilogits);
    }
  }
  return map;
}

EchoArc arc_at(double range_m, const OccupancyGrid& map) {
  return arc_of({Pose2(), Pose2(), range_m}, map, {});
}

TEST(EchoArc, OfAnEchoAmidFloorIsFloor) {
  const EchoArc arc = arc_at(1.0, floor_ahead(2.0, -300));
  EXPECT_GT(arc.places, 50U);
  EXPECT_TRUE(arc.is_floor());
  EXPECT_TRUE(arc.is_firm_floor(0.4));
}

TEST(EchoArc, IsFirmWhereMoreThanOneStopHasSeenFloor) {
  const EchoArc arc = arc_at(1.0, floor_ahead(2.0, -200));
  EXPECT_TRUE(arc.is_floor());
  EXPECT_FALSE(arc.is_firm_floor(0.4));
}

TEST(EchoArc, IsNoFloorWhereNothingIsKnown) {
  const EchoArc arc = arc_at(2.0, floor_ahead(2.0, -300));
  EXPECT_GT(arc.unknown, 0U);
  EXPECT_FALSE(arc.is_floor());
  EXPECT_FALSE(arc.is_firm_floor(0.4));
}

TEST(EchoArc, IsNoFloorWhereAnythingStands) {
  OccupancyGrid map = floor_ahead(2.0, -300);
  map.add(map.cell_at({1.0, 0.0}), 600);
  const EchoArc arc = arc_at(1.0, map);
  EXPECT_EQ(arc.occupied > 0, true);
  EXPECT_FALSE(arc.is_firm_floor(0.4));
}

}  // namespace
}  // namespace echomap::mapping
