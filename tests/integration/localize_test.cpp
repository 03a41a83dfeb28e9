// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/exports/pgm_yaml.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/drawn_map.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using exports::read_trajectory_tum;
using files::read_text_file;
using files::write_text_file;
using geometry::Pose2;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// `echomap localize` of a simulated robot in lockstep, in the living room that it has mapped.
class Localize : public ::testing::Test {
 protected:
  std::string at(const std::string& name) const { return (scratch / name).string(); }

  /// The run directory "map", which the first test of a process drives for all.
  void explore() {
    static const tests::ScratchFolder explored;
    if (!fs::exists(explored / "map")) {
      const Ended ended = Program("echomap",
                                  {"demo",
                                   "--headless",
                                   "--no-kidnap",
                                   "--emulator=mock",
                                   "--seed=7",
                                   "--out=" + (explored / "map").string()},
                                  scratch / "demo.log")
                              .wait();
      ASSERT_EQ(ended.status, 0) << ended.said;
    }
    fs::create_directory_symlink(explored / "map", at("map"));
  }

  void start_robot(const std::string& program, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "--link=" + at("robot"), "--lockstep=" + at("lockstep"), "--truth=" + at("truth")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    robot = std::make_unique<Program>(program, arguments, scratch / "robot.log");
    ASSERT_TRUE(eventually([&] {
      return fs::exists(scratch / "robot") && fs::exists(scratch / "lockstep");
    })) << read_text_file(scratch / "robot.log");
  }

  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"localize",
                                       "--headless",
                                       "--force",
                                       "--port=" + at("robot"),
                                       "--lockstep=" + at("lockstep"),
                                       "--out=" + at("run")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Ended localize(const std::vector<std::string>& more) {
    Ended ended = Program("echomap", arguments(more), scratch / "log").wait();
    if (robot) {
      robot->wait();
    }
    return ended;
  }

  nlohmann::json summary() const {
    return nlohmann::json::parse(read_text_file(scratch / "run/summary.json"));
  }
  /// Where the robot truly is at the end of the run, in the frame of the map, which begins at the
  /// explorer's start.
  Pose2 truth() const {
    const auto stamp = read_trajectory_tum(scratch / "run/trajectory.tum").back().stamp;
    const Pose2 T_world_map =
        read_trajectory_tum(scratch / "map/truth/truth.tum").front().T_map_robot;
    for (const auto& pose : read_trajectory_tum(scratch / "truth/truth.tum")) {
      if (pose.stamp >= stamp) {
        return T_world_map.inverse() * pose.T_map_robot;
      }
    }
    return {};
  }
  void expect_found() const {
    const auto last = summary();
    EXPECT_EQ(last.at("status"), "localized");
    const auto& place = last.at("hypotheses").at(0);
    EXPECT_LT(std::hypot(place.at("x_m").get<double>() - truth().x_m(),
                         place.at("y_m").get<double>() - truth().y_m()),
              0.2);
    EXPECT_LT(std::abs(geometry::angle_between(place.at("heading_rad").get<double>(),
                                               truth().heading_rad())),
              geometry::radians(12.0));
  }

  tests::ScratchFolder scratch;
  std::unique_ptr<Program> robot;
};

TEST_F(Localize, FindsTheRobotOfARunByWhatTheRunRecorded) {
  explore();
  const Ended ended =
      Program("echomap",
              {"localize", at("map"), "--map=" + at("map"), "--headless", "--out=" + at("run")},
              scratch / "log")
          .wait();
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_EQ(summary().at("status"), "localized");
  const auto run = read_trajectory_tum(scratch / "map/trajectory.tum");
  const auto found = read_trajectory_tum(scratch / "run/trajectory.tum");
  const auto at_the_end = std::find_if(
      run.begin(), run.end(), [&](const auto& pose) { return pose.stamp >= found.back().stamp; });
  ASSERT_NE(at_the_end, run.end());
  const Pose2 apart = at_the_end->T_map_robot.inverse() * found.back().T_map_robot;
  EXPECT_LT(apart.position_m().norm(), 0.2);
  EXPECT_LT(std::abs(apart.heading_rad()), geometry::radians(12.0));
  EXPECT_EQ(summary().at("scans"), found.size()) << "as many scans as stops, silence included";
}

TEST_F(Localize, FindsARobotThatMayBeAnywhere) {
  explore();
  start_robot("echomap-mock", {"--seed=3", "--start=2.6,1.2,100"});
  const Ended ended = localize({"--map=" + at("map"), "--stops=8", "--json=" + at("report.json")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("localized"));
  expect_found();
  EXPECT_EQ(summary().at("stops").size(), 8U);
  EXPECT_EQ(summary().at("outcome"), "stop-limit");
  EXPECT_TRUE(summary().at("robot_fault").is_null());
  EXPECT_EQ(nlohmann::json::parse(read_text_file(scratch / "report.json")), summary());
}

TEST_F(Localize, FindsARobotThatRunsTheBinaryWhichAUserFlashes) {
  if (!fs::exists(ECHOMAP_BINARY_DIR "/bin/echomap-simavr")) {
    GTEST_SKIP() << "echomap-simavr was not built on this machine";
  }
  explore();
  start_robot("echomap-simavr", {"--seed=4", "--start=2.6,1.2,100"});
  const Ended ended = localize({"--map=" + at("map"), "--stops=6"});
  ASSERT_EQ(ended.status, 0) << ended.said;
  expect_found();
  EXPECT_THAT(summary().at("firmware").get<std::string>(), HasSubstr("uno"));
}

TEST_F(Localize, NamesTheFaultOfARobotThatContradictsItself) {
  explore();
  start_robot("echomap-mock", {"--seed=4", "--part-faults=motors-swapped@0"});
  const Ended ended = localize({"--map=" + at("map"), "--stops=4"});
  EXPECT_EQ(ended.status, 9) << ended.said;
  EXPECT_EQ(summary().at("outcome"), "robot-fault");
  EXPECT_EQ(summary().at("robot_fault").at("name"), "both-wheels-against-command");
  EXPECT_TRUE(summary().at("robot_fault").at("log_odds").is_null());
}

TEST_F(Localize, NoticesThatTheRobotWasCarriedOff) {
  explore();
  start_robot("echomap-mock", {"--seed=4", "--kidnap=80,2,3.0,1.0,90"});
  const Ended ended = localize({"--map=" + at("map"), "--stops=12", "--at", "0", "0", "0"});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("lost"));
  expect_found();
}

/// The robot tells it: a wheel hangs.
TEST_F(Localize, GoesOnFromAnywhereWhenTheRobotWasLifted) {
  explore();
  std::string body = read_text_file(ECHOMAP_SOURCE_DIR "/hil_mock/robots/uno_2wd.toml");
  write_text_file(scratch / "body.toml", body + "\n[wiring.native]\npin_4 = \"wheel_drop\"\n");
  std::string profile = read_text_file(ECHOMAP_SOURCE_DIR "/host/profiles/uno_2wd.toml");
  write_text_file(scratch / "profile.toml", profile + "\n[wiring]\npin_4 = \"wheel_drop\"\n");
  start_robot("echomap-mock",
              {"--seed=4", "--robot=" + at("body.toml"), "--kidnap=80,5,3.0,1.0,90"});
  const Ended ended =
      localize({"--map=" + at("map"), "--stops=14", "--robot=" + at("profile.toml")});
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("lifted"));
  EXPECT_EQ(summary().at("times_lifted"), 1);
  expect_found();
}

/// Under an overhead camera whose fixes are a tenth of a second late and of which a fifth is
/// missing. The frame of the fixes is the world's.
class LocalizeUnderACamera : public Localize {
 protected:
  Ended follow(const std::string& kind,
               const std::string& seed,
               const std::vector<std::string>& more = {}) {
    const std::string port = free_port();
    start_robot("echomap-mock",
                {"--seed=" + seed,
                 "--camera=" + kind + ":" + port,
                 "--camera-params=delay=0.1,noise=0.01,drop=0.2"});
    std::vector<std::string> arguments{
        "--filter=ekf", "--fixes=" + kind + ":127.0.0.1:" + port, "--stops=4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return localize(arguments);
  }
  Pose2 true_pose_at(double seconds) const {
    const auto truth = read_trajectory_tum(scratch / "truth/truth.tum");
    for (const auto& pose : truth) {
      if (std::chrono::duration<double>(pose.stamp.time_since_epoch()).count() >= seconds) {
        return pose.T_map_robot;
      }
    }
    return truth.back().T_map_robot;
  }
  /// At every stop; answers how many of the three numbers are off by more than three deviations.
  int check_stops() const {
    int beyond = 0;
    for (const auto& stop : summary().at("stops")) {
      const Pose2 truth = true_pose_at(stop.at("sim_seconds"));
      const auto& place = stop.at("hypotheses").at(0);
      const auto number = [&](const char* key) { return place.at(key).get<double>(); };
      const double x_off_m = number("x_m") - truth.x_m();
      const double y_off_m = number("y_m") - truth.y_m();
      const double off_rad = geometry::angle_between(number("heading_rad"), truth.heading_rad());
      EXPECT_LT(std::hypot(x_off_m, y_off_m), 0.01);
      EXPECT_LT(std::abs(off_rad), geometry::radians(1.5));
      beyond += std::abs(x_off_m) > 3.0 * number("std_x_m") ? 1 : 0;
      beyond += std::abs(y_off_m) > 3.0 * number("std_y_m") ? 1 : 0;
      beyond += std::abs(off_rad) > 3.0 * number("std_heading_rad") ? 1 : 0;
    }
    return beyond;
  }
};

TEST_F(LocalizeUnderACamera, FollowsWithinThreeOfItsDeviations) {
  int beyond = 0;
  for (const char* seed : {"1", "2", "3", "4", "5", "6"}) {
    const Ended ended = follow("udp", seed);
    ASSERT_EQ(ended.status, 0) << ended.said;
    const auto fixes = summary().at("fixes");
    EXPECT_GT(fixes.at("applied"), 300) << seed;
    EXPECT_LE(fixes.at("gated"), 5) << seed;
    EXPECT_EQ(fixes.at("bad_lines"), 0) << seed;
    EXPECT_EQ(summary().at("times_lost"), 0) << seed;
    beyond += check_stops();
  }
  EXPECT_LE(beyond, 1) << "of 72 numbers; 0.2 are to be expected";
}

TEST_F(LocalizeUnderACamera, FetchesFixesFromAServer) {
  const Ended ended = follow("tcp", "5");
  ASSERT_EQ(ended.status, 0) << ended.said;
  EXPECT_LE(check_stops(), 1);
}

TEST_F(LocalizeUnderACamera, SaysThatNoFixComes) {
  start_robot("echomap-mock", {});
  const Ended ended = localize({"--filter=ekf", "--fixes=udp:127.0.0.1:" + free_port()});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.said, AllOf(HasSubstr("no pose arrived"), HasSubstr("next: ")));
}

TEST_F(LocalizeUnderACamera, NamesAServerThatIsMissingAndAnAddressThatIsNone) {
  const Ended missing = localize({"--filter=ekf", "--fixes=tcp:127.0.0.1:" + free_port()});
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.said, AllOf(HasSubstr("no pose measurements"), HasSubstr("next: ")));
  const Ended wrong = localize({"--filter=ekf", "--fixes=127.0.0.1"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.said, HasSubstr("udp:HOST:PORT"));
}

TEST_F(Localize, KeepsItsTrajectoryWhenInterrupted) {
  explore();
  start_robot("echomap-mock", {"--seed=3"});
  Program run("echomap", arguments({"--map=" + at("map"), "--stops=100"}), scratch / "log");
  ASSERT_TRUE(eventually([&] {
    return fs::exists(scratch / "log") &&
           read_text_file(scratch / "log").find("localized") != std::string::npos;
  }));
  run.send(SIGINT);
  const Ended ended = run.wait();
  EXPECT_EQ(ended.status, 130) << ended.said;
  EXPECT_EQ(summary().at("outcome"), "interrupted");
  EXPECT_FALSE(read_trajectory_tum(scratch / "run/trajectory.tum").empty());
}

TEST_F(Localize, SaysWhatIsWrongBeforeARobotIsAsked) {
  fs::create_directories(scratch / "floorless");
  exports::write_pgm_yaml(scratch / "floorless/map.yaml", tests::map_from({"###", "###"}));
  const Ended no_floor = localize({"--map=" + at("floorless"), "--port=/dev/ttyNONE"});
  EXPECT_EQ(no_floor.status, 1);
  EXPECT_THAT(no_floor.said, AllOf(HasSubstr("no floor"), HasSubstr("next: ")));
  const Ended no_map = localize({"--map=" + at("nowhere")});
  EXPECT_EQ(no_map.status, 2);
  EXPECT_THAT(no_map.said, HasSubstr("nowhere"));
  fs::create_directories(scratch / "room");
  exports::write_pgm_yaml(scratch / "room/map.yaml", tests::map_from({"###", "#.#", "###"}));
  const Ended no_sonar =
      localize({"--map=" + at("room"), "--robot=epuck", "--preset=nxt", "--port=/dev/ttyNONE"});
  EXPECT_EQ(no_sonar.status, 6);
  EXPECT_THAT(no_sonar.said, AllOf(HasSubstr("needs a sonar"), HasSubstr("next: ")));
  const Ended strategy =
      localize({"--map=" + at("room"), "--strategy=coastal", "--port=/dev/ttyNONE"});
  EXPECT_EQ(strategy.status, 2);
  EXPECT_THAT(strategy.said, HasSubstr("leave --strategy out"));
}

TEST_F(Localize, NamesAPortThatIsMissing) {
  fs::create_directories(scratch / "room");
  exports::write_pgm_yaml(scratch / "room/map.yaml", tests::map_from({"###", "#.#", "###"}));
  const Ended ended =
      Program("echomap",
              {"localize", "--map=" + at("room"), "--port=/dev/ttyNONE", "--out=" + at("run")},
              scratch / "log")
          .wait();
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said, AllOf(HasSubstr("/dev/ttyNONE"), HasSubstr("next: ")));
}

}  // namespace
}  // namespace echomap::test
