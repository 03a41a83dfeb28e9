// SPDX-License-Identifier: MIT
#include "host/pipeline/scan_map.hpp"

#include <numbers>

#include <gmock/gmock.h>

#include "host/pipeline/log_player.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "tests/support/drawn_map.hpp"

namespace echomap::pipeline {
namespace {

using datasets::GivenPose;
using datasets::OdometryPose;
using ::testing::ElementsAre;

sensors::RangeScan laser(std::vector<sensors::Beam> beams) {
  sensors::RangeScan scan;
  scan.beams = std::move(beams);
  scan.max_range_m = 10.0;
  return scan;
}

/// A log, and the pipeline that it is played into.
class Mapper {
 public:
  explicit Mapper(const ScanMapParams& params = {}, PoseSource source = PoseSource::kOdometry)
      : pipeline_({}, with_grid(params.grid), {}, nullptr, params), player_(pipeline_, source) {}

  void add(const datasets::LogRecord& record) { player_.play(record); }
  Snapshot snapshot() const { return pipeline_.snapshot(); }
  const LogCounts& counts() const { return player_.counts(); }

 private:
  static mapping::SonarMapperParams with_grid(const mapping::OccupancyGridParams& grid) {
    mapping::SonarMapperParams params;
    params.grid = grid;
    return params;
  }

  RobotPipeline pipeline_;
  LogPlayer player_;
};

ScanMapParams coarse() {
  ScanMapParams params;
  params.grid.resolution_m = 0.5;
  // One sighting decides, so that the map can be drawn.
  params.rays.hit_centilogits = 300;
  params.rays.free_centilogits = -300;
  return params;
}

TEST(ScanMap, RaysOfALaserGoIntoTheGridFromWhereTheRobotWas) {
  Mapper mapper(coarse());
  mapper.add(OdometryPose{1.0, {0.25, 0.25, 0.0}});
  mapper.add(laser({{0.0, 1.5}, {std::numbers::pi / 2.0, std::nullopt}}));
  mapper.add(OdometryPose{2.0, {0.25, 0.25, std::numbers::pi / 2.0}});
  mapper.add(laser({{0.0, 1.0}}));
  EXPECT_THAT(tests::drawing_of(mapping::rasterize(*mapper.snapshot().grid)),
              ElementsAre("      ",  //
                          " #    ",  //
                          " .    ",  //
                          " ...# ",  //
                          "      "));
}

TEST(ScanMap, AMapOfPointsHasNoGridWhateverWasTouched) {
  ScanMapParams params = coarse();
  params.map = MapKind::kPoints;
  Mapper mapper(params);
  mapper.add(OdometryPose{1.0, {0.25, 0.25, 0.0}});
  mapper.add(datasets::Contact{1.0, true, true, 0.17});
  EXPECT_TRUE(mapper.snapshot().grid->bounds().empty()) << "before a scan, too";
  mapper.add(laser({{0.0, 1.5}}));
  EXPECT_TRUE(mapper.snapshot().grid->bounds().empty());
  EXPECT_EQ(mapper.snapshot().points->points().size(), 1U);
}

TEST(ScanMap, ASensorOffTheMiddleSeesFromThere) {
  ScanMapParams params = coarse();
  params.map = MapKind::kPoints;
  Mapper mapper(params);
  mapper.add(OdometryPose{1.0, {1.0, 0.0, std::numbers::pi / 2.0}});
  sensors::RangeScan scan = laser({{0.0, 2.0}, {0.0, std::nullopt}});
  scan.T_robot_sensor = {0.25, 0.0, 0.0};
  mapper.add(scan);
  const auto snapshot = mapper.snapshot();
  ASSERT_EQ(snapshot.points->points().size(), 1U);
  EXPECT_NEAR(snapshot.points->points()[0].position_m.y(), 2.25, 1e-12);
  EXPECT_EQ(snapshot.points->points()[0].pose_index, 0U);
  EXPECT_TRUE(snapshot.grid->bounds().empty());
}

TEST(ScanMap, TheEchoesOfASonarThatPassesAWallBecomeThatWall) {
  Mapper mapper;
  sensors::RangeScan scan = laser({{std::numbers::pi / 2.0, 1.0}});
  scan.beam_width_rad = 0.5;
  scan.max_range_m = 3.0;
  for (int i = 0; i < 20; ++i) {
    mapper.add(OdometryPose{0.1 * i, {0.1 * i, 0.0, 0.0}});
    mapper.add(scan);
  }
  const auto grid = mapper.snapshot().grid;
  EXPECT_EQ(grid->state(grid->cell_at({1.0, 0.5})), mapping::CellState::kFree);
  EXPECT_EQ(grid->state(grid->cell_at({1.0, -0.5})), mapping::CellState::kUnknown);
  const bool is_found = grid->state(grid->cell_at({1.0, 0.98})) == mapping::CellState::kOccupied ||
                        grid->state(grid->cell_at({1.0, 1.02})) == mapping::CellState::kOccupied;
  EXPECT_TRUE(is_found);
}

TEST(ScanMap, TheSilenceOfSoundSpeaksForFreeFloorAndThatOfLightDoesNot) {
  for (const bool is_light : {false, true}) {
    Mapper mapper;
    sensors::RangeScan scan = laser({{0.0, std::nullopt}});
    scan.beam_width_rad = 0.5;
    scan.max_range_m = 3.0;
    scan.is_light = is_light;
    mapper.add(scan);
    EXPECT_EQ(mapper.snapshot().grid->bounds().empty(), is_light);
  }
}

TEST(ScanMap, ScansBeforeTheFirstGivenPoseAreCountedAndLeftOut) {
  Mapper mapper({}, PoseSource::kGiven);
  mapper.add(laser({{0.0, 1.0}}));
  mapper.add(GivenPose{5.0, {0.0, 0.0, 0.0}});
  mapper.add(laser({{0.0, 1.0}, {1.0, 1.0}}));
  EXPECT_EQ(mapper.counts().scans, 2U);
  EXPECT_EQ(mapper.counts().beams, 3U);
  EXPECT_EQ(mapper.counts().scans_without_pose, 1U);
  EXPECT_EQ(mapper.snapshot().stops, 1U);
}

datasets::Contact contact(bool left, bool right) { return {std::nullopt, left, right, 0.9}; }

TEST(ScanMap, ABumpIsAWallBeforeTheRobotOnTheSideThatWasHit) {
  const auto drawing_after = [](bool left, bool right) {
    Mapper mapper(coarse());
    mapper.add(OdometryPose{1.0, {0.25, 0.0, 0.0}});
    mapper.add(contact(left, right));
    return tests::drawing_of(mapping::rasterize(*mapper.snapshot().grid));
  };
  // Cells of half a metre; the end of a bumper looks to its side.
  EXPECT_THAT(drawing_after(true, true), ElementsAre("   ", " # ", " # ", "   "));
  EXPECT_THAT(drawing_after(true, false), ElementsAre("    ", " #  ", "  # ", "    "));
  EXPECT_EQ(drawing_after(false, false), tests::DrawnMap{" "});
}

TEST(ScanMap, TheSidesOfABumpAreLeftAndRight) {
  for (const bool left : {true, false}) {
    Mapper mapper;
    mapper.add(contact(left, !left));
    const auto grid = mapper.snapshot().grid;
    EXPECT_EQ(grid->state(grid->cell_at({0.69, 0.58})) == mapping::CellState::kOccupied, left);
    EXPECT_EQ(grid->state(grid->cell_at({0.69, -0.58})) == mapping::CellState::kOccupied, !left);
  }
}

TEST(ScanMap, ABumperThatStaysPressedIsOneBump) {
  Mapper mapper;
  mapper.add(contact(true, true));
  const auto cell = mapper.snapshot().grid->cell_at({0.91, 0.1});
  const auto once = mapper.snapshot().grid->centilogits(cell);
  mapper.add(OdometryPose{1.0, {-1.0, 0.0, 0.0}});
  mapper.add(contact(true, true));
  EXPECT_EQ(mapper.counts().bumps, 1U);
  EXPECT_EQ(mapper.snapshot().grid->bounds().columns(), 1);
  mapper.add(contact(false, false));
  mapper.add(OdometryPose{2.0, {0.0, 0.0, 0.0}});
  mapper.add(contact(true, true));
  EXPECT_EQ(mapper.counts().bumps, 2U);
  EXPECT_GT(mapper.snapshot().grid->centilogits(cell), once);
}

TEST(ScanMap, PlacesLandmarksByThePosesThatCount) {
  Mapper mapper({}, PoseSource::kGiven);
  mapper.add(datasets::LandmarkSighting{1.0, 7, 2.0, 0.0});
  mapper.add(GivenPose{2.0, {1.0, 2.0, std::numbers::pi / 2.0}});
  mapper.add(datasets::LandmarkSighting{2.5, 7, 2.0, -std::numbers::pi / 2.0});
  EXPECT_EQ(mapper.counts().sightings, 2U);
  EXPECT_EQ(mapper.counts().sightings_without_pose, 1U);
  ASSERT_EQ(mapper.snapshot().landmarks->size(), 1U);
  const SeenLandmark seen = mapper.snapshot().landmarks->front();
  EXPECT_EQ(seen.id, 7);
  EXPECT_EQ(seen.range_m, 2.0);
  EXPECT_EQ(seen.stamp, mapper.snapshot().trajectory->front().stamp);
  EXPECT_NEAR((seen.position_m - Eigen::Vector2d(3.0, 2.0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace echomap::pipeline
