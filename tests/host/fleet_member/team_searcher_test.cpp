// SPDX-License-Identifier: MIT
#include "host/fleet_member/team_searcher.hpp"

#include <memory>
#include <optional>
#include <stdexcept>
#include <variant>

#include <gtest/gtest.h>

#include "tests/support/told_snapshot.hpp"

namespace echomap::fleet_member {
namespace {

using exploration::Finished;
using exploration::FinishReason;
using exploration::Motion;
using exploration::MotionResult;
using geometry::Pose2;
using source_search::SourceVerdict;

class ToldBoard final : public SearchBoard {
 public:
  team_exploration::TeamView view() override { return team; }
  void claim(const std::optional<team_exploration::Claim>& claim) override { claimed = claim; }
  SearchView search_view() const override { return others; }
  void publish_search(const fleet_messages::SearchReport& report) override { published = report; }

  team_exploration::TeamView team;
  SearchView others;
  std::optional<team_exploration::Claim> claimed;
  fleet_messages::SearchReport published;
};

/// A robot in a room of 6 x 4 m, in a map that is whole.
class TeamSearcherTest : public testing::Test {
 protected:
  TeamSearcherTest() {
    mapping::OccupancyGrid grid;
    for (int i = 0; i < 120 * 80; ++i) {
      const int x = i % 120;
      const int y = i / 120;
      grid.add({x, y}, x == 0 || y == 0 || x == 119 || y == 79 ? 300 : -300);
    }
    snapshot = tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, Pose2(1.0, 1.0, 0.0))});
    source_search::SourceSearchParams params;
    params.explores = false;
    search = std::make_shared<source_search::SourceSearch>(params);
  }
  TeamSearcher searcher(TeamSearcherParams params = {}) {
    params.avoidance.robot = "a";
    return {board, search, own, params};
  }
  /// What somebody else has read near a source at (4, 2), along a way past it.
  void read_by_others(int readings) {
    for (int i = 0; i < readings; ++i) {
      const Eigen::Vector2d at_m(3.0 + 0.25 * (i % 9), i < 9 ? 1.6 : 2.5);
      const double rate = 0.4 + 10.0 / ((at_m - source_m).squaredNorm() + 0.01);
      board.others.readings.push_back({"b.0", 1.0 * i, {at_m, 20.0 * rate, 20.0, 0.03}});
    }
  }

  const Eigen::Vector2d source_m{4.0, 2.0};
  pipeline::Snapshot snapshot;
  source_search::SourceReadings own{source_search::SourceReadingsParams()};
  std::shared_ptr<source_search::SourceSearch> search;
  ToldBoard board;
};

TEST_F(TeamSearcherTest, PublishesWhatItIsAboutToReadAndWhereItGoes) {
  auto robot = searcher();
  robot.next(snapshot, MotionResult::kReached);
  EXPECT_EQ(board.published.verdict, SourceVerdict::kUndecided);
  ASSERT_FALSE(board.published.plan.empty());
  ASSERT_TRUE(board.claimed);
  EXPECT_EQ(board.claimed->at_m, board.published.plan.back().at_m);
}

TEST_F(TeamSearcherTest, IsSureByWhatOthersHaveReadAndPublishesIt) {
  read_by_others(18);
  auto robot = searcher();
  const Motion motion = robot.next(snapshot, MotionResult::kReached);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(std::get<Finished>(motion).reason, FinishReason::kComplete);
  EXPECT_EQ(board.published.verdict, SourceVerdict::kFound);
  EXPECT_LT((board.published.at_m - source_m).norm(), 0.2);
  EXPECT_GE(board.published.probability, 0.95);
  EXPECT_TRUE(board.published.plan.empty());
}

TEST_F(TeamSearcherTest, TakesEachReadingOfOthersOnce) {
  auto robot = searcher();
  read_by_others(2);
  robot.next(snapshot, MotionResult::kReached);
  const auto before = search->belief()->grid().readings();
  robot.next(snapshot, MotionResult::kReached);
  ASSERT_EQ(search->belief()->grid().readings().size(), before.size());
  EXPECT_EQ(search->belief()->grid().readings()[0].dwell_s, before[0].dwell_s);
}

TEST_F(TeamSearcherTest, EndsWhenAnotherOneIsSure) {
  auto robot = searcher();
  TeamFinding finding;
  finding.robot = "b";
  finding.report.verdict = SourceVerdict::kFound;
  board.others.finding = finding;
  const Motion motion = robot.next(snapshot, MotionResult::kReached);
  ASSERT_TRUE(std::holds_alternative<Finished>(motion));
  EXPECT_EQ(board.published.verdict, SourceVerdict::kUndecided) << "it is the other one's finding";
}

TEST_F(TeamSearcherTest, RefusesNoTime) {
  TeamSearcherParams params;
  params.max_s = 0.0;
  EXPECT_THROW(searcher(params), std::invalid_argument);
}

}  // namespace
}  // namespace echomap::fleet_member
