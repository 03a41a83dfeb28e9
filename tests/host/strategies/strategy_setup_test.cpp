// SPDX-License-Identifier: MIT
#include "host/strategies/strategy_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/thrown_text.hpp"

namespace echomap::strategies {
namespace {

TEST(StrategySetup, TakesTheRobotFromItsProfile) {
  const session::RobotProfile profile = session::load_robot_profile("uno_2wd");
  const auto params = nxt_farthest_params(profile, 7);
  EXPECT_EQ(params.max_stops, 7U);
  EXPECT_EQ(params.robot_radius_m, profile.body_radius_m);
  EXPECT_EQ(params.sweep.pan_limit_rad, profile.pan_limit_rad);
  EXPECT_EQ(params.sweep.settle_s, profile.settle_s);
}

TEST(StrategySetup, ExpectsNoAnswerFromWallsThatTheSonarDoesNotReach) {
  const auto far_m = [](const char* robot) {
    const auto params = frontier_params(session::load_robot_profile(robot), std::nullopt);
    return params.gain.unobserved.max_distance_m;
  };
  EXPECT_EQ(far_m("uno_2wd"), exploration::UnobservedWallParams().max_distance_m);
  EXPECT_NEAR(far_m("nxt_tribot"), 2.1, 1e-9) << "of 2.3 m";
}

TEST(StrategySetup, MakesEachStrategyThatTheOptionsMayName) {
  std::mt19937 random(1);
  const tests::ScratchFolder folder;
  const auto list = folder.path() / "stops.toml";
  files::write_text_file(list, "[[place]]\nx_m = 1\ny_m = 0\n");
  for (const Strategy& strategy : strategies()) {
    for (const char* robot : {"uno_2wd", "create", "epuck"}) {
      const session::RobotProfile profile = session::load_robot_profile(robot);
      StrategyOptions options;
      options.name = strategy.name;
      options.waypoints = options.name == "tangent-bug" ? "playground" : "";
      options.stop_list = options.name == "stops" ? list.string() : "";
      if (strategy.lack(profile, options).empty()) {
        EXPECT_TRUE(explorer_for(profile, options, random)) << strategy.name << " " << robot;
      }
    }
  }
}

TEST(StrategySetup, TellsTangentBugOfTheRobot) {
  const session::RobotProfile profile = session::load_robot_profile("ev3");
  const auto params = tangent_bug_params(profile);
  EXPECT_EQ(params.robot_radius_m, profile.body_radius_m);
  EXPECT_EQ(params.beam_half_angle_rad, profile.beam_half_angle_rad);
  EXPECT_EQ(params.max_m, profile.range.max_range_m);
  EXPECT_EQ(params.sweep.pan_limit_rad, profile.pan_limit_rad);
  EXPECT_EQ(params.sweep.settle_s, profile.settle_s);
}

TEST(StrategySetup, AsksForTheWaypointsOfTangentBug) {
  std::mt19937 random(1);
  StrategyOptions options;
  options.name = "tangent-bug";
  try {
    explorer_for(session::load_robot_profile("ev3"), options, random);
    FAIL() << "it has no waypoints";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kUsage);
    EXPECT_THAT(error.what(), testing::HasSubstr("--waypoints"));
  }
}

TEST(StrategySetup, AsksForTheListOfStops) {
  std::mt19937 random(1);
  StrategyOptions options;
  options.name = "stops";
  EXPECT_THAT(tests::thrown_text<console::CommandError>(
                  [&] { explorer_for(session::load_robot_profile("uno_2wd"), options, random); }),
              testing::HasSubstr("--stop-list FILE"));
}

TEST(StrategySetup, RefusesWhatOnlyAnotherStrategyGoesBy) {
  const auto complaint_about = [](const StrategyOptions& options) {
    return tests::thrown_text<console::CommandError>(
        [&] { validate_fit(session::load_robot_profile("uno_2wd"), options); });
  };
  StrategyOptions options;
  options.name = "frontier";
  options.scans = 2;
  EXPECT_THAT(complaint_about(options),
              testing::HasSubstr("--scans is for strategy 'nxt-farthest'"));
  options.scans = 1;
  options.waypoints = "playground";
  EXPECT_THAT(complaint_about(options),
              testing::HasSubstr("--waypoints is for strategy 'tangent-bug'"));
  options.waypoints = "";
  options.stop_list = "stops.toml";
  EXPECT_THAT(complaint_about(options), testing::HasSubstr("--stop-list is for strategy 'stops'"));
  options.stop_list = "";
  options.as_told = true;
  EXPECT_THAT(complaint_about(options),
              testing::HasSubstr("--as-told is for strategy 'nxt-farthest'"));
  options.name = "nxt-farthest";
  EXPECT_NO_THROW(validate_fit(session::load_robot_profile("uno_2wd"), options));
}

TEST(StrategySetup, LeavesOutDeparturesOfNxtFarthestWhereThatIsAskedFor) {
  const exploration::NxtFarthestParams told = as_told(exploration::NxtFarthestParams{});
  EXPECT_EQ(told.candidate_spread_rad, 0.0);
  EXPECT_EQ(told.stop_spacing_m, 0.0);
  EXPECT_EQ(told.candidates, 4U);
}

TEST(StrategySetup, RefusesAsOptionsWhatOtherStrategiesGoBy) {
  const auto create = session::load_robot_profile("create");
  const auto complaint_about = [&](const StrategyOptions& options) {
    return tests::thrown_text<console::CommandError>([&] { validate_fit(create, options); });
  };
  StrategyOptions options;
  options.name = "coastal";
  options.stops = 3;
  EXPECT_EQ(complaint_about(options),
            "--stops is for strategy 'nxt-farthest', not for 'coastal'\n  next: leave it out")
      << "a Create has no sonar";
  options.stops.reset();
  options.seconds = 60.0;
  EXPECT_THAT(complaint_about(options),
              testing::EndsWith("leave it out, or --strategy random-bounce"));
  options.name = "random-bounce";
  EXPECT_NO_THROW(validate_fit(create, options));
  options.hand = "left";
  EXPECT_THAT(complaint_about(options), testing::HasSubstr("--hand is for strategy 'coastal'"));
}

struct Misfit {
  const char* robot;
  const char* strategy;
  const char* next;
};

TEST(StrategySetup, SaysWhichRobotAndWhichStrategyFit) {
  std::mt19937 random(1);
  for (const Misfit& one :
       {Misfit{
            "create", "frontier", "--robot uno_2wd, or --strategy coastal, which 'create' can do"},
        Misfit{"epuck", "frontier", "--robot uno_2wd, or --strategy epuck, which 'epuck' can do"},
        Misfit{
            "uno_2wd", "coastal", "--robot create, or --strategy frontier, which 'uno_2wd' can do"},
        Misfit{"uno_2wd", "epuck", "--robot epuck, or --strategy frontier, which 'uno_2wd' can do"},
        Misfit{"create_left", "coastal", "--hand left"}}) {
    StrategyOptions options;
    options.name = one.strategy;
    const auto profile = session::load_robot_profile(one.robot);
    EXPECT_THAT(
        tests::thrown_text<console::CommandError>([&] { explorer_for(profile, options, random); }),
        testing::EndsWith("\n  next: " + std::string(one.next)))
        << one.robot << " " << one.strategy;
  }
}

TEST(StrategySetup, SaysWhatARobotLacks) {
  std::mt19937 random(1);
  try {
    explorer_for(session::load_robot_profile("create"), StrategyOptions{}, random);
    FAIL() << "it has no sonar";
  } catch (const console::CommandError& error) {
    EXPECT_EQ(error.code(), console::ExitCode::kConfigInvalid);
    EXPECT_THAT(error.what(), testing::HasSubstr("needs a sonar"));
  }
}

}  // namespace
}  // namespace echomap::strategies
