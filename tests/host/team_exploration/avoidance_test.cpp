// SPDX-License-Identifier: MIT
#include "host/team_exploration/avoidance.hpp"

#include <numbers>
#include <stdexcept>
#include <variant>

#include <gtest/gtest.h>

#include "tests/host/team_exploration/team_rooms.hpp"

namespace echomap::team_exploration {
namespace {

using exploration::Motion;
using exploration::MotionResult;
using exploration::Roll;
using exploration::Stand;
using geometry::Pose2;
using tests::peer_at;

AvoidanceParams named(const std::string& robot) {
  AvoidanceParams params;
  params.robot = robot;
  return params;
}

Pose2 step_of(const Motion& motion) {
  if (const auto* turn = std::get_if<exploration::Turn>(&motion)) {
    return {0.0, 0.0, turn->angle_rad};
  }
  if (const auto* drive = std::get_if<exploration::Drive>(&motion)) {
    return {drive->distance_m, 0.0, 0.0};
  }
  const auto& roll = std::get<Roll>(motion);
  return {roll.forward_m_per_s * roll.for_s, 0.0, roll.turn_rad_per_s * roll.for_s};
}

/// A robot at x = 0.5 m of the corridor with a niche, face to face with another one.
class AvoidanceTest : public ::testing::Test {
 protected:
  pipeline::Snapshot at_s(double now_s) {
    return tests::snapshot_of(floor, {tests::pose_at(now_s, T_map_robot)});
  }
  /// The other one wants to come past, and waits for `whom`.
  void meet(const std::string& robot, const std::string& whom) {
    view.peers = {peer_at(robot, {0.75, 0.0, std::numbers::pi})};
    view.claims = {{robot, {-0.8, 0.0}, 0.1, 2.0, whom}};
  }
  Motion next(Avoidance& avoidance, double now_s) {
    return avoidance.next(at_s(now_s), view, MotionResult::kReached)
        .value_or(Motion{tests::kRollAhead});
  }

  /// Drives as `avoidance` wants until it waits there; answers how far from the hall's middle.
  double drive_aside(Avoidance& avoidance, double now_s) {
    for (int i = 0; i < 50; ++i) {
      const Motion motion = next(avoidance, now_s + 0.1 * i);
      if (std::holds_alternative<Stand>(motion)) {
        break;
      }
      T_map_robot = T_map_robot * step_of(motion);
    }
    return std::abs(T_map_robot.y_m());
  }

  mapping::OccupancyGrid floor = tests::corridor_with_niche();
  Pose2 T_map_robot{1.6, 0.0, 0.0};
  TeamView view;
};

TEST_F(AvoidanceTest, LeavesMotionsAsTheyAreWhereNobodyIsInTheWay) {
  Avoidance avoidance(named("a"));
  const Motion motion = avoidance.checked(at_s(1.0), view, tests::kRollAhead);
  ASSERT_TRUE(std::holds_alternative<Roll>(motion));
  EXPECT_FALSE(avoidance.next(at_s(1.1), view, MotionResult::kReached));
  EXPECT_EQ(avoidance.waits_for(), "");
}

TEST_F(AvoidanceTest, WaitsForAPeerAndGoesOnOnceItHasLeft) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {1.8, 0.0, 0.0})};
  EXPECT_TRUE(std::holds_alternative<Stand>(avoidance.checked(at_s(1.0), view, tests::kRollAhead)));
  EXPECT_EQ(avoidance.waits_for(), "b");
  EXPECT_TRUE(std::holds_alternative<Stand>(next(avoidance, 1.4)));
  view.peers = {peer_at("b", {3.0, 0.0, 0.0})};
  EXPECT_TRUE(std::holds_alternative<Roll>(next(avoidance, 1.8)));
  EXPECT_EQ(avoidance.waits_for(), "");
  EXPECT_EQ(avoidance.encounters().waits, 1U);
  EXPECT_EQ(avoidance.encounters().deadlocks, 0U);
}

TEST_F(AvoidanceTest, LooksForSomethingElseWhenItsPatienceIsAtAnEnd) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {1.8, 0.0, 0.0})};
  avoidance.checked(at_s(1.0), view, tests::kRollAhead);
  next(avoidance, 2.0);
  EXPECT_FALSE(avoidance.wants_another_goal());
  next(avoidance, 8.0);
  EXPECT_TRUE(avoidance.wants_another_goal());
  EXPECT_FALSE(avoidance.wants_another_goal()) << "once is enough";
}

TEST_F(AvoidanceTest, TakesWhoNeverMovesForOneWhoStaysUntilHeMoves) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {1.8, 0.0, 0.0})};
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(avoidance.stays(view.peers.front())) << i;
    avoidance.checked(at_s(10.0 * i), view, tests::kRollAhead);
    next(avoidance, 10.0 * i + 7.0);
  }
  EXPECT_TRUE(avoidance.stays(view.peers.front()));
  view.peers = {peer_at("b", {2.7, 0.0, 0.0})};
  EXPECT_FALSE(avoidance.stays(view.peers.front()));
  view.peers.front().stays = true;
  EXPECT_TRUE(avoidance.stays(view.peers.front()));
}

TEST_F(AvoidanceTest, OfADeadlockTheLastNameMakesWayAndTheFirstWaits) {
  T_map_robot = Pose2(1.6, 0.0, std::numbers::pi);
  view.peers = {peer_at("b", {1.35, 0.0, 0.0})};
  view.claims = {{"b", {3.5, 0.0}, 0.1, 2.0, "c"}};
  Avoidance last(named("c"));
  last.checked(at_s(1.0), view, tests::kRollAhead);
  EXPECT_TRUE(last.is_making_way());
  EXPECT_EQ(last.encounters().deadlocks, 1U);
  EXPECT_EQ(last.encounters().made_way, 1U);

  view.claims.front().waits_for = "a";
  Avoidance first(named("a"));
  first.checked(at_s(1.0), view, tests::kRollAhead);
  EXPECT_FALSE(first.is_making_way());
  next(first, 5.0);
  EXPECT_FALSE(first.is_making_way());
}

TEST_F(AvoidanceTest, TheFirstNameMakesWayWhereTheLastCannot) {
  view.peers = {peer_at("b", {1.85, 0.0, std::numbers::pi})};
  view.claims = {{"b", {-0.8, 0.0}, 0.1, 2.0, "a"}};
  Avoidance first(named("a"));
  first.checked(at_s(1.0), view, tests::kRollAhead);
  bool has_made_way = false;
  for (double now_s = 1.4; now_s < 12.0; now_s += 0.4) {
    if (first.next(at_s(now_s), view, MotionResult::kReached) == std::nullopt) {
      first.checked(at_s(now_s), view, tests::kRollAhead);
    }
    has_made_way = has_made_way || first.is_making_way();
  }
  EXPECT_TRUE(has_made_way);
}

TEST_F(AvoidanceTest, StaysAsideUntilTheOtherHasPassed) {
  T_map_robot = Pose2(1.6, 0.0, std::numbers::pi);
  view.peers = {peer_at("b", {1.35, 0.0, 0.0})};
  view.claims = {{"b", {3.5, 0.0}, 0.1, 2.0, "c"}};
  Avoidance avoidance(named("c"));
  avoidance.checked(at_s(1.0), view, tests::kRollAhead);
  ASSERT_TRUE(avoidance.is_making_way());
  EXPECT_FALSE(std::holds_alternative<Stand>(next(avoidance, 1.4))) << "on the way";
  T_map_robot = Pose2(1.45, 0.5, std::numbers::pi);
  view.claims.front().waits_for = "";
  double now_s = 2.0;
  for (; now_s < 15.0 && !std::holds_alternative<Stand>(next(avoidance, now_s)); now_s += 0.4) {
  }
  next(avoidance, now_s + 4.0);
  EXPECT_TRUE(avoidance.is_making_way()) << "it comes";
  view.peers.front().T_map_robot = Pose2(2.6, 0.0, 0.0);
  next(avoidance, now_s + 5.0);
  EXPECT_FALSE(avoidance.is_making_way());
  EXPECT_TRUE(avoidance.wants_another_goal());
}

/// Both let the other one pass, and neither does: so they stood for 95 minutes in `ward`, seed 9.
TEST_F(AvoidanceTest, LeavesMoreRoomEachTimeItMakesWayInVainAndThenTakesTheOtherForOneWhoStays) {
  floor = tests::open_hall();
  Avoidance avoidance(named("c"));
  view.peers = {peer_at("b", {1.35, 0.0, 0.0})};
  view.claims = {{"b", {3.5, 0.0}, 0.1, 2.0, "c"}};
  std::vector<double> aside_m;
  double now_s = 1.0;
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(avoidance.stays(view.peers.front())) << i;
    T_map_robot = Pose2(1.6, 0.0, std::numbers::pi);
    avoidance.checked(at_s(now_s), view, tests::kRollAhead);
    ASSERT_TRUE(avoidance.is_making_way()) << i;
    aside_m.push_back(drive_aside(avoidance, now_s));
    now_s += 25.0;
    next(avoidance, now_s);
    EXPECT_FALSE(avoidance.is_making_way()) << i;
  }
  EXPECT_TRUE(avoidance.stays(view.peers.front()));
  EXPECT_GT(aside_m[1], aside_m[0] + 0.05);
  EXPECT_GT(aside_m[2], aside_m[1] + 0.05);
}

TEST_F(AvoidanceTest, MakesWayForWhomItHoldsUp) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {1.9, 0.0, std::numbers::pi})};
  view.claims = {{"b", {-0.8, 0.0}, 0.1, 2.0, ""}};
  EXPECT_FALSE(avoidance.make_way(at_s(1.0), view)) << "nobody waits";
  view.claims.front().waits_for = "a";
  EXPECT_TRUE(avoidance.make_way(at_s(1.0), view));
  EXPECT_TRUE(avoidance.is_making_way());
}

TEST_F(AvoidanceTest, DistinguishesAPeerFromAWallWhenItBumps) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {3.5, 0.0, 0.0})};
  EXPECT_FALSE(avoidance.has_run_into_peer(at_s(1.0), view, MotionResult::kBumped));
  view.peers = {peer_at("b", {1.79, 0.0, 0.0})};
  EXPECT_TRUE(avoidance.has_run_into_peer(at_s(1.0), view, MotionResult::kBumped));
  EXPECT_FALSE(avoidance.has_run_into_peer(at_s(1.0), view, MotionResult::kReached));
}

TEST_F(AvoidanceTest, GoesBackFromAPeerThatItHasRunInto) {
  Avoidance avoidance(named("a"));
  const Motion motion = avoidance.back_off(at_s(1.0));
  EXPECT_LT(std::get<exploration::Drive>(motion).distance_m, 0.0);
  EXPECT_EQ(avoidance.encounters().bumps, 1U);
  EXPECT_TRUE(avoidance.wants_another_goal());
}

TEST_F(AvoidanceTest, PlansAroundWhereItHasRunIntoAPeerForAWhile) {
  Avoidance avoidance(named("a"));
  EXPECT_TRUE(avoidance.company(view, 1.0).standing.empty());
  avoidance.back_off(at_s(1.0));
  const auto standing = avoidance.company(view, 30.0).standing;
  ASSERT_EQ(standing.size(), 1U);
  EXPECT_TRUE(standing.front().is_closed);
  EXPECT_NEAR(standing.front().at_m.x(), T_map_robot.x_m() + 0.18, 1e-9);
  EXPECT_TRUE(avoidance.plans_around_bump(60.0));
  EXPECT_TRUE(avoidance.company(view, 62.0).standing.empty());
  EXPECT_FALSE(avoidance.plans_around_bump(62.0));
}

/// In corridor_rooms, seed 7, one of four robots waited 1224 times in two hours for one that stood.
TEST_F(AvoidanceTest, PlansAroundOneWhoStaysInAWiderCircleEachTimeThatItWaitsForItAgain) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {1.8, 0.0, 0.0})};
  std::vector<double> radius_m;
  for (int i = 0; i < 6; ++i) {
    avoidance.checked(at_s(10.0 * i), view, tests::kRollAhead);
    next(avoidance, 10.0 * i + 7.0);
    if (avoidance.stays(view.peers.front())) {
      radius_m.push_back(avoidance.company(view, 10.0 * i + 8.0).standing.front().radius_m);
    }
  }
  ASSERT_EQ(radius_m.size(), 4U);
  EXPECT_NEAR(radius_m[0], avoidance.keep_off_m(view.peers.front()) - 0.09, 1e-9);
  EXPECT_NEAR(radius_m[3], radius_m[0] + 0.3, 1e-9);
  EXPECT_GT(avoidance.encounters().made_way, 0U) << "from within, no path round it can be planned";
}

TEST_F(AvoidanceTest, ABackOffThatIsStoppedIsNotRepeated) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {1.79, 0.0, 0.0})};
  avoidance.back_off(at_s(1.0));
  EXPECT_FALSE(avoidance.has_run_into_peer(at_s(1.5), view, MotionResult::kStalled));
  EXPECT_TRUE(avoidance.has_run_into_peer(at_s(2.0), view, MotionResult::kBumped));
}

TEST_F(AvoidanceTest, ForgetsThatItLostPatienceWithAPeerThatLeftAndCameBack) {
  Avoidance avoidance(named("a"));
  view.peers = {peer_at("b", {1.8, 0.0, 0.0})};
  for (int i = 0; i < 3; ++i) {
    avoidance.checked(at_s(10.0 * i), view, tests::kRollAhead);
    next(avoidance, 10.0 * i + 7.0);
  }
  ASSERT_TRUE(avoidance.stays(view.peers.front()));
  view.peers = {peer_at("b", {3.5, 0.0, 0.0})};
  next(avoidance, 40.0);
  view.peers = {peer_at("b", {1.8, 0.0, 0.0})};
  EXPECT_FALSE(avoidance.stays(view.peers.front()));
}

TEST_F(AvoidanceTest, RejectsParametersWithoutSense) {
  EXPECT_THROW(Avoidance{AvoidanceParams{}}, std::invalid_argument) << "without a name";
  AvoidanceParams params = named("a");
  params.patience_s = 0.0;
  EXPECT_THROW(Avoidance{params}, std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_exploration
