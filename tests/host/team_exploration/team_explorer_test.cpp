// SPDX-License-Identifier: MIT
#include "host/team_exploration/team_explorer.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <variant>

#include <gtest/gtest.h>

#include "tests/host/team_exploration/team_rooms.hpp"

namespace echomap::team_exploration {
namespace {

using exploration::EndScan;
using exploration::Finished;
using exploration::Motion;
using exploration::MotionResult;
using exploration::Roll;
using exploration::Stand;
using geometry::Pose2;
using tests::peer_at;

TeamExplorerParams member(const std::string& robot) {
  TeamExplorerParams params;
  params.avoidance.robot = robot;
  return params;
}

class TeamExplorerTest : public ::testing::Test {
 protected:
  /// The hall is open at x = 5 m.
  pipeline::Snapshot snapshot(const Pose2& T_map_robot = {}, double now_s = 1.0) const {
    auto snapshot = tests::snapshot_of(tests::open_hall(), {tests::pose_at(now_s, T_map_robot)});
    snapshot.stops = 1;
    return snapshot;
  }
  /// After the first stop.
  Motion first_move(TeamExplorer& explorer) {
    Motion motion;
    for (int i = 0; i < 20 && !std::holds_alternative<EndScan>(motion); ++i) {
      motion = explorer.next(snapshot(), MotionResult::kReached);
    }
    return explorer.next(snapshot(), MotionResult::kReached);
  }
  /// Somebody else bids for the open end.
  void other_bids(double utility, const Eigen::Vector2d& at_m = {4.6, 0.0}) {
    board.shown.peers = {peer_at("b", {4.0, 0.6, 0.0})};
    board.shown.claims = {{"b", at_m, utility, 2.5, ""}};
  }

  tests::ToldBoard board;
};

TEST_F(TeamExplorerTest, ClaimsWhereItGoesAndForWhatUse) {
  TeamExplorer explorer(board, member("a"));
  ASSERT_FALSE(std::holds_alternative<Finished>(first_move(explorer)));
  ASSERT_EQ(board.claims.size(), 1U) << "once is enough as long as nothing changes";
  ASSERT_TRUE(board.claims.front());
  const Claim& claim = *board.claims.front();
  EXPECT_EQ(claim.robot, "a");
  EXPECT_GT(claim.at_m.x(), 3.0);
  EXPECT_GT(claim.utility, 0.0);
  EXPECT_EQ(claim.waits_for, "");
}

TEST_F(TeamExplorerTest, BidsMoreAsItComesNearer) {
  TeamExplorer explorer(board, member("a"));
  first_move(explorer);
  explorer.next(snapshot({3.0, 0.0, 0.0}, 10.0), MotionResult::kReached);
  ASSERT_GE(board.claims.size(), 2U);
  EXPECT_GT(board.claims.back()->utility, board.claims.front()->utility);
  EXPECT_EQ(board.claims.back()->at_m, board.claims.front()->at_m);
}

TEST_F(TeamExplorerTest, TheLoserOfABidChoosesAgain) {
  TeamExplorer explorer(board, member("a"));
  first_move(explorer);
  const Claim mine = board.claims.front().value();
  other_bids(100.0, mine.at_m);
  explorer.next(snapshot(), MotionResult::kReached);
  EXPECT_EQ(explorer.lost_bids(), 1U);
  ASSERT_GE(board.claims.size(), 2U);
  EXPECT_TRUE(!board.claims.back() || board.claims.back()->at_m != mine.at_m);
  explorer.next(snapshot(), MotionResult::kReached);
  EXPECT_EQ(explorer.lost_bids(), 1U) << "it has taken note";
}

TEST_F(TeamExplorerTest, TheBetterBidKeepsItsGoal) {
  TeamExplorer explorer(board, member("a"));
  first_move(explorer);
  other_bids(1e-6, board.claims.front()->at_m);
  explorer.next(snapshot(), MotionResult::kReached);
  EXPECT_EQ(explorer.lost_bids(), 0U);
  EXPECT_EQ(board.claims.size(), 1U);
}

TEST_F(TeamExplorerTest, WaitsWhileOthersHaveClaimedTheRestAndTakesOverWhatTheyGiveBack) {
  auto params = member("a");
  params.frontier.enough_share = 0.0;
  TeamExplorer explorer(board, params);
  other_bids(100.0);
  board.shown.claims.front().reach_m = 8.0;
  EXPECT_TRUE(std::holds_alternative<Stand>(first_move(explorer)));
  EXPECT_TRUE(
      std::holds_alternative<Stand>(explorer.next(snapshot({}, 2.0), MotionResult::kReached)));
  board.shown.peers.front().age_s = 60.0;  // It has died.
  const Motion motion = explorer.next(snapshot({}, 9.0), MotionResult::kReached);
  EXPECT_FALSE(std::holds_alternative<Stand>(motion));
  EXPECT_FALSE(std::holds_alternative<Finished>(motion));
  ASSERT_FALSE(board.claims.empty());
  EXPECT_TRUE(board.claims.back());
}

TEST_F(TeamExplorerTest, HasFinishedWhenTheMapOfAllIsComplete) {
  TeamExplorer explorer(board, member("a"));
  board.shown.grid = std::make_shared<const mapping::OccupancyGrid>(tests::open_hall(true));
  const Motion motion = first_move(explorer);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, exploration::FinishReason::kComplete);
}

TEST_F(TeamExplorerTest, HasNotFinishedBeforeNobodyHasClaimedAnythingForAWhile) {
  TeamExplorer explorer(board, member("a"));
  board.shown.grid = std::make_shared<const mapping::OccupancyGrid>(tests::open_hall(true));
  other_bids(100.0);
  const auto is_finished_at = [&](double now_s) {
    return std::holds_alternative<Finished>(
        explorer.next(snapshot({}, now_s), MotionResult::kReached));
  };
  EXPECT_FALSE(std::holds_alternative<Finished>(first_move(explorer)));
  EXPECT_FALSE(is_finished_at(30.0)) << "the other one is on its way";
  board.shown.claims.clear();
  EXPECT_FALSE(is_finished_at(36.0)) << "the claim may only be late";
  other_bids(100.0);
  EXPECT_FALSE(is_finished_at(42.0));
  board.shown.claims.clear();
  EXPECT_FALSE(is_finished_at(48.0));
  EXPECT_TRUE(is_finished_at(59.0));
}

TEST_F(TeamExplorerTest, WaitsForNobodyWhoHasLeft) {
  TeamExplorer explorer(board, member("a"));
  board.shown.grid = std::make_shared<const mapping::OccupancyGrid>(tests::open_hall(true));
  other_bids(100.0);
  board.shown.claims.clear();
  board.shown.peers.front().stays = true;
  EXPECT_TRUE(std::holds_alternative<Finished>(first_move(explorer)));
}

// The hall is 2 m wide; one who stays in the middle leaves a way to both sides, five leave none.
TEST_F(TeamExplorerTest, HasFinishedWhereOnlyThoseWhoStayLeadOn) {
  TeamExplorer explorer(board, member("a"));
  for (const double y_m : {-0.8, -0.4, 0.0, 0.4, 0.8}) {
    board.shown.peers.push_back(peer_at("b" + std::to_string(y_m), {2.0, y_m, 0.0}));
    board.shown.peers.back().stays = true;
  }
  board.shown.grid = std::make_shared<const mapping::OccupancyGrid>(tests::open_hall());
  EXPECT_TRUE(std::holds_alternative<Finished>(first_move(explorer)));
}

TEST_F(TeamExplorerTest, DecidesAgainWhenOthersHaveShownItsGoal) {
  TeamExplorer explorer(board, member("a"));
  first_move(explorer);
  board.shown.grid = std::make_shared<const mapping::OccupancyGrid>(tests::open_hall(true));
  EXPECT_TRUE(std::holds_alternative<Finished>(
      explorer.next(snapshot({2.0, 0.0, 0.0}, 8.0), MotionResult::kReached)));
  EXPECT_FALSE(board.claims.back()) << "a robot that has finished claims nothing";
}

TEST_F(TeamExplorerTest, SaysForWhomItWaits) {
  TeamExplorer explorer(board, member("a"));
  first_move(explorer);
  board.shown.peers = {peer_at("b", {0.24, 0.0, 0.0})};
  board.shown.peers.front().T_map_robot = Pose2(2.24, 0.0, 0.0);
  const Motion motion = explorer.next(snapshot({2.0, 0.0, 0.0}, 5.0), MotionResult::kReached);
  EXPECT_TRUE(std::holds_alternative<Stand>(motion));
  EXPECT_EQ(board.claims.back()->waits_for, "b");
}

TEST_F(TeamExplorerTest, APeerThatItRunsIntoIsNoObstacleOfTheRoom) {
  TeamExplorer explorer(board, member("a"));
  first_move(explorer);
  board.shown.peers = {peer_at("b", {2.18, 0.0, 0.0})};
  auto bumped = snapshot({2.0, 0.0, 0.0}, 5.0);
  bumped.hazards.bump_left = true;
  const Motion back = explorer.next(bumped, MotionResult::kBumped);
  ASSERT_TRUE(std::holds_alternative<exploration::Drive>(back));
  board.shown.peers.clear();
  const Claim before = board.claims.back().value();
  Motion motion = explorer.next(snapshot({1.92, 0.0, 0.0}, 6.0), MotionResult::kReached);
  EXPECT_EQ(explorer.encounters().bumps, 1U);
  EXPECT_LT((board.claims.back()->at_m - before.at_m).norm(), 1.0) << "straight on";
}

TEST_F(TeamExplorerTest, RejectsParametersWithoutSense) {
  auto params = member("a");
  params.reach_m = 0.0;
  EXPECT_THROW(TeamExplorer(board, params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::team_exploration
