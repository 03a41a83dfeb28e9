// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_mapper.hpp"

#include <algorithm>
#include <cmath>
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
  mapper.take({scan_of(kRoom, {0.0, 0.0}),
               scan_of(kRoom, {0.5, 0.2}),
               scan_of(kRoom, {-0.4, 0.3}),
               scan_of(kRoom, {0.2, -0.2})},
              {});
  EXPECT_EQ(tests::drawing_of(rasterize(mapper.grid())),
            (tests::DrawnMap{"               ",
                             " ############# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " #...........# ",
                             " ############# ",
                             "               "}));
}

TEST(SonarMapper, NeverCallsFloorWhatLiesBehindAWall) {
  std::vector<Scan> scans;
  for (const double x_m : {-0.5, 0.0, 0.4, 0.8}) {
    scans.push_back(scan_of(kRoom, {x_m, 0.2 * x_m}));
  }
  SonarMapper mapper;
  mapper.take(scans, {});
  const OccupancyGrid grid = mapper.grid();
  EXPECT_EQ(grid.state(grid.cell_at({0.0, 0.0})), CellState::kFree);
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

TEST(SonarMapper, LearnsFromSilenceOnlyWhereItIsAllRound) {
  SonarMapper mapper;
  const Scan silence = scan_of({});
  constexpr int kTwoThirdsOfARightAngleEachWay = 20;
  mapper.take({{silence.begin(), silence.begin() + kTwoThirdsOfARightAngleEachWay}, {}}, {});
  EXPECT_TRUE(mapper.grid().bounds().empty());
  mapper.take({silence}, {});
  const OccupancyGrid grid = mapper.grid();
  EXPECT_EQ(grid.state(grid.cell_at({-1.0, 1.0})), CellState::kFree);
  EXPECT_EQ(grid.state(grid.cell_at({-3.0, 1.0})), CellState::kUnknown);
}

TEST(SonarMapper, LearnsLittleFromOneReading) {
  SonarMapper mapper;
  mapper.take({{scan_of(kRoom).front()}}, {});
  EXPECT_TRUE(mapper.grid().bounds().empty());
}

TEST(SonarMapper, TakesARangeThatIsTheSameAllAroundForARound) {
  Scan scan = scan_of({});
  for (auto& reading : scan) {
    reading.range_m = 4.0;
  }
  SonarMapper mapper;
  mapper.take({scan}, {});
  const OccupancyGrid grid = mapper.grid();
  EXPECT_NE(grid.state(grid.cell_at({0.0, 0.0})), CellState::kOccupied);
  EXPECT_FALSE(grid.centilogits(grid.cell_at({4.3, 0.0})).has_value());
}

/// A room with a round table of 0.3 m, and stops all around it.
const Eigen::Vector2d kTableM(0.2, 0.1);

std::vector<Scan> scans_around_table() {
  SmoothRoom room = tests::smooth_rectangle();
  std::vector<Scan> scans;
  for (const Eigen::Vector2d& place_m : {Eigen::Vector2d(-0.6, 0.0),
                                         Eigen::Vector2d(-0.4, -0.4),
                                         Eigen::Vector2d(0.9, 0.0),
                                         Eigen::Vector2d(0.9, 0.5),
                                         Eigen::Vector2d(-0.5, 0.6),
                                         Eigen::Vector2d(0.8, -0.4)}) {
    // Its nearest point answers as a post there would.
    room.corners_m = tests::smooth_rectangle().corners_m;
    room.corners_m.push_back(kTableM + 0.15 * (place_m - kTableM).normalized());
    scans.push_back(scan_of(room, place_m));
  }
  return scans;
}

TEST(SonarMapper, KeepsARoundTableThatEachStopHearsAtAnotherPoint) {
  SonarMapper mapper;
  mapper.take(scans_around_table(), {});
  const RasterMap map = rasterize(mapper.grid());
  EXPECT_NE(map.state(map.cell_at(kTableM)), CellState::kFree);
  for (const double bearing_deg : {0.0, 90.0, 180.0, 270.0}) {
    const Eigen::Vector2d inside_m =
        kTableM + 0.1 * Eigen::Vector2d(std::cos(geometry::radians(bearing_deg)),
                                        std::sin(geometry::radians(bearing_deg)));
    EXPECT_NE(map.state(map.cell_at(inside_m)), CellState::kFree) << bearing_deg;
  }
  EXPECT_TRUE(std::any_of(mapper.features().circles.begin(),
                          mapper.features().circles.end(),
                          [](const FittedCircle& circle) {
                            return (circle.center_m - kTableM).norm() < 0.03 &&
                                   std::abs(circle.radius_m - 0.15) < 0.03;
                          }));
}

TEST(SonarMapper, DrawsTheSameStopByStopAsAtOnce) {
  const std::vector<Scan> scans = scans_around_table();
  SonarMapper growing;
  for (std::size_t stops = 1; stops <= scans.size(); ++stops) {
    growing.take({scans.begin(), scans.begin() + static_cast<std::ptrdiff_t>(stops)}, {});
  }
  SonarMapper at_once;
  at_once.take(scans, {});
  EXPECT_EQ(tests::drawing_of(rasterize(growing.grid())),
            tests::drawing_of(rasterize(at_once.grid())));
}

TEST(SonarMapper, RefusesParametersWithoutSense) {
  SonarMapperParams no_beam;
  no_beam.surfaces.beam_half_angle_rad = 0.0;
  EXPECT_THROW(SonarMapper{no_beam}, std::invalid_argument);
  SonarMapperParams no_step;
  no_step.features.completion.doors.step_m = 0.0;
  EXPECT_THROW(SonarMapper{no_step}, std::invalid_argument);
  SonarMapperParams no_fade;
  no_fade.evidence.fade_m = 0.0;
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
  fresh.take(placed, {});
  SonarMapper knowing;
  knowing.take({heard[0], heard[1]}, {});
  knowing.take(heard, {});
  knowing.take(placed, {});
  EXPECT_EQ(tests::drawing_of(rasterize(knowing.grid())),
            tests::drawing_of(rasterize(fresh.grid())));
  SonarMapper unbent;
  unbent.take({heard[0], placed[1], heard[2], heard[3]}, {});
  EXPECT_NE(tests::drawing_of(rasterize(unbent.grid())), tests::drawing_of(rasterize(fresh.grid())))
      << "a bend shows";
}

}  // namespace
}  // namespace echomap::mapping
