// SPDX-License-Identifier: MIT
#include "host/team_map/map_proposals.hpp"

#include <gtest/gtest.h>

#include "host/slam/stop_stand.hpp"
#include "tests/support/told_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;

class MapProposalsTest : public ::testing::Test {
 protected:
  static RobotMap map_of(const std::vector<Eigen::Vector2d>& places_m,
                         double heading_rad,
                         std::size_t stops) {
    RobotMap map{mapping::SonarMapperParams{}};
    map.take(tests::first_stops(
        tests::told_record("one", tests::room_of_posts(), places_m, heading_rad), stops));
    return map;
  }

  const Pose2 T_true = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
};

TEST_F(MapProposalsTest, OfYoungMapsAreThoseOfTheWholeMaps) {
  const RobotMap first = map_of(tests::one_round_m(), 0.0, 4);
  const RobotMap second = map_of(tests::other_round_m(), 1.0, 4);
  EXPECT_FALSE(first.has_window());
  EXPECT_LE(propose_placements(first, second, {}, 3).size(), 3U);
}

TEST_F(MapProposalsTest, OfLaterMapsAreThoseOfTheLastStopsToo) {
  const RobotMap first = map_of(tests::one_round_m(), 0.0, 8);
  const RobotMap second = map_of(tests::other_round_m(), 1.0, 8);
  ASSERT_TRUE(second.has_window());
  EXPECT_LE(second.window().walls_m().size(), second.map().walls_m().size());
  const auto proposed = propose_placements(first, second, {}, 3);
  EXPECT_GT(proposed.size(), 3U);
  std::size_t right = 0;
  for (const mapping::MapPlacement& one : proposed) {
    right += slam::is_near(one.T_previous_later, T_true, 0.15, 0.15) ? 1 : 0;
  }
  EXPECT_GE(right, 2U) << "by the whole maps, and by a window";
}

/// The weight is that of the whole maps, whatever proposed the place.
TEST_F(MapProposalsTest, AreWeighedByTheWholeMaps) {
  const RobotMap first = map_of(tests::one_round_m(), 0.0, 8);
  const RobotMap second = map_of(tests::other_round_m(), 1.0, 8);
  const auto whole = mapping::find_placements(first.map(), second.map()).front();
  for (const mapping::MapPlacement& one : propose_placements(first, second, {}, 3)) {
    if (slam::is_near(one.T_previous_later, whole.T_previous_later, 0.03, 0.03)) {
      EXPECT_NEAR(one.weight_m(), whole.weight_m(), 0.3 * whole.weight_m());
    }
  }
}

}  // namespace
}  // namespace echomap::team_map
