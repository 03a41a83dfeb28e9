// SPDX-License-Identifier: MIT
#include "host/source_search/source_search.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/offline_source_search.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::source_search {
namespace {

using exploration::Motion;
using exploration::MotionResult;
using geometry::Pose2;

tests::OfflineSearch search_of(std::vector<Pose2> starts) {
  tests::OfflineSearch search;
  search.params.explores = false;
  search.params.frontier.navigator.follower.speed_m_per_s = 0.2;
  search.starts = std::move(starts);
  return search;
}

/// 6 x 4 m with a box in the middle.
tests::SourceWorld small_hall() {
  return tests::SourceWorld({6.0, 4.0}, {{{2.7, 1.7}, {3.3, 2.3}}});
}

TEST(SourceSearch, FindsASource) {
  tests::SourceTruth truth;
  truth.at_m = {4.9, 3.1};
  truth.strength = 6.0;
  const auto run = tests::search_offline(small_hall(), truth, search_of({Pose2(0.6, 0.6, 0.0)}));
  EXPECT_TRUE(run.is_right);
  EXPECT_EQ(run.estimate.verdict, SourceVerdict::kFound);
  EXPECT_LT(run.time_s, 200.0);
}

TEST(SourceSearch, SaysThatThereIsNone) {
  const auto run = tests::search_offline(small_hall(), {}, search_of({Pose2(0.6, 0.6, 0.0)}));
  EXPECT_TRUE(run.is_right);
  EXPECT_EQ(run.estimate.verdict, SourceVerdict::kNone);
}

TEST(SourceSearch, IsAFunctionOfItsSeed) {
  tests::SourceTruth truth;
  truth.at_m = {4.9, 3.1};
  const auto search = search_of({Pose2(0.6, 0.6, 0.0), Pose2(0.6, 3.4, 0.0)});
  const auto one = tests::search_offline(small_hall(), truth, search);
  const auto other = tests::search_offline(small_hall(), truth, search);
  EXPECT_EQ(one.time_s, other.time_s);
  EXPECT_EQ(one.readings, other.readings);
  EXPECT_EQ(one.estimate.best_m, other.estimate.best_m);
}

TEST(SourceSearch, LooksAroundFirstWhereTheMapIsStillToBeMade) {
  SourceSearch search({});
  const auto snapshot = tests::snapshot_of(mapping::OccupancyGrid(), {tests::pose_at(1.0, {})});
  EXPECT_TRUE(std::holds_alternative<exploration::BeginScan>(
      search.next(snapshot, MotionResult::kReached)));
}

TEST(SourceSearch, GoesToUnknownFloorWhileItReadsNothingOfNote) {
  SourceSearchParams params;
  params.nats_per_unknown_m2 = 100.0;
  SourceSearch search(params);
  mapping::OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 60; ++x) {
      const bool wall = x == -20 || std::abs(y) == 20;
      grid.add({x, y}, wall ? 300 : -300);
    }
  }
  auto snapshot = tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, {})});
  snapshot.stops = 1;
  Motion motion;
  do {
    motion = search.next(snapshot, MotionResult::kReached);
  } while (!std::holds_alternative<exploration::EndScan>(motion));
  search.next(snapshot, MotionResult::kReached);
  const auto intent = search.intent();
  EXPECT_EQ(intent.kind, exploration::IntentKind::kFrontier);
  ASSERT_TRUE(intent.goal);
  EXPECT_GT(intent.goal->at_m.x(), 1.0);
}

TEST(SourceSearch, ExploresTheRestBeforeItSaysThatThereIsNone) {
  SourceSearchParams params;
  params.beyond_m = 1000.0;
  params.frontier.viewpoints.min_gain_m2 = 1000.0;
  SourceSearch search(params);
  mapping::OccupancyGrid grid;
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 60; ++x) {
      grid.add({x, y}, x == -20 || std::abs(y) == 20 ? 300 : -300);
    }
  }
  auto snapshot = tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, {})});
  snapshot.stops = 1;
  search.set_readings({{{0.0, 0.0}, 0.0, 60.0, 0.0}});
  Motion motion;
  do {
    motion = search.next(snapshot, MotionResult::kReached);
  } while (!std::holds_alternative<exploration::EndScan>(motion));
  motion = search.next(snapshot, MotionResult::kReached);
  const SourceEstimate& estimate = search.belief()->estimate();
  EXPECT_EQ(estimate.verdict, SourceVerdict::kUndecided);
  EXPECT_GT(estimate.none_probability + estimate.unseen_probability, 0.95);
  EXPECT_FALSE(std::holds_alternative<exploration::Finished>(motion));
  EXPECT_FALSE(search.has_ended());
}

TEST(SourceSearch, KnowsWhatItIsAboutToRead) {
  const auto world = small_hall();
  SourceSearchParams params;
  params.explores = false;
  SourceSearch search(params);
  EXPECT_TRUE(search.plan().empty());
  EXPECT_EQ(search.belief(), nullptr);
  mapping::OccupancyGrid grid;
  for (int i = 0; i < 120 * 80; ++i) {
    grid.add({i % 120, i / 120}, i % 120 == 0 || i % 120 == 119 ? 300 : -300);
  }
  const auto snapshot =
      tests::snapshot_of(std::move(grid), {tests::pose_at(1.0, Pose2(1.0, 1.0, 0.0))});
  search.next(snapshot, MotionResult::kReached);
  EXPECT_FALSE(search.plan().empty());
  EXPECT_NE(search.belief(), nullptr);
}

TEST(SourceSearch, RefusesWhatIsOutOfRange) {
  SourceSearchParams params;
  params.rethink_s = 0.0;
  EXPECT_THROW(SourceSearch{params}, std::invalid_argument);
  params = {};
  params.frontier.sweep.step_rad = 0.0;
  EXPECT_THROW(SourceSearch{params}, std::invalid_argument);
  params = {};
  params.belief.grid.unknown_reach_m = 0.5 * params.frontier.gain.depth_m;
  EXPECT_THROW(SourceSearch{params}, std::invalid_argument);
  params.explores = false;
  EXPECT_NO_THROW(SourceSearch{params});
}

}  // namespace
}  // namespace echomap::source_search
