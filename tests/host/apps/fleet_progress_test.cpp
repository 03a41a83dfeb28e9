// SPDX-License-Identifier: MIT
#include "host/apps/fleet_progress.hpp"

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::apps {
namespace {

fleet::FleetRobot robot_with(const std::string& name, team_map::RobotRecord record) {
  fleet::FleetRobot robot;
  robot.name = name;
  fleet::FleetMap map;
  map.record = std::make_shared<const team_map::RobotRecord>(std::move(record));
  robot.maps.push_back(std::move(map));
  return robot;
}

class FleetProgressTest : public testing::Test {
 protected:
  FleetProgressTest() {
    state.robots = {
        robot_with(
            "a",
            tests::first_stops(
                tests::ideal_record("a", tests::room_of_posts(), tests::one_round_m(), 0.0), 1)),
        robot_with(
            "b",
            tests::first_stops(
                tests::ideal_record("b", tests::room_of_posts(), tests::other_round_m(), 1.0), 3))};
    state.revision = 1;
  }

  fleet::FleetState state;
  fleet_member::TeamPicture picture;
};

TEST_F(FleetProgressTest, CountsStopsAndWhoIsOnTheMap) {
  picture.take(state);
  const FleetProgress apart = progress_of(state, picture, "a.0");
  EXPECT_EQ(apart.line, "a 1 stop, b 3, 1 of 2 on one map, in 1:00");
  EXPECT_EQ(apart.elapsed_s, 60.0);
  picture.set_known_pose("a.0", "b.0", {geometry::Pose2(2.0, 1.0, 1.0), 0.1, 0.02});
  state.revision = 2;
  picture.take(state);
  EXPECT_EQ(progress_of(state, picture, "a.0").line, "a 1 stop, b 3, 2 of 2 on one map, in 1:00");
}

TEST_F(FleetProgressTest, BeforeTheFirstStopThereIsNothingToSay) {
  const FleetProgress progress = progress_of({}, picture, "a.0");
  EXPECT_EQ(progress.elapsed_s, 0.0);
  testing::internal::CaptureStderr();
  FleetProgressPrinter().print(progress);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(FleetProgressTest, IsPrintedForEveryHalfMinute) {
  FleetProgressPrinter printer;
  testing::internal::CaptureStderr();
  printer.print({"early", 29.0});
  printer.print({"first", 31.0});
  printer.print({"soon", 60.0});
  printer.print({"second", 61.0});
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "first\nsecond\n");
}

}  // namespace
}  // namespace echomap::apps
