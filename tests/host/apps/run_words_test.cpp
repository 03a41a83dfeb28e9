// SPDX-License-Identifier: MIT
#include "host/apps/run_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace echomap::apps {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RunWords, AreWhatIsNotAsByDefault) {
  RunOptions run;
  EXPECT_THAT(strategy_words(run), IsEmpty());
  EXPECT_THAT(robot_words(run), IsEmpty());
  run.robot = "ev3";
  run.strategy.name = "tangent-bug";
  run.strategy.waypoints = "playground";
  run.strategy.as_told = true;
  run.slam = "none";
  EXPECT_THAT(robot_words(run), ElementsAre("--robot", "ev3"));
  EXPECT_THAT(
      strategy_words(run),
      ElementsAre(
          "--strategy", "tangent-bug", "--waypoints", "playground", "--as-told", "--slam", "none"));
}

TEST(RunWords, LeaveOutTheLimitOfStopsAndWriteSecondsAsTyped) {
  RunOptions run;
  run.strategy.stops = 3;
  run.strategy.name = "random-bounce";
  run.strategy.seconds = 60.0;
  EXPECT_THAT(strategy_words(run), ElementsAre("--strategy", "random-bounce", "--seconds", "60"));
}

}  // namespace
}  // namespace echomap::apps
