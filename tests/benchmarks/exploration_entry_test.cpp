// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_entry.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/strategies/course_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::bench {
namespace {

using testing::HasSubstr;

/// 3 x 1 m, a wall across it at 2 m with a gap of 0.3 m; the robot starts in the larger part.
//
//   +--------------+-------+
//   |              |       |
//   |  >                   |
//   |              |       |
//   +--------------+-------+
world::FloorPlan two_parts() {
  const world::Outline room{{{0.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}}, {}};
  const world::Outline below{{{2.0, 0.0}, {2.1, 0.0}, {2.1, 0.35}, {2.0, 0.35}}, {}};
  const world::Outline above{{{2.0, 0.65}, {2.1, 0.65}, {2.1, 1.0}, {2.0, 1.0}}, {}};
  return {"two parts", room, {below, above}, {0.5, 0.5, 0.0}};
}

TEST(ShareInReach, IsAllOfTheFloorForASmallHull) {
  EXPECT_GT(share_in_reach(two_parts(), 0.05), 0.97);
}

TEST(ShareInReach, LeavesOutWhatLiesBehindAGapThatIsTooNarrow) {
  EXPECT_GT(share_in_reach(two_parts(), 0.13), 0.9);
  EXPECT_NEAR(share_in_reach(two_parts(), 0.17), 2.0 / 2.9, 0.03);
}

TEST(CourseOf, LeavesOutPlacesWhereFurnitureStands) {
  const world::Outline room{{{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, {}};
  const world::Outline box{{{1.5, 1.5}, {1.9, 1.5}, {1.9, 1.9}, {1.5, 1.9}}, {}};
  const auto names = [](const exploration::WaypointCourse& course) {
    std::vector<std::string> found;
    for (const auto& waypoint : course.waypoints) {
      found.push_back(waypoint.name);
    }
    return found;
  };
  const geometry::Pose2 start(0.5, 0.5, 0.0);
  EXPECT_THAT(names(course_of({"bare", room, {}, start}, 0.1)), testing::Contains("corner 3"));
  EXPECT_THAT(names(course_of({"boxed", room, {box}, start}, 0.1)),
              testing::ElementsAre("corner 1", "corner 2", "corner 4", "start"));
}

TEST(Entry, WritesACourseForTangentBug) {
  const tests::ScratchFolder folder;
  const auto entry = entry_of("living_room", "tangent-bug", folder.path());
  EXPECT_EQ(entry.why_not, "");
  EXPECT_EQ(entry.what.robot, "uno_2wd");
  EXPECT_NEAR(entry.room_edge_m, 4.0, 0.05);
  EXPECT_GE(strategies::load_course(entry.what.course.string()).waypoints.size(), 4U);
}

TEST(Entry, SaysWhyAStrategyDoesNotRun) {
  const tests::ScratchFolder folder;
  const auto why_not = [&](const char* room, const char* strategy) {
    return entry_of(room, strategy, folder.path()).why_not;
  };
  EXPECT_THAT(why_not("epuck_field", "coastal"), HasSubstr("create passes over"));
  EXPECT_THAT(why_not("epuck_field", "tangent-bug"), HasSubstr("reached from the start"));
  EXPECT_THAT(why_not("living_room", "epuck"), HasSubstr("6 cm"));
  EXPECT_EQ(why_not("epuck_field", "epuck"), "");
  EXPECT_EQ(why_not("create_l", "coastal"), "");
}

}  // namespace
}  // namespace echomap::bench
