// SPDX-License-Identifier: MIT
// Mukherjee et al., section IV and figure 8: a Create traces arenas of different shapes by the
// coastal rule. The share of runs that end and have all corners is told over 20 seeds by `./run
// bench exploration`; here are a few.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/integration/programs.hpp"
#include "tests/papers/demo_run.hpp"
#include "tests/support/every_seed.hpp"
#include "tests/support/exploration_case.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::papers {
namespace {

using tests::ExplorationCase;

class Paper001Exploration : public ::testing::Test {
 protected:
  nlohmann::json trace(const ExplorationCase& what,
                       int seed,
                       const std::vector<std::string>& more = {}) {
    auto arguments = tests::demo_arguments(what, seed);
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_demo(arguments, scratch_ / std::to_string(runs_++));
  }

  tests::ScratchFolder scratch_;
  int runs_ = 0;
};

ExplorationCase on_the_mock(ExplorationCase what) {
  what.board.clear();
  return what;
}

void expect_outline(const nlohmann::json& report, double corner_rmse_m) {
  EXPECT_EQ(report.at("outcome"), "complete");
  EXPECT_EQ(report.at("outline_corners"), report.at("room_corners"));
  EXPECT_LT(report.at("corner_rmse_m"), corner_rmse_m);
}

// The L and the T on the image, too, in `./run test --full`.
TEST_F(Paper001Exploration, TracesAnL) {
  const auto create = tests::create_in("create_l");
  expect_outline(trace(on_the_mock(create), 1), 0.08);
  if (tests::runs_every_seed()) {
    expect_outline(trace(create, 1), 0.08);
  }
}

TEST_F(Paper001Exploration, TracesAT) {
  const auto create = tests::create_in("create_t");
  expect_outline(trace(on_the_mock(create), 2), 0.08);
  if (tests::runs_every_seed()) {
    expect_outline(trace(create, 2), 0.08);
  }
}

TEST_F(Paper001Exploration, TracesAConvexRoom) {
  expect_outline(trace(on_the_mock(tests::create_in("empty_room")), 1), 0.08);
}

TEST_F(Paper001Exploration, TracesWithTheLeftHandWhereTheSensorIsThere) {
  auto what = on_the_mock(tests::create_in("create_l"));
  what.robot = "create_left";
  expect_outline(trace(what, 1, {"--hand=left"}), 0.08);
}

// "Even if the shape is very symmetrical (like circular), the robot can still sketch an approximate
// map": a polygon of fewer corners than the room's 36.
TEST_F(Paper001Exploration, TracesARoundRoomAsAPolygon) {
  const auto report = trace(on_the_mock(tests::create_in("round_room")), 1);
  EXPECT_EQ(report.at("outcome"), "complete");
  EXPECT_GE(report.at("outline_corners"), 8);
  EXPECT_LE(report.at("outline_corners"), 24);
  EXPECT_LT(report.at("corner_rmse_m"), 0.3);
}

// Equations 4 to 8: ways 4 % longer than the odometry believes, and three measured drives. Turns
// are as the odometry has them, as the paper takes them to be: the track is wider by as much.
TEST_F(Paper001Exploration, PutsTheCornersRightWithTheFittedLine) {
  const auto in_the_l = [&](auto&& create) {
    return trace(on_the_mock(create("create_l", scratch_.path())), 1);
  };
  const auto as_it_is = in_the_l(tests::stretched_create_in);
  const auto corrected = in_the_l(tests::measured_create_in);
  expect_outline(corrected, 0.05);
  EXPECT_GT(as_it_is.at("corner_rmse_m"), 1.5 * corrected.at("corner_rmse_m").get<double>());
}

// What a profile needs for the left hand is said.
TEST_F(Paper001Exploration, ACreateHasItsWallSensorOnTheRight) {
  const auto log = scratch_ / "log";
  const auto ended = test::Program("echomap",
                                   {"demo",
                                    "--headless",
                                    "--robot=create",
                                    "--strategy=coastal",
                                    "--hand=left",
                                    "--out=" + (scratch_ / "none").string()},
                                   log)
                         .wait();
  EXPECT_EQ(ended.status, 6);
  EXPECT_NE(ended.said.find("wall sensor on the left"), std::string::npos) << ended.said;
}

// Section V: the robot moves in a random manner.
TEST_F(Paper001Exploration, BouncesAboutForAsLongAsItIsTold) {
  const auto report = run_demo({"--robot=create",
                                "--world=create_t",
                                "--emulator=mock",
                                "--strategy=random-bounce",
                                "--seconds=60",
                                "--seed=1"},
                               scratch_ / "bounce");
  EXPECT_EQ(report.at("outcome"), "complete");
  EXPECT_NEAR(report.at("sim_seconds"), 60.0, 8.0);
  EXPECT_GT(report.at("travelled_m"), 4.0);
}

}  // namespace
}  // namespace echomap::papers
