// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_mapper.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

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

TEST(SonarMapper, TakesStopsThatWereMovedOrBentAsIfItHadNotKnownThem) {
  const std::vector<Scan> heard{scan_of(kRoom, {-0.5, 0.0}),
                                scan_of(kRoom, {0.5, 0.2}),
                                scan_of(kRoom, {-0.4, 0.3}),
                                scan_of(kRoom, {0.2, -0.2})};
  std::vector<Scan> placed = heard;
  placed[1] = moved(heard[1], {0.1, -0.05, 0.05});
  const auto half = static_cast<std::ptrdiff_t>(heard[2].size() / 2);
  const Scan turned = moved(heard[2], {0.0, 0.0, 0.1});
  std::copy(turned.begin() + half, turned.end(), placed[2].begin() + half);
  SonarMapper fresh;
  fresh.take(placed);
  SonarMapper knowing;
  knowing.take({heard[0], heard[1]});
  knowing.take(heard);
  knowing.take(placed);
  EXPECT_EQ(tests::drawing_of(rasterize(knowing.grid())),
            tests::drawing_of(rasterize(fresh.grid())));
  ASSERT_EQ(knowing.T_map_placed().size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const geometry::Pose2 off = fresh.T_map_placed()[i].inverse() * knowing.T_map_placed()[i];
    EXPECT_LT(off.position_m().norm(), 1e-6) << i;
    EXPECT_NEAR(off.heading_rad(), 0.0, 1e-6) << i;
  }
  SonarMapper unbent;
  unbent.take({heard[0], placed[1], heard[2], heard[3]});
  EXPECT_NE(tests::drawing_of(rasterize(unbent.grid())), tests::drawing_of(rasterize(fresh.grid())))
      << "a bend shows";
}

}  // namespace
}  // namespace echomap::mapping
