// SPDX-License-Identifier: MIT
#include "host/pipeline/robot_atlas.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/host/pipeline/plain_robot.hpp"

namespace echomap::pipeline {
namespace {

class RobotAtlasTest : public ::testing::Test {
 protected:
  void drive_to(double travel_m) {
    stamp += std::chrono::milliseconds(20);
    atlas.on_odometry({stamp, {travel_m, travel_m}});
  }
  void stop() {
    atlas.begin_scan();
    stamp += std::chrono::milliseconds(20);
    atlas.end_scan();
  }
  void lift(bool lifted) { atlas.on_hazards({.stamp = stamp, .lifted = lifted}); }
  double x_m() const { return atlas.pipeline().snapshot().latest.T_map_robot.x_m(); }

  RobotAtlas atlas{[] { return RobotPipeline(wide_robot()); }};
  time::RobotTime stamp;
};

TEST_F(RobotAtlasTest, HasOneMapUntilAnotherOneBegins) {
  drive_to(1.0);
  stop();
  EXPECT_EQ(x_m(), 1.0);
  EXPECT_EQ(atlas.record().scans(), 1U);
  EXPECT_TRUE(atlas.previous_maps().empty());
  EXPECT_FALSE(atlas.join()) << "with what?";
  EXPECT_EQ(atlas.changes(), 0U);
}

TEST_F(RobotAtlasTest, ALostRobotsLastStopsBeginAnotherMapButForTheFirstOfThem) {
  for (const double at_m : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    drive_to(at_m);
    stop();
  }
  const RobotPipeline* const pipeline = &atlas.pipeline();
  atlas.begin_new_map(3);
  ASSERT_EQ(atlas.previous_maps().size(), 1U);
  EXPECT_EQ(atlas.previous_maps().front().record.scans(), 2U);
  EXPECT_EQ(atlas.previous_maps().front().pipeline.snapshot().stops, 2U);
  EXPECT_EQ(atlas.record().scans(), 2U) << "the first may be of both places";
  EXPECT_EQ(atlas.pipeline().snapshot().stops, 2U);
  EXPECT_EQ(x_m(), 1.0) << "from the fourth stop";
  drive_to(5.5);
  EXPECT_EQ(x_m(), 1.5);
  EXPECT_EQ(&atlas.pipeline(), pipeline);
}

TEST_F(RobotAtlasTest, ALiftedRobotBeginsAnotherMapWhereItIs) {
  drive_to(1.0);
  stop();
  drive_to(2.0);
  lift(true);
  drive_to(7.0);
  lift(false);
  atlas.begin_new_map(0);
  EXPECT_EQ(atlas.previous_maps().front().pipeline.snapshot().latest.T_map_robot.x_m(), 2.0);
  EXPECT_EQ(atlas.pipeline().snapshot().times_lifted, 0U);
  EXPECT_EQ(atlas.pipeline().snapshot().stops, 0U);
  EXPECT_EQ(x_m(), 0.0);
}

TEST_F(RobotAtlasTest, AMapWithoutAnyStopIsLetGo) {
  drive_to(1.0);
  lift(true);
  atlas.begin_new_map(0);
  EXPECT_TRUE(atlas.previous_maps().empty());
  EXPECT_EQ(x_m(), 0.0);
}

TEST_F(RobotAtlasTest, ARecordOfEarlierIsAFormerMap) {
  ObservationLog earlier;
  earlier.on_odometry({time::RobotTime{}, {0.5, 0.5}});
  atlas.set_aside(earlier);
  ASSERT_EQ(atlas.previous_maps().size(), 1U);
  EXPECT_EQ(atlas.previous_maps().front().pipeline.snapshot().latest.T_map_robot.x_m(), 0.5);
}

TEST(RobotAtlas, LetsMapsGoThatNobodyWillJoin) {
  RobotAtlasParams params;
  params.keeps_previous_maps = false;
  RobotAtlas atlas([] { return RobotPipeline(wide_robot()); }, params);
  for (int stop = 0; stop < 2; ++stop) {
    atlas.begin_scan();
    atlas.on_sonar({{}, {}, 0.0, 1.0});
    atlas.end_scan();
  }
  atlas.begin_new_map(1);
  EXPECT_TRUE(atlas.previous_maps().empty());
  EXPECT_EQ(atlas.pipeline().snapshot().stops, 1U);
}

TEST(RobotAtlas, RefusesWhatHasNoSense) {
  RobotAtlasParams params;
  params.agreeing_stops = 0;
  EXPECT_THROW(RobotAtlas([] { return RobotPipeline(wide_robot()); }, params),
               std::invalid_argument);
}

}  // namespace
}  // namespace echomap::pipeline
