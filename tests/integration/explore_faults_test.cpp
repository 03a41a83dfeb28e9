// SPDX-License-Identifier: MIT
/// What becomes of an exploration when a part fails, the robot is carried off or the line breaks.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <regex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/files/bundled_files.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/every_seed.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using tests::runs_every_seed;

/// The demo on the native mock, without the kidnapping at its end, by a strategy that ends where
/// nothing is new: whether the map has all of the room then is told by its exit code.
class ExploreFaults : public ::testing::Test {
 protected:
  Ended run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "demo", "--emulator=mock", "--no-kidnap", "--force", "--out=" + (scratch / "run").string()};
    if (std::none_of(more.begin(), more.end(), [](const std::string& option) {
          return option.starts_with("--strategy=");
        })) {
      arguments.emplace_back("--strategy=nxt-farthest");
    }
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
                                 "--strategy=nxt-farthest",
                                 "--stops=20",
                                 "--force",
                                 "--seed=" + seed,
                                 "--port=" + port.string(),
                                 "--lockstep=" + socket.string(),
                                 "--out=" + (scratch / "run").string()},
                                scratch / "log")
                            .wait();
    EXPECT_EQ(robot.wait().status, 0);
    return ended;
  }
  /// Maps in four stops, by a robot whose contacts are normally closed or open in its file and
  /// in its profile alike.
  void map_at_a_port(bool normally_closed, const std::string& faults) {
    const auto file = [&](const char* folder, const std::string& table) {
      std::string text = files::read_text_file(files::bundled_file("uno_2wd", folder, "a robot"));
      const std::string value = normally_closed ? "true" : "false";
      const std::size_t at = text.find(table) + table.size();
      text.insert(at, "\ncontacts_normally_closed = " + value);
      const auto path = scratch / (table.substr(1, table.size() - 2) + ".toml");
      files::write_text_file(path, text);
      return "--robot=" + path.string();
    };
    const auto socket = scratch / "lockstep";
    const auto port = scratch / "robot";
    std::filesystem::remove(socket);
    std::vector<std::string> options{"--seed=3",
                                     "--world=nxt_room",
                                     file("hil_mock/robots", "[body]"),
                                     "--link=" + port.string(),
                                     "--lockstep=" + socket.string()};
    if (!faults.empty()) {
      options.push_back("--part-faults=" + faults);
    }
    Program robot("echomap-mock", options, scratch / "robot_log");
    EXPECT_TRUE(eventually([&] { return exists(socket) && exists(port); }));
    const Ended ended = Program("echomap",
                                {"explore",
                                 "--stops=4",
                                 "--force",
                                 "--headless",
                                 "--seed=3",
                                 file("host/profiles", "[safety]"),
                                 "--port=" + port.string(),
                                 "--lockstep=" + socket.string(),
                                 "--out=" + (scratch / "run").string()},
                                scratch / "log")
                            .wait();
    EXPECT_THAT(ended.status, AnyOf(0, kUnfinished)) << ended.said;
    EXPECT_EQ(robot.wait().status, 0);
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
    EXPECT_THAT(ended.status, AnyOf(0, kUnfinished)) << ended.said;
    return nlohmann::json::parse(files::read_text_file(json));
  }
  static bool has_right_pose_and_map(const nlohmann::json& scores) {
    return scores.at("ate_rmse_m") < 0.15 && scores.at("final_error_m") < 0.25 &&
           scores.at("wall_rmse_m") < 0.12;
  }
  /// Nothing has jumped.
  void expect_right_pose_and_map() {
    EXPECT_TRUE(has_right_pose_and_map(summary())) << summary().dump(1);
  }
  /// It counts its way without the hop, by far its longest step.
  void expect_counts_no_hop() {
    const auto trajectory = exports::read_trajectory_tum(scratch / "run/trajectory.tum");
    double travelled_m = 0.0;
    double longest_m = 0.0;
    for (std::size_t i = 1; i < trajectory.size(); ++i) {
      const double step_m =
          (trajectory[i].T_map_robot.position_m() - trajectory[i - 1].T_map_robot.position_m())
              .norm();
      travelled_m += step_m;
      longest_m = std::max(longest_m, step_m);
    }
    EXPECT_GT(longest_m, 0.1);
    EXPECT_NEAR(summary().at("travelled_m"), travelled_m - longest_m, 0.01);
  }
  /// How long it goes on at most, as every half minute tells it; seconds.
  static std::vector<double> told_left_s(const std::string& said) {
    const std::regex told("driven in [0-9:]+, ([0-9]+):([0-9]+) left at most");
    std::vector<double> left_s;
    for (std::sregex_iterator i(said.begin(), said.end(), told); i != std::sregex_iterator(); ++i) {
      left_s.push_back(60.0 * std::stod((*i)[1]) + std::stod((*i)[2]));
    }
    return left_s;
  }
  /// The stamps of the trajectory rise, from the start to the end, whatever the board's clock does.
  void expect_steady_time() {
    const auto trajectory = exports::read_trajectory_tum(scratch / "run/trajectory.tum");
    constexpr std::chrono::seconds kLongestGap(4);
    for (std::size_t i = 1; i < trajectory.size(); ++i) {
      EXPECT_LT(trajectory[i - 1].stamp, trajectory[i].stamp) << i;
      EXPECT_LT(trajectory[i].stamp - trajectory[i - 1].stamp, kLongestGap) << i;
    }
    const std::chrono::duration<double> end = trajectory.back().stamp.time_since_epoch();
    EXPECT_NEAR(end.count(), summary().at("sim_seconds"), 5.0);
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
                AllOf(HasSubstr("the map so far is saved: " + said), HasSubstr("next: ")));
    EXPECT_EQ(summary().at("outcome"), outcome);
    EXPECT_GT(summary().at("free_area_m2"), 0.5);
    EXPECT_LT(summary().at("wall_rmse_m"), 0.12);
  }

  tests::ScratchFolder scratch;
};

TEST_F(ExploreFaults, ADeadSonarEndsIt) {
  expect_stopped(
      run({"--part-faults=sonar-dead@60"}), 1, "sonar-silent", "the sonar does not answer");
}

/// Within three pings, and long before it ends for that.
TEST_F(ExploreFaults, ASonarThatIsUnpluggedOrWhoseLineHangsIsNamedAtOnce) {
  for (const std::string fault : {"sonar-dead@0", "sonar-dead@20", "sonar-high@20"}) {
    const Ended ended = run({"--part-faults=" + fault, "--world=nxt_room"});
    EXPECT_EQ(summary().at("outcome"), "sonar-silent") << fault;
    const std::size_t named = ended.said.find("warning: the sonar does not answer");
    const std::size_t end = ended.said.find("not finished");
    EXPECT_LT(named, end) << fault << ended.said;
    EXPECT_EQ(ended.said.find("the sonar answers again"), std::string::npos) << fault;
  }
}

/// Every ping of it is heard by nobody, and each holds the echo line for 200 ms.
TEST_F(ExploreFaults, ASlowSonarInALargeHallIsNoDeadOne) {
  const auto hall = scratch / "hall.toml";
  files::write_text_file(hall, R"(name = "hall"
[start]
x_m = 15.0
y_m = 15.0
heading_deg = 20.0
[room]
corners_m = [[0.0, 0.0], [30.0, 0.0], [30.0, 30.0], [0.0, 30.0]]
)");
  const Ended ended = run({"--part-faults=sonar-slow@0", "--world=" + hall.string(), "--stops=1"});
  EXPECT_EQ(ended.said.find("sonar does not answer"), std::string::npos) << ended.said;
  EXPECT_EQ(summary().at("outcome"), "stop-limit") << ended.said;
  EXPECT_GT(summary().at("sim_seconds"), 12.0) << "60 pings of 200 ms";
}

TEST_F(ExploreFaults, ADirtyEncoderIsNamedWithItsWheel) {
  const Ended ended =
      run({"--part-faults=encoder-right-dirty@0:inf:0.02", "--world=nxt_room", "--stops=6"});
  EXPECT_THAT(ended.said, HasSubstr("warning: the right encoder loses"));
  EXPECT_THAT(ended.said, HasSubstr("clean the right encoder's disc"));
  EXPECT_EQ(summary().at("robot_fault").at("name"), "right-encoder-dirty");
  EXPECT_EQ(summary().at("link").at("robot_left_encoder_errors"), 0);
  EXPECT_GT(summary().at("link").at("robot_right_encoder_errors"), 10);
}

TEST_F(ExploreFaults, NormallyClosedContactsAreNoBumpUntilTheirWireBreaks) {
  map_at_a_port(false, "");
  EXPECT_EQ(summary().at("outcome"), "stop-limit");
  const double mapped_m2 = summary().at("free_area_m2");
  map_at_a_port(true, "");
  EXPECT_EQ(summary().at("outcome"), "stop-limit");
  EXPECT_NEAR(summary().at("free_area_m2"), mapped_m2, 0.5);
  map_at_a_port(true, "contact-left-broken@10");
  EXPECT_NE(summary().at("outcome"), "stop-limit") << "it drives backwards only";
  EXPECT_LT(summary().at("free_area_m2"), mapped_m2 - 0.5);
}

TEST_F(ExploreFaults, ASonarThatHangsEndsItAndLeavesTheMapAlone) {
  expect_stopped(run({"--part-faults=sonar-stuck@60:inf:0.6"}),
                 1,
                 "sonar-stuck",
                 "the sonar returns the same range");
}

TEST_F(ExploreFaults, ADeadEncoderEndsIt) {
  expect_stopped(
      run({"--part-faults=encoder-left@60"}), 9, "robot-fault", "the left wheel does not turn");
  expect_stopped(run({"--part-faults=encoder-right@60", "--seed=2"}),
                 9,
                 "robot-fault",
                 "the right wheel does not turn");
}

TEST_F(ExploreFaults, ADeadEncoderEndsTheOtherRobotsToo) {
  for (const auto& [robot, world, strategy, status, outcome] :
       {std::tuple(
            "--robot=ev3_mega", "--world=playground", "--strategy=nxt-farthest", 9, "robot-fault"),
        std::tuple(
            "--robot=epuck", "--world=epuck_field", "--strategy=random-bounce", 7, "wheel-fault"),
        std::tuple("--robot=create", "--world=create_l", "--strategy=coastal", 7, "wheel-fault")}) {
    const Ended ended = run({"--part-faults=encoder-left@25", robot, world, strategy});
    EXPECT_EQ(ended.status, status) << robot << ended.said;
    EXPECT_EQ(summary().at("outcome"), outcome) << robot;
    EXPECT_LT(summary().at("sim_seconds"), 60.0) << robot;
  }
}

TEST_F(ExploreFaults, AWheelThatSlipsAtRestOfTheRobotDoesNothing) {
  EXPECT_EQ(run({"--part-faults=slip-left@1:2:0.3", "--stops=4"}).status, kUnfinished);
  EXPECT_EQ(summary().at("outcome"), "stop-limit");
}

/// While the robot turns or drives, at its third and fourth stop.
/// Not each is noticed, as a slip that looks like poor odometry.
TEST_F(ExploreFaults, AWheelThatSlipsOnItsWaySeldomSpoilsTheMap) {
  int runs = 0;
  int right = 0;
  std::vector<const char*> faults{"slip-left@60", "slip-right@62"};
  if (runs_every_seed()) {
    faults.insert(faults.end(), {"slip-right@60", "slip-left@62"});
  }
  for (const char* fault : faults) {
    for (int seed = 101; seed <= (runs_every_seed() ? 102 : 101); ++seed) {
      const Ended ended =
          run({"--part-faults", fault + std::string(":2:0.3"), "--seed=" + std::to_string(seed)});
      EXPECT_THAT(ended.status, AnyOf(0, kUnfinished)) << fault << seed << ended.said;
      right += has_right_pose_and_map(summary()) ? 1 : 0;
      ++runs;
    }
  }
  EXPECT_GE(4 * right, 3 * runs) << right << " of " << runs;
}

/// By a robot without a wheel-drop switch, so that only its sonar can tell.
TEST_F(ExploreFaults, CarriedOffItMapsOnAndMostlyFindsItsFormerMapAgain) {
  const int seeds = runs_every_seed() ? 8 : 4;
  int joined = 0;
  int wrong = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Ended ended = run_carried_off(std::to_string(seed), "80,2,2.2,2.4,-90");
    EXPECT_THAT(ended.status, AnyOf(0, kUnfinished)) << seed << ended.said;
    if (summary().at("maps_joined") == 0) {
      continue;
    }
    EXPECT_THAT(ended.said,
                AllOf(HasSubstr("starting a new map, keeping the old one"),
                      HasSubstr("the two maps are now one")));
    if (!has_right_pose_and_map(score())) {
      ++wrong;
      continue;
    }
    expect_counts_no_hop();
    const auto left_s = told_left_s(ended.said);
    ASSERT_GE(left_s.size(), 4U) << ended.said;
    EXPECT_LT(*std::max_element(left_s.begin(), left_s.end()), 1.5 * left_s.front())
        << seed << ": it does not start again with the map\n"
        << ended.said;
    joined += summary().at("previous_maps") == 0 && !exists(scratch / "run/previous_1") ? 1 : 0;
  }
  EXPECT_GE(4 * joined, 3 * seeds) << joined << " of " << seeds;
  EXPECT_LE(wrong, 1) << "of 20 seeds one noticed it 3.5 minutes later";
}

TEST_F(ExploreFaults, CarriedOffAfterItsFirstStopItKeepsTwoMapsAndBothAreRight) {
  const Ended ended = run_carried_off("1", "40,2,2.2,2.4,-90");
  EXPECT_THAT(ended.status, AnyOf(0, kUnfinished)) << ended.said;
  EXPECT_THAT(
      ended.said,
      HasSubstr("the previous map could not be aligned with it and is saved in previous_1"));
  EXPECT_EQ(summary().at("previous_maps"), 1);
  EXPECT_EQ(summary().at("maps_joined"), 0);
  const auto scores = score();
  EXPECT_LT(scores.at("ate_rmse_m"), 0.15) << "from where the map begins";
  EXPECT_LT(scores.at("wall_rmse_m"), 0.12);
  EXPECT_GT(scores.at("free_iou"), 0.75);
  for (const char* const file : {"map.png", "map.yaml", "trajectory.tum", "points.csv"}) {
    EXPECT_TRUE(exists(scratch / "run/previous_1" / file)) << file;
  }
  const auto previous =
      nlohmann::json::parse(files::read_text_file(scratch / "run/previous_1/summary.json"));
  EXPECT_EQ(previous.at("outcome"), "set-aside");
  EXPECT_GT(previous.at("stops"), 0);
}

/// Its waypoints lie in the map that it began.
TEST_F(ExploreFaults, AStrategyThatGoesByMoreThanItsMapEndsWhereTheRobotIsLost) {
  const Ended ended = run({"--robot=ev3_mega",
                           "--world=playground",
                           "--strategy=tangent-bug",
                           "--waypoints=playground",
                           "--seed=2",
                           "--part-faults=slip-left@60:8:0.6"});
  EXPECT_EQ(ended.status, 1) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("the map so far is saved: sonar readings contradict the map"));
  EXPECT_EQ(summary().at("outcome"), "lost");
}

TEST_F(ExploreFaults, ALineThatIsAwayForFiveSecondsIsWaitedFor) {
  const Ended ended = run({"--faults=away=60:5"});
  EXPECT_THAT(ended.status, AnyOf(0, kUnfinished)) << ended.said;
  EXPECT_THAT(ended.said, AllOf(HasSubstr("is disconnected: "), HasSubstr("reconnected after 4.")));
  EXPECT_EQ(summary().at("outcome"), "no-new-ground");
  EXPECT_EQ(summary().at("link").at("outages"), 1);
  expect_right_pose_and_map();
}

TEST_F(ExploreFaults, ALineThatStaysAwayEndsIt) {
  const Ended ended = run({"--faults=away=60:1000"});
  EXPECT_EQ(ended.status, 5);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("the map so far is saved: lost "), HasSubstr("stopped sending")));
  EXPECT_EQ(summary().at("outcome"), "link-lost");
  EXPECT_GT(summary().at("free_area_m2"), 0.5);
  expect_right_pose_and_map();
}

/// In the midst of a drive, which the truth of the other runs has there.
TEST_F(ExploreFaults, ABoardThatIsResetIsSetUpAgainAndGoesOnFromWhereItWas) {
  for (const char* const fault : {"board-reset@60", "board-reset@62:3"}) {
    const Ended ended = run({"--part-faults", fault});
    EXPECT_THAT(ended.status, AnyOf(0, kUnfinished)) << ended.said;
    EXPECT_THAT(ended.said, HasSubstr("the robot was reset (reset line); keeping the pose"));
    EXPECT_EQ(summary().at("outcome"), "no-new-ground");
    EXPECT_EQ(summary().at("link").at("resets"), 1);
    EXPECT_FALSE(summary().at("pose_stddev_m").is_null()) << "SLAM runs";
    expect_right_pose_and_map();
    expect_steady_time();
  }
}

TEST_F(ExploreFaults, AResetThatLosesAStepperEndsIt) {
  const Ended ended =
      run({"--part-faults=board-reset@40", "--robot=nxt_tribot", "--world=nxt_room"});
  EXPECT_EQ(ended.status, 7);
  EXPECT_THAT(ended.said,
              AllOf(HasSubstr("the map so far is saved: the robot was reset"),
                    HasSubstr("the direction of the sonar")));
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
