// SPDX-License-Identifier: MIT
#include "host/source_search/source_readings.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/told_snapshot.hpp"

namespace echomap::source_search {
namespace {

using geometry::Pose2;

sensors::ScalarObservation pulses(double stamp_s, double count, double dwell_s) {
  return {time::robot_time(stamp_s), {}, count, dwell_s};
}

/// From 0 to 10 s along x, with 1 m/s.
pipeline::Snapshot drive_along_x() {
  return tests::snapshot_of(mapping::OccupancyGrid(),
                            {tests::pose_at(0.0, {}), tests::pose_at(10.0, Pose2(10.0, 0.0, 0.0))});
}

TEST(SourceReadings, ArePlacedWhereTheMiddleOfTheirDwellWas) {
  SourceReadings readings({});
  readings.on_scalar(pulses(2.0, 3.0, 1.0));
  readings.on_scalar(pulses(4.0, 5.0, 2.0));
  EXPECT_EQ(readings.placed(drive_along_x()).size(), 1U) << "the last may not be whole";
  readings.on_scalar(pulses(9.0, 1.0, 1.0));
  const auto placed = readings.placed(drive_along_x());
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_NEAR(placed[0].at_m.x(), 1.5, 1e-9);
  EXPECT_NEAR(placed[1].at_m.x(), 3.0, 1e-9);
  EXPECT_EQ(placed[1].value, 5.0);
  EXPECT_EQ(placed[1].dwell_s, 2.0);
  EXPECT_EQ(placed[1].position_stddev_m, SourceReadingsParams().position_stddev_m);
}

TEST(SourceReadings, MoveWithTheTrajectory) {
  SourceReadings readings({});
  readings.on_scalar(pulses(2.0, 3.0, 1.0));
  readings.on_scalar(pulses(9.0, 1.0, 1.0));
  const auto turned =
      tests::snapshot_of(mapping::OccupancyGrid(),
                         {tests::pose_at(0.0, {}), tests::pose_at(10.0, Pose2(0.0, 10.0, 0.0))});
  EXPECT_NEAR(readings.placed(turned).at(0).at_m.y(), 1.5, 1e-9);
}

TEST(SourceReadings, OfBeforeTheTrajectoryHaveNoPlace) {
  SourceReadings readings({});
  readings.on_scalar(pulses(-1.0, 3.0, 1.0));
  readings.on_scalar(pulses(-0.5, 3.0, 0.5));
  EXPECT_TRUE(readings.placed(drive_along_x()).empty());
}

TEST(SourceReadings, OfARobotThatStandsArePlacedThoughItsTrajectoryDoesNotGrow) {
  SourceReadings readings({});
  readings.on_scalar(pulses(12.0, 3.0, 1.0));
  readings.on_scalar(pulses(13.5, 5.0, 1.5));
  readings.on_scalar(pulses(15.0, 2.0, 1.0));
  const auto placed = readings.placed(drive_along_x());
  ASSERT_EQ(placed.size(), 2U);
  EXPECT_NEAR(placed[0].at_m.x(), 10.0, 1e-9);
}

TEST(SourceReadings, OfARobotThatIsCarriedHaveNoPlace) {
  SourceReadings readings({});
  readings.on_scalar(pulses(2.0, 3.0, 1.0));
  auto snapshot = drive_along_x();
  snapshot.carried_to = {1};
  EXPECT_TRUE(readings.placed(snapshot).empty());
}

TEST(SourceReadings, InARowAtOnePlaceAreOne) {
  SourceReadings readings({});
  const auto standing = tests::snapshot_of(mapping::OccupancyGrid(),
                                           {tests::pose_at(0.0, {}), tests::pose_at(10.0, {})});
  for (int i = 1; i <= 50; ++i) {
    readings.on_scalar(pulses(0.1 * i, 1.0, 0.1));
  }
  const auto placed = readings.placed(standing);
  double pulses_in_all = 0.0;
  double dwell_s = 0.0;
  for (const FieldReading& reading : placed) {
    pulses_in_all += reading.value;
    dwell_s += reading.dwell_s;
    EXPECT_LE(reading.dwell_s, 2.0 + 1e-9);
  }
  EXPECT_LE(placed.size(), 3U);
  EXPECT_NEAR(pulses_in_all / dwell_s, 10.0, 1e-9);
}

TEST(SourceReadings, AreTakenForTheTimeInWhichTheSensorWasNotDead) {
  SourceReadings readings({.dead_time_s = 0.001});
  readings.on_scalar(pulses(2.0, 200.0, 1.0));
  readings.on_scalar(pulses(9.0, 1.0, 1.0));
  const auto placed = readings.placed(drive_along_x());
  ASSERT_EQ(placed.size(), 1U);
  EXPECT_EQ(placed[0].value, 200.0);
  EXPECT_NEAR(placed[0].dwell_s, 0.8, 1e-9);
}

TEST(SourceReadings, KnowHowLongTheyHaveBeenTaken) {
  SourceReadings readings({});
  EXPECT_EQ(readings.elapsed_s(), 0.0);
  readings.on_scalar(pulses(2.0, 3.0, 1.0));
  readings.on_scalar(pulses(7.5, 3.0, 1.0));
  EXPECT_NEAR(readings.elapsed_s(), 5.5, 1e-9);
}

TEST(SourceReadings, RefusesWhatIsOutOfRange) {
  EXPECT_THAT([] { SourceReadings({.dead_time_s = -1.0}); },
              testing::Throws<std::invalid_argument>());
  EXPECT_THAT([] { SourceReadings({.together_s = 0.0}); },
              testing::Throws<std::invalid_argument>());
}

}  // namespace
}  // namespace echomap::source_search
