// SPDX-License-Identifier: MIT
#include "host/team_map/map_join.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/ideal_robot.hpp"

namespace echomap::team_map {
namespace {

using geometry::Pose2;
using geometry::radians;

/// Half a metre larger each way.
const tests::SmoothRoom kLargerRoom{
    {{0.0, 1.8}, {radians(90.0), 1.4}, {radians(180.0), 1.6}, {radians(-90.0), 1.2}}, {}};

class MapJoinTest : public ::testing::Test {
 protected:
  MapJoinTest() { first.take(tests::ideal_record("a", room, tests::one_round_m(), 0.0)); }

  void stop(std::size_t stops) { second.take(tests::first_stops(reported, stops)); }

  const tests::SmoothRoom room = tests::room_of_posts();
  RobotRecord reported = tests::ideal_record("b", room, tests::other_round_m(), 1.0);
  RobotMap first{mapping::SonarMapperParams{}};
  RobotMap second{mapping::SonarMapperParams{}};
  MapJoin join{MapJoinParams{}};
};

TEST_F(MapJoinTest, JoinsMapsOfOneRoomWhereTwoLooksAgree) {
  for (std::size_t stops = 1; stops <= 8; ++stops) {
    stop(stops);
    join.update(first, second);
    EXPECT_FALSE(stops <= MapJoinParams{}.min_stops && join.T_first_second())
        << "of so little nobody is sure";
  }
  ASSERT_TRUE(join.T_first_second());
  const Pose2 T_true = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
  EXPECT_NEAR(join.T_first_second()->x_m(), T_true.x_m(), 0.03);
  EXPECT_NEAR(join.T_first_second()->y_m(), T_true.y_m(), 0.03);
  EXPECT_NEAR(join.T_first_second()->heading_rad(), T_true.heading_rad(), 0.03);
  EXPECT_EQ(join.joins(), 1U);
  EXPECT_EQ(join.undone(), 0U);
}

TEST_F(MapJoinTest, DoesNotJoinARoomThatLooksAlike) {
  reported = tests::ideal_record("b", tests::look_alike_room(), tests::other_round_m(), 1.0);
  for (std::size_t stops = 1; stops <= 8; ++stops) {
    stop(stops);
    join.update(first, second);
    EXPECT_FALSE(join.T_first_second()) << stops;
  }
}

/// An empty rectangle is the same when it is turned by half a turn.
TEST_F(MapJoinTest, DoesNotJoinWhatFitsInTwoWays) {
  const tests::SmoothRoom empty = tests::smooth_rectangle();
  first.take(tests::ideal_record("a", empty, tests::one_round_m(), 0.0));
  reported = tests::ideal_record("b", empty, tests::other_round_m(), 1.0);
  for (std::size_t stops = 1; stops <= 8; ++stops) {
    stop(stops);
    join.update(first, second);
    EXPECT_FALSE(join.T_first_second()) << stops;
  }
}

TEST_F(MapJoinTest, UndoesAJoinThatIsContradicted) {
  for (const std::size_t stops : {7, 8}) {
    stop(stops);
    join.update(first, second);
  }
  ASSERT_TRUE(join.T_first_second());
  RobotMap elsewhere{mapping::SonarMapperParams{}};
  elsewhere.take(tests::ideal_record("b", kLargerRoom, tests::other_round_m(), 1.0));
  join.update(first, elsewhere);
  EXPECT_TRUE(join.T_first_second()) << "one look is not enough";
  join.update(first, second);
  join.update(first, elsewhere);
  EXPECT_TRUE(join.T_first_second()) << "nor are two that one for it comes between";
  join.update(first, elsewhere);
  EXPECT_FALSE(join.T_first_second());
  EXPECT_EQ(join.undone(), 1U);
}

/// A room that is turned by half a turn looks much like itself. Here that is enough for a join.
TEST_F(MapJoinTest, UndoesAJoinThatAnotherPlaceOutdoes) {
  const Eigen::Vector2d own_m = tests::one_round_m().front();
  const Eigen::Vector2d peer_m = tests::other_round_m().front();
  const Pose2 T_half_turned = Pose2(own_m.x(), own_m.y(), 0.0).inverse() *
                              Pose2(0.2, 0.2, radians(180.0)) * Pose2(peer_m.x(), peer_m.y(), 1.0);
  MapJoinParams params;
  params.sure.max_loss = 2.0;
  params.sure.refuted_loss = 2.0;
  params.sure.min_matched_share = 0.3;
  params.undone_loss = 100.0;
  MapJoin lenient(params);
  stop(8);
  lenient.try_at(first, second, T_half_turned);
  ASSERT_TRUE(lenient.T_first_second());
  lenient.update(first, second);
  EXPECT_TRUE(lenient.T_first_second()) << "one look is not enough";
  lenient.update(first, second);
  EXPECT_FALSE(lenient.T_first_second());
  EXPECT_EQ(lenient.undone(), 1U);
}

TEST_F(MapJoinTest, JoinsAtOnceWhereOthersKnowItAndReadingsAreSure) {
  const Pose2 T_true = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
  stop(1);
  join.try_at(first, second, T_true);
  EXPECT_FALSE(join.T_first_second()) << "one stop is too little";
  stop(8);
  join.try_at(first, second, T_true * Pose2(0.03, -0.02, 0.02));
  ASSERT_TRUE(join.T_first_second());
  EXPECT_NEAR(join.T_first_second()->x_m(), T_true.x_m(), 0.03);
  EXPECT_GT(join.weight(), 0.0);
}

TEST_F(MapJoinTest, AcceptsAJoinOfOthersUntilItIsContradicted) {
  const Pose2 T_true = tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0);
  stop(8);
  EXPECT_TRUE(join.accept_join(T_true));
  EXPECT_FALSE(join.accept_join(T_true)) << "it has it";
  join.update(first, second);
  join.update(first, second);
  ASSERT_TRUE(join.T_first_second()) << "it holds";
  MapJoin wrong{MapJoinParams{}};
  wrong.accept_join(T_true * Pose2(0.1, 0.1, 0.35));
  wrong.update(first, second);
  EXPECT_TRUE(wrong.T_first_second()) << "one look is not enough";
  wrong.update(first, second);
  EXPECT_FALSE(wrong.T_first_second());
  EXPECT_FALSE(wrong.accept_join(T_true)) << "it knows better";
}

TEST_F(MapJoinTest, KnowsThatReadingsContradictAJoinOfOthers) {
  stop(8);
  const Pose2 T_wrong =
      tests::T_maps(tests::one_round_m(), 0.0, tests::other_round_m(), 1.0) * Pose2(0.1, 0.1, 0.35);
  join.try_at(first, second, T_wrong);
  EXPECT_FALSE(join.is_contradicted()) << "one look is not enough";
  join.try_at(first, second, T_wrong);
  EXPECT_TRUE(join.is_contradicted());
  EXPECT_FALSE(join.T_first_second());
}

TEST_F(MapJoinTest, CanBeTakenBack) {
  for (const std::size_t stops : {7, 8}) {
    stop(stops);
    join.update(first, second);
  }
  ASSERT_TRUE(join.T_first_second());
  join.undo();
  EXPECT_FALSE(join.T_first_second());
  EXPECT_EQ(join.undone(), 1U);
  join.undo();
  EXPECT_EQ(join.undone(), 1U);
}

TEST(MapJoinParams, RefusesInvalidOnes) {
  MapJoinParams params;
  params.undone_loss = 0.5 * params.sure.max_loss;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.sure.min_gain = 0.0;
  EXPECT_THROW(validate(params), std::invalid_argument);
  params = {};
  params.agreeing_looks = 0;
  EXPECT_THROW(validate(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_map
