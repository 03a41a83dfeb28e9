// SPDX-License-Identifier: MIT
/// What becomes of an exploration when a part fails, the robot is carried off or the line breaks.
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// The demo on the native mock, without the kidnapping at its end.
class ExploreFaults : public ::testing::Test {
 protected:
  Ended run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "demo", "--emulator=mock", "--no-kidnap", "--out=" + (scratch / "run").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Program("echomap", arguments, scratch / "log").wait();
  }
  /// At the port of a mock that is lifted, held and put down as its --kidnap says.
  Ended run_carried_off(const std::string& seed, const std::string& kidnap) {
    const auto socket = scratch / "lockstep";
    const auto port = scratch / "robot";
    const auto truth = scratch / "truth";
    std::filesystem::create_directories(truth);
    Program robot("echomap-mock",
                  {"--seed=" + seed,
                   "--kidnap=" + kidnap,
                   "--link=" + port.string(),
                   "--lockstep=" + socket.string(),
                   "--truth=" + truth.string()},
                  scratch / "robot_log");
    EXPECT_TRUE(eventually([&] { return exists(socket) && exists(port); }));
    const Ended ended = Program("echomap",
                                {"explore",
                                 "--seed=" + seed,
                                 "--port=" + port.string(),
                                 "--lockstep=" + socket.string(),
                                 "--out=" + (scratch / "run").string()},
                                scratch / "log")
                            .wait();
    EXPECT_EQ(robot.wait().status, 0);
    return ended;
  }
  /// Of the run directory against that mock's truth.
  nlohmann::json score() {
    const auto json = scratch / "score.json";
    const Ended ended = Program("echomap",
                                {"eval",
                                 (scratch / "run").string(),
                                 "--truth=" + (scratch / "truth").string(),
                                 "--json=" + json.string()},
                                scratch / "eval_log")
                            .wait();
    EXPECT_EQ(ended.status, 0) << ended.said;
    return nlohmann::json::parse(files::read_text_file(json));
  }
  /// Nothing has jumped.
  void expect_right_pose_and_map() {
    EXPECT_LT(summary().at("ate_rmse_m"), 0.15);
    EXPECT_LT(summary().at("final_error_m"), 0.25);
    EXPECT_LT(summary().at("wall_rmse_m"), 0.12);
  }
  nlohmann::json summary() const {
    return nlohmann::json::parse(files::read_text_file(scratch / "run/summary.json"));
  }
  /// What was mapped before the fault is right, and so is what is said.
  void expect_stopped(const Ended& ended,
                      int status,
                      const std::string& outcome,
                      const std::string& said) {
    EXPECT_EQ(ended.status, status) << ended.said;
    EXPECT_THAT(ended.said,
                AllOf(HasSubstr("the map so far is kept: " + said), HasSubstr("next: ")));
    EXPECT_EQ(summary().at("outcome"), outcome);
    EXPECT_GT(summary().at("free_area_m2"), 0.5);
    EXPECT_LT(summary().at("wall_rmse_m"), 0.12);
  }

  tests::ScratchFolder scratch;
};

TEST_F(ExploreFaults, ADeadSonarEndsIt) {
  expect_stopped(run({"--part-faults=sonar-dead@60"}), 1, "sonar-silent", "nothing has answered");
}

TEST_F(ExploreFaults, ASonarThatHangsEndsItAndLeavesTheMapAlone) {
  expect_stopped(
      run({"--part-faults=sonar-stuck@60:inf:0.6"}), 1, "sonar-stuck", "the sonar says one range");
}

TEST_F(ExploreFaults, ADeadEncoderEndsIt) {
  expect_stopped(run({"--part-faults=encoder-left@60"}), 7, "wheel-fault", "a wheel does not turn");
  expect_stopped(
      run({"--part-faults=encoder-right@60", "--seed=2"}), 7, "wheel-fault", "a wheel does not");
}

TEST_F(ExploreFaults, ADeadEncoderEndsTheOtherRobotsToo) {
  for (const auto& [robot, world, strategy] :
       {std::tuple("--robot=ev3", "--world=playground", "--strategy=nxt-farthest"),
        std::tuple("--robot=epuck", "--world=epuck_field", "--strategy=random-bounce"),
        std::tuple("--robot=create", "--world=create_l", "--strategy=coastal")}) {
    const Ended ended = run({"--part-faults=encoder-left@25", robot, world, strategy});
    EXPECT_EQ(ended.status, 7) << robot << ended.said;
    EXPECT_EQ(summary().at("outcome"), "wheel-fault") << robot;
    EXPECT_LT(summary().at("sim_seconds"), 60.0) << robot;
  }
}

TEST_F(ExploreFaults, AWheelThatSlipsAtRestOfTheRobotDoesNothing) {
  EXPECT_EQ(run({"--part-faults=slip-left@1:2:0.3", "--stops=4"}).status, 0);
  EXPECT_EQ(summary().at("outcome"), "stop-limit");
}

/// While the robot turns or drives, at its third and fourth stop.
TEST_F(ExploreFaults, AWheelThatSlipsOnItsWayEndsItWithTheMapKept) {
  for (const auto& [fault, seed] : {std::pair("slip-left@62:2:0.3", "--seed=101"),
                                    std::pair("slip-right@62:2:0.3", "--seed=102"),
                                    std::pair("slip-left@60:2:0.3", "--seed=102")}) {
    const Ended ended = run({"--part-faults", fault, seed});
    EXPECT_EQ(ended.status, 1) << fault << ended.said;
    EXPECT_THAT(ended.said, HasSubstr("the map so far is kept: what the sonar hears is not"));
    EXPECT_EQ(summary().at("outcome"), "lost");
    EXPECT_LT(summary().at("stops"), 8) << "told soon";
    EXPECT_GT(summary().at("free_area_m2"), 0.5);
  }
}

/// By a robot without a wheel-drop switch, so that only its sonar can tell.
TEST_F(ExploreFaults, CarriedOffItStopsAndKeepsItsMap) {
  for (const auto& [seed, kidnap] : {std::pair("1", "80,2,2.2,2.4,-90"),
                                     std::pair("2", "80,2,2.2,2.4,-90"),
                                     std::pair("103", "100,2,2.2,2.4,-90")}) {
    const Ended ended = run_carried_off(seed, kidnap);
    EXPECT_EQ(ended.status, 1) << seed << ended.said;
    EXPECT_THAT(ended.said, HasSubstr("the map so far is kept: what the sonar hears is not"));
    EXPECT_EQ(summary().at("outcome"), "lost");
    EXPECT_LT(score().at("wall_rmse_m"), 0.12) << seed;
  }
}

TEST_F(ExploreFaults, ALineThatIsAwayForFiveSecondsIsWaitedFor) {
  const Ended ended = run({"--faults=away=60:5"});
  EXPECT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, AllOf(HasSubstr("is away: "), HasSubstr("is back after 4.")));
  EXPECT_EQ(summary().at("outcome"), "no-new-ground");
  EXPECT_EQ(summary().at("link").at("outages"), 1);
  expect_right_pose_and_map();
}

TEST_F(ExploreFaults, ALineThatStaysAwayEndsIt) {
  const Ended ended = run({"--faults=away=60:1000"});
  EXPECT_EQ(ended.status, 5);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("the map so far is kept, for lost "), HasSubstr("fallen silent")));
  EXPECT_EQ(summary().at("outcome"), "link-lost");
  EXPECT_GT(summary().at("free_area_m2"), 0.5);
  expect_right_pose_and_map();
}

/// In the midst of a drive, which the truth of the other runs has there.
TEST_F(ExploreFaults, ABoardThatIsResetIsSetUpAgainAndGoesOnFromWhereItWas) {
  for (const char* const fault : {"board-reset@60", "board-reset@62:3"}) {
    const Ended ended = run({"--part-faults", fault});
    EXPECT_EQ(ended.status, 0) << ended.said;
    EXPECT_THAT(ended.said, HasSubstr("the robot was reset (reset line); the pose is kept"));
    EXPECT_EQ(summary().at("outcome"), "no-new-ground");
    EXPECT_EQ(summary().at("link").at("resets"), 1);
    expect_right_pose_and_map();
  }
}

TEST_F(ExploreFaults, AResetThatLosesAStepperEndsIt) {
  const Ended ended =
      run({"--part-faults=board-reset@40", "--robot=nxt_tribot", "--world=nxt_room"});
  EXPECT_EQ(ended.status, 7);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("the map so far is kept, for the robot was reset"),
                    HasSubstr("where the sonar looks")));
  EXPECT_EQ(summary().at("outcome"), "safety-stop");
  EXPECT_LT(summary().at("wall_rmse_m"), 0.12);
}

TEST_F(ExploreFaults, FaultsOfPartsThatTheRobotHasNotAreRefused) {
  const Ended ended = run({"--part-faults=battery-low@3"});
  EXPECT_EQ(ended.status, 6);
  EXPECT_THAT(ended.said, HasSubstr("the robot has no battery"));
  const Ended wrong = run({"--part-faults=sonar-daed@3"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.said, HasSubstr("did you mean 'sonar-dead'"));
}

}  // namespace
}  // namespace echomap::test
