// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_mapper.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/mapping/raster_map.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/smooth_room.hpp"

namespace echomap::mapping {
namespace {

using tests::scan_of;
using tests::SmoothRoom;

const SmoothRoom kRoom = tests::smooth_rectangle();

TEST(SonarMapper, DrawsTheFloorAndTheWallsThatSeveralStopsAgreeOn) {
  SonarMapperParams coarse;
  coarse.grid.resolution_m = 0.2;
  SonarMapper mapper(coarse);
  mapper.add(scan_of(kRoom, {0.0, 0.0}));
  mapper.add(scan_of(kRoom, {0.5, 0.2}));
  mapper.add(scan_of(kRoom, {-0.4, 0.3}));
  mapper.add(scan_of(kRoom, {0.2, -0.2}));
  // The centres of the lowest and the highest row lie on the walls: these are either.
  EXPECT_EQ(tests::drawing_of(rasterize(mapper.grid())),
            (tests::DrawnMap{"               ",
                             " #  ######   # ",
                             "  ...........  ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             "  .########  # ",
                             "               "}));
}

TEST(SonarMapper, NeverCallsFloorWhatLiesBehindAWall) {
  SonarMapper mapper;
  for (const double x_m : {-0.5, 0.0, 0.4, 0.8}) {
    mapper.add(scan_of(kRoom, {x_m, 0.2 * x_m}));
  }
  const OccupancyGrid grid = mapper.grid();
  const auto bounds = grid.bounds();
  for (int y = bounds.min.y; y <= bounds.max.y; ++y) {
    for (int x = bounds.min.x; x <= bounds.max.x; ++x) {
      const Eigen::Vector2d cell_m = grid.center_m({x, y});
      const bool behind =
          cell_m.x() > 1.35 || cell_m.x() < -1.15 || cell_m.y() > 0.95 || cell_m.y() < -0.75;
      EXPECT_FALSE(behind && grid.state({x, y}) == CellState::kFree) << cell_m.transpose();
    }
  }
}

TEST(SonarMapper, LearnsNothingFromSilence) {
  SonarMapper mapper;
  mapper.add(scan_of({}));
  mapper.add({});
  EXPECT_TRUE(mapper.grid().bounds().empty());
}

TEST(SonarMapper, LearnsLittleFromOneReading) {
  SonarMapper mapper;
  mapper.add({scan_of(kRoom).front()});
  EXPECT_TRUE(mapper.grid().bounds().empty());
}

TEST(SonarMapper, TakesARangeThatIsTheSameAllAroundForARound) {
  Scan scan = scan_of({});
  for (auto& reading : scan) {
    reading.range_m = 4.0;
  }
  SonarMapper mapper;
  mapper.add(scan);
  const OccupancyGrid grid = mapper.grid();
  EXPECT_NE(grid.state(grid.cell_at({0.0, 0.0})), CellState::kOccupied);
  EXPECT_FALSE(grid.centilogits(grid.cell_at({4.3, 0.0})).has_value());
}

TEST(SonarMapper, RefusesParametersWithoutSense) {
  SonarMapperParams no_beam;
  no_beam.surfaces.beam_half_angle_rad = 0.0;
  EXPECT_THROW(SonarMapper{no_beam}, std::invalid_argument);
  SonarMapperParams no_fade;
  no_fade.fade_m = 0.0;
  EXPECT_THROW(SonarMapper{no_fade}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::mapping
