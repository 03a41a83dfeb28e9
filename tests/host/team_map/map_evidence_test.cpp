// SPDX-License-Identifier: MIT
#include "host/team_map/map_evidence.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;

class MapEvidenceTest : public ::testing::Test {
 protected:
  static RobotMap map_of(const tests::SmoothRoom& room,
                         const std::vector<Eigen::Vector2d>& places_m,
                         double heading_rad) {
    RobotMap map{mapping::SonarMapperParams{}};
    map.take(tests::ideal_record("one", room, places_m, heading_rad));
    return map;
  }

  const RobotMap first = map_of(tests::room_of_posts(), tests::one_round_m(), 0.0);
  const RobotMap second = map_of(tests::room_of_posts(), tests::other_round_m(), 1.0);
  const RobotMap elsewhere = map_of(tests::look_alike_room(), tests::other_round_m(), 1.0);
  const Pose2 T_true = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
};

TEST_F(MapEvidenceTest, RefinesAPlacementByTheRanges) {
  const Pose2 T_off = Pose2(0.06, -0.05, 0.0) * T_true * Pose2(0.0, 0.0, 0.06);
  const Pose2 refined = refined_placement(first, second, T_off);
  EXPECT_NEAR(refined.x_m(), T_true.x_m(), 0.015);
  EXPECT_NEAR(refined.y_m(), T_true.y_m(), 0.015);
  EXPECT_NEAR(refined.heading_rad(), T_true.heading_rad(), 0.02);
}

TEST_F(MapEvidenceTest, LosesLittleWhereTheMapsAreOfOnePlace) {
  const MapEvidence evidence = evidence_for(first, second, T_true);
  EXPECT_GT(evidence.readings, 500.0);
  EXPECT_GT(evidence.gain, 500.0);
  EXPECT_LT(evidence.loss_per_reading(), 0.2);
  EXPECT_GT(evidence.matched_share(), 0.8);
}

TEST_F(MapEvidenceTest, LosesMoreInARoomThatLooksAlike) {
  const MapEvidence same = evidence_for(first, second, T_true);
  const MapEvidence other = evidence_for(first, elsewhere, T_true);
  EXPECT_GT(other.loss_per_reading(), same.loss_per_reading() + 0.1);
  EXPECT_LT(other.matched_share(), same.matched_share());
  EXPECT_LT(other.weight(), same.weight());
}

/// A robot that has stood in one half of the room only has no features of what the other half hides
/// from it: that is no reason to doubt.
TEST_F(MapEvidenceTest, LosesNothingWhereOneRobotHasSeenLess) {
  const std::vector<Eigen::Vector2d> beginning_m{{-0.7, -0.4}, {-0.2, -0.1}, {-0.3, 0.6}};
  const RobotMap begun = map_of(tests::room_of_posts(), beginning_m, 1.0);
  const MapEvidence evidence = evidence_for(first, begun, T_true);
  EXPECT_GT(evidence.readings, 100.0);
  EXPECT_LT(evidence.loss_per_reading(), 0.2);
  EXPECT_GT(evidence.matched_share(), 0.7);
}

/// The first stop looks around several times; what it knows of the walls is known by its pose.
TEST_F(MapEvidenceTest, CountsAStopAsOneSweepHoweverManyReadingsItHas) {
  RobotRecord reported =
      tests::ideal_record("one", tests::room_of_posts(), tests::other_round_m(), 1.0);
  std::vector<slam::StopReading>& readings = reported.submaps.front().readings;
  const std::vector<slam::StopReading> sweep = readings;
  readings.insert(readings.end(), sweep.begin(), sweep.end());
  RobotMap twice{mapping::SonarMapperParams{}};
  twice.take(reported);
  EXPECT_NEAR(evidence_for(first, twice, T_true).readings,
              evidence_for(first, second, T_true).readings,
              2.0);
}

TEST_F(MapEvidenceTest, HasNoReadingsWhereNothingIsKnownByBoth) {
  const MapEvidence evidence = evidence_for(first, second, Pose2(50.0, 0.0, 0.0));
  EXPECT_EQ(evidence.readings, 0.0);
  EXPECT_EQ(evidence.loss_per_reading(), 0.0);
  EXPECT_EQ(evidence.surfaces, 0U);
  EXPECT_EQ(evidence.matched_share(), 0.0);
}

}  // namespace
}  // namespace echomap::team_map
