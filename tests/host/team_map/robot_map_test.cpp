// SPDX-License-Identifier: MIT
#include "host/team_map/robot_map.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

RobotRecord reported() {
  return tests::ideal_record("a", tests::room_of_posts(), tests::one_round_m(), 0.4);
}

TEST(RobotMap, IsMadeOfWhatARobotPublishes) {
  RobotMap map{mapping::SonarMapperParams{}};
  EXPECT_TRUE(map.take(reported()));
  EXPECT_EQ(map.robot(), "a");
  EXPECT_EQ(map.submaps().size(), 8U);
  EXPECT_EQ(map.map().map().state(map.map().map().cell_at({0.1, 0.1})), mapping::CellState::kFree);
  EXPECT_GE(map.features().walls.size(), 4U);
  EXPECT_EQ(map.surfaces().size(), 8U);
}

TEST(RobotMap, SaysWhetherAnythingIsNew) {
  RobotMap map{mapping::SonarMapperParams{}};
  EXPECT_FALSE(map.take(tests::first_stops(reported(), 0)));
  EXPECT_TRUE(map.take(tests::first_stops(reported(), 4)));
  EXPECT_FALSE(map.take(tests::first_stops(reported(), 4)));
  EXPECT_TRUE(map.take(reported()));
  RobotRecord moved = reported();
  moved.T_map_submaps[3] = geometry::Pose2(0.5, 0.0, 0.0) * moved.T_map_submaps[3];
  EXPECT_TRUE(map.take(moved));
}

/// Presence may come after the first submaps.
TEST(RobotMap, IsMadeAnewOnceTheBeamIsKnown) {
  RobotRecord narrow = reported();
  narrow.beam_half_angle_rad = 0.1;
  RobotMap map{mapping::SonarMapperParams{}};
  map.take(reported());
  EXPECT_TRUE(map.take(narrow));
  RobotMap at_once{mapping::SonarMapperParams{}};
  at_once.take(narrow);
  ASSERT_EQ(map.surfaces().size(), at_once.surfaces().size());
  for (std::size_t i = 0; i < map.surfaces().size(); ++i) {
    EXPECT_EQ(map.surfaces()[i].surfaces.size(), at_once.surfaces()[i].surfaces.size()) << i;
  }
  RobotRecord wide = narrow;
  wide.body_radius_m += 0.05;
  EXPECT_TRUE(map.take(wide));
}

/// A submap whose pose has not come yet waits for it.
TEST(RobotMap, TakesOnlySubmapsThatHaveAPose) {
  RobotMap map{mapping::SonarMapperParams{}};
  RobotRecord record = reported();
  record.T_map_submaps.resize(3);
  map.take(record);
  EXPECT_EQ(map.submaps().size(), 3U);
}

TEST(RobotMap, ExplainsItsOwnReadingsByItsOtherStops) {
  RobotMap map{mapping::SonarMapperParams{}};
  map.take(reported());
  ASSERT_EQ(map.own_log_likelihoods().size(), 8U);
  const auto& of_one = map.own_log_likelihoods()[2];
  ASSERT_EQ(of_one.size(), 90U);
  EXPECT_GT(std::accumulate(of_one.begin(), of_one.end(), 0.0) / 90.0, -0.5);
}

}  // namespace
}  // namespace echomap::team_map
