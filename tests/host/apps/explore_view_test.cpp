// SPDX-License-Identifier: MIT
#include "host/apps/explore_view.hpp"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host/session/session_on_a_cable.hpp"

namespace echomap::apps {
namespace {

using exploration::MotionResult;

TEST(WordsOf, SayWhatTheRobotDoes) {
  EXPECT_EQ(words_of(exploration::Turn{-0.5 * 3.14159265}), "turns 90° to the right");
  EXPECT_EQ(words_of(exploration::Turn{0.5}), "turns 29° to the left");
  EXPECT_EQ(words_of(exploration::Drive{0.8}), "drives 0.80 m");
  EXPECT_EQ(words_of(exploration::Drive{-0.1}), "drives 0.10 m back");
  EXPECT_EQ(words_of(exploration::Sweep{}), "sweeps its sonar");
  EXPECT_EQ(words_of(exploration::Finished{exploration::FinishReason::kComplete}),
            "ended: complete");
}

TEST(HealthOf, IsInMilliseconds) {
  robot_link::LinkStatistics statistics;
  EXPECT_FALSE(health_of(statistics).round_trip_ms);
  statistics.round_trip = std::chrono::microseconds(3140);
  statistics.frames_lost = 2;
  statistics.frames_bad = 1;
  statistics.resets_seen = 3;
  const terminal_view::LinkHealth link = health_of(statistics);
  EXPECT_DOUBLE_EQ(*link.round_trip_ms, 3.14);
  EXPECT_EQ(link.frames_lost, 2U);
  EXPECT_EQ(link.frames_bad, 1U);
  EXPECT_EQ(link.resets, 3U);
}

class DrivingExplorer final : public exploration::Explorer {
 public:
  exploration::Motion next(const pipeline::Snapshot& /*snapshot*/, MotionResult /*last*/) override {
    return exploration::Drive{0.8};
  }
};

class ExploreViewOnACable : public session::SessionOnACable {
 protected:
  ExploreViewOnACable() {
    begin_maps(robot, "", "none");
    robot.open({new_connection(), nullptr});
    strategy.stops = 4;
  }

  const std::filesystem::path out;
  strategies::StrategyOptions strategy;
  session::RobotContext robot{profile, session::Seed(1)};
  LiveRun live{LiveOptions(), robot, {}};
  exploration::AtlasExplorer explorer{
      [](std::size_t /*stops*/) { return std::make_unique<DrivingExplorer>(); }, 0};
};

TEST_F(ExploreViewOnACable, ShowsWhatTheExplorerAsksForAndPassesItOn) {
  const ExploreRun run{strategy, live, out, ProgressDisplay::kMap};
  ExploreView shown(robot, run, explorer);
  EXPECT_EQ(shown.view().status.doing, "connects");
  const auto motion = shown.next(robot.atlas().pipeline().snapshot(), MotionResult::kReached);
  EXPECT_TRUE(std::holds_alternative<exploration::Drive>(motion));
  const terminal_view::RunView view = shown.view();
  EXPECT_EQ(view.status.doing, "drives 0.80 m");
  EXPECT_EQ(view.status.mode, "exploring by frontier");
  EXPECT_TRUE(view.marks.T_map_robot);
  EXPECT_FALSE(view.status.position_95_m) << "odometry alone does not know";
}

TEST_F(ExploreViewOnACable, ItsLineCountsFromTheRunThatItResumes) {
  ExploreRun run{strategy, live, out};
  run.resumed = ResumedRun{0, 60.0};
  ExploreView shown(robot, run, explorer);
  EXPECT_DOUBLE_EQ(shown.elapsed_s(), 60.0);
  EXPECT_EQ(shown.line(), "0 stops, 0.0 m² mapped, 0.0 m driven in 1:00");
}

}  // namespace
}  // namespace echomap::apps
