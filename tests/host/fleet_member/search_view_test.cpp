// SPDX-License-Identifier: MIT
#include "host/fleet_member/search_view.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::fleet_member {
namespace {

using geometry::Pose2;
using source_search::SourceVerdict;

constexpr double kPlaceStddevM = 0.03;

fleet::FleetRobot reader(const std::string& name,
                         team_map::RobotRecord record,
                         const std::vector<fleet_messages::SourceBatch>& batches) {
  fleet::FleetRobot robot;
  robot.has_reported = true;
  robot.name = name;
  fleet::FleetMap map;
  map.record = std::make_shared<const team_map::RobotRecord>(std::move(record));
  map.source_batches = std::make_shared<const std::vector<fleet_messages::SourceBatch>>(batches);
  robot.maps.push_back(std::move(map));
  return robot;
}

/// Robot b has read twice, the later batch first.
class SearchViewTest : public testing::Test {
 protected:
  SearchViewTest() {
    const auto b = tests::ideal_record("b", tests::room_of_posts(), tests::other_round_m(), 1.0);
    state.robots = {
        reader("a",
               tests::ideal_record("a", tests::room_of_posts(), tests::one_round_m(), 0.0),
               {{0, {{1.0, {}, 5.0, 2.0}}}}),
        reader("b",
               b,
               {{1, {{30.0, Pose2(0.4, 0.1, 0.0), 9.0, 2.0}}},
                {1, {{20.0, Pose2(0.3, 0.1, 0.0), 7.0, 1.5}}}})};
    fleet_messages::SearchReport report;
    report.plan = {{{0.5, 0.5}, 3.0}};
    state.robots[1].search = report;
    state.revision = 1;
  }
  void join() { picture.set_known_pose("a.0", "b.0", {T_a_b, 0.04, 0.02}); }
  SearchView view() {
    picture.take(state);
    return search_view(state, picture, map_name("a", 0), "a", kPlaceStddevM);
  }

  const Pose2 T_a_b = Pose2(2.0, 1.0, 1.0);
  fleet::FleetState state;
  TeamPicture picture;
};

TEST_F(SearchViewTest, IsEmptyOfRobotsWhoseMapsAreNotJoined) {
  EXPECT_TRUE(view().readings.empty());
  EXPECT_TRUE(view().plans.empty());
  EXPECT_FALSE(view().finding);
}

TEST_F(SearchViewTest, HasReadingsAndPlansWhereTheyAreInOnesOwnMap) {
  join();
  const SearchView seen = view();
  ASSERT_EQ(seen.readings.size(), 2U) << "not its own";
  EXPECT_EQ(seen.readings[0].map, "b.0");
  EXPECT_EQ(seen.readings[0].stamp_s, 20.0) << "in the order of time";
  EXPECT_EQ(seen.readings[0].reading.value, 7.0);
  EXPECT_EQ(seen.readings[0].reading.dwell_s, 1.5);
  const auto relative = picture.team().relative_pose("a.0", "b.0");
  ASSERT_TRUE(relative);
  // The robot's odometry is its map: its record has no error.
  const Eigen::Vector2d at_m = relative->T_own_peer * Eigen::Vector2d(0.3, 0.1);
  EXPECT_NEAR((seen.readings[0].reading.at_m - at_m).norm(), 0.0, 0.02);
  EXPECT_NEAR(seen.readings[0].reading.position_stddev_m,
              std::hypot(kPlaceStddevM, relative->position_stddev_m),
              1e-12);
  EXPECT_GT(relative->position_stddev_m, 0.0);
  ASSERT_EQ(seen.plans.size(), 1U);
  EXPECT_NEAR(
      (seen.plans[0].at_m - relative->T_own_peer * Eigen::Vector2d(0.5, 0.5)).norm(), 0.0, 1e-9);
}

TEST_F(SearchViewTest, HasTheReadingsOfAllForSomebodyWhoLooksOn) {
  join();
  picture.take(state);
  EXPECT_EQ(search_view(state, picture, "a.0", "", kPlaceStddevM).readings.size(), 3U);
}

TEST_F(SearchViewTest, LeavesOutWhatWasReadBehindTheLastSubmapThatIsKnown) {
  join();
  state.robots[1].maps[0].source_batches =
      std::make_shared<const std::vector<fleet_messages::SourceBatch>>(
          1, fleet_messages::SourceBatch{99, {{1.0, {}, 1.0, 1.0}}});
  EXPECT_TRUE(view().readings.empty());
}

TEST_F(SearchViewTest, HasAFindingOfAnybody) {
  state.robots[1].search->verdict = SourceVerdict::kFound;
  state.robots[1].search->at_m = {0.5, 0.25};
  ASSERT_TRUE(view().finding);
  EXPECT_EQ(view().finding->robot, "b");
  EXPECT_FALSE(view().finding->at_m) << "who knows where its map lies";
  state.robots[1].has_reported = false;
  EXPECT_FALSE(view().finding) << "kept by the broker: of an earlier search";
  state.robots[1].has_reported = true;
  join();
  state.revision = 2;
  const auto finding = view().finding;
  ASSERT_TRUE(finding && finding->at_m);
  const auto relative = picture.team().relative_pose("a.0", "b.0");
  EXPECT_NEAR(
      (*finding->at_m - relative->T_own_peer * Eigen::Vector2d(0.5, 0.25)).norm(), 0.0, 1e-9);
}

}  // namespace
}  // namespace echomap::fleet_member
