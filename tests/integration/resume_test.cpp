// SPDX-License-Identifier: MIT
/// What becomes of a run that was ended and goes on another day.
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/evaluation/truth_directory.hpp"
#include "host/exports/observations_csv.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "tests/integration/programs.hpp"
#include "tests/support/played_recording.hpp"
#include "tests/support/scratch_folder.hpp"

namespace echomap::test {
namespace {

using ::testing::HasSubstr;

/// At the port of a mock that is started anew for each run.
class Resume : public ::testing::Test {
 protected:
  /// `stops` of a mock that starts as `start` says; its truth goes into `truth_of(out)`.
  Ended explore(const std::string& out,
                const std::vector<std::string>& start,
                const std::vector<std::string>& more = {},
                int stops = 3) {
    const auto socket = scratch / (out + "_lockstep");
    const auto port = scratch / (out + "_robot");
    std::filesystem::create_directories(truth_of(out));
    std::vector<std::string> of_robot{"--link=" + port.string(),
                                      "--lockstep=" + socket.string(),
                                      "--truth=" + truth_of(out).string()};
    of_robot.insert(of_robot.end(), start.begin(), start.end());
    Program robot("echomap-mock", of_robot, scratch / "robot_log");
    EXPECT_TRUE(eventually([&] { return exists(socket) && exists(port); }));
    std::vector<std::string> of_host{"explore",
                                     "--strategy=nxt-farthest",
                                     "--stops=" + std::to_string(stops),
                                     "--port=" + port.string(),
                                     "--lockstep=" + socket.string(),
                                     "--out=" + (scratch / out).string()};
    of_host.insert(of_host.end(), more.begin(), more.end());
    const Ended ended = Program("echomap", of_host, scratch / "log").wait();
    EXPECT_EQ(robot.wait().status, 0);
    return ended;
  }

  std::filesystem::path truth_of(const std::string& out) const {
    return scratch / (out + "_truth");
  }

  /// Where the robot of that run stands, for the next one.
  std::string where_it_stands(const std::string& out) const {
    const auto T_world_robot =
        evaluation::read_truth(truth_of(out)).trajectory.back().T_world_robot;
    return fmt::format("--start={},{},{}",
                       T_world_robot.x_m(),
                       T_world_robot.y_m(),
                       geometry::degrees(T_world_robot.heading_rad()));
  }

  std::string resume(const std::string& out) const {
    return "--resume=" + (scratch / out).string();
  }

  std::string text_of(const std::string& out, const std::string& name) const {
    return files::read_text_file(scratch / out / name);
  }

  /// What the recording of a run holds, as a table.
  std::string observations_of(const std::string& out) const {
    exports::ObservationsCsv table;
    tests::play_recording(scratch / out / recording::kSessionFileName, table);
    table.save(scratch / "observations.csv");
    return files::read_text_file(scratch / "observations.csv");
  }

  nlohmann::json summary(const std::string& out) const {
    return nlohmann::json::parse(text_of(out, "summary.json"));
  }

  /// Of a map that began as the run `first` did.
  nlohmann::json score(const std::string& out, const std::string& first) const {
    const auto json = scratch / (out + "_score.json");
    const Ended ended = Program("echomap",
                                {"eval",
                                 (scratch / out).string(),
                                 "--truth=" + truth_of(first).string(),
                                 "--json=" + json.string()},
                                scratch / "eval_log")
                            .wait();
    EXPECT_EQ(ended.status, 0) << ended.said;
    return nlohmann::json::parse(files::read_text_file(json));
  }

  tests::ScratchFolder scratch;
};

TEST_F(Resume, ARobotGoesOnWhereItStoodAndItsMapGrows) {
  ASSERT_EQ(explore("monday", {}).status, kUnfinished);
  const Ended ended =
      explore("tuesday", {where_it_stands("monday"), "--seed=2"}, {resume("monday")}, 5);
  ASSERT_EQ(ended.status, kUnfinished) << ended.said;

  const auto monday = summary("monday");
  const auto tuesday = summary("tuesday");
  EXPECT_EQ(monday.at("resumed_stops"), nullptr);
  EXPECT_EQ(tuesday.at("resumed_stops"), 3);
  EXPECT_EQ(tuesday.at("stops"), 8);
  EXPECT_EQ(tuesday.at("previous_maps"), 0);
  for (const char* grows : {"sim_seconds", "travelled_m", "poses", "points", "free_area_m2"}) {
    EXPECT_GT(tuesday.at(grows), monday.at(grows)) << grows;
  }
  EXPECT_THAT(observations_of("tuesday"), ::testing::StartsWith(observations_of("monday")));

  const auto before = score("monday", "monday");
  const auto after = score("tuesday", "monday");
  EXPECT_GT(after.at("free_iou"), before.at("free_iou").get<double>() + 0.1);
  EXPECT_GT(after.at("wall_recall"), before.at("wall_recall"));
  EXPECT_LT(after.at("wall_rmse_m"), before.at("wall_rmse_m").get<double>() + 0.02);

  const auto trajectory = exports::read_trajectory_tum(scratch / "tuesday" / "trajectory.tum");
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    EXPECT_LT(trajectory[i - 1].stamp, trajectory[i].stamp) << "row " << i;
  }
}

TEST_F(Resume, TheSameDirectoryHoldsBothRuns) {
  ASSERT_EQ(explore("run", {}).status, kUnfinished);
  const auto stands = where_it_stands("run");
  const std::string recording = text_of("run", "session.mcap");
  const Ended resumed = explore("run", {stands}, {resume("run"), "--slam=none"});
  ASSERT_EQ(resumed.status, kUnfinished);
  EXPECT_GE(summary("run").at("stops"), 5) << resumed.said;
  EXPECT_EQ(text_of("run", "session.before.mcap"), recording);
  EXPECT_FALSE(exists(scratch / "run" / "pose_graph.g2o")) << "that of the run before";
}

TEST_F(Resume, ARunThatWasKilledWhileItRecordedGoesOn) {
  ASSERT_EQ(explore("run", {}).status, kUnfinished);
  const auto stands = where_it_stands("run");
  const std::string recording = text_of("run", "session.mcap");
  files::write_text_file(scratch / "run" / "session.mcap",
                         recording.substr(0, recording.size() / 10 * 9));
  const Ended ended = explore("on", {stands}, {resume("run")}, 1);
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("the recording ends early; everything before was read"));
  EXPECT_GE(summary("on").at("resumed_stops"), 2) << "what came after the last chunk is lost";
}

TEST_F(Resume, AReplayMakesBothRunsAgain) {
  ASSERT_EQ(explore("monday", {}).status, kUnfinished);
  ASSERT_EQ(
      explore("tuesday", {where_it_stands("monday"), "--seed=2"}, {resume("monday")}, 2).status,
      kUnfinished);
  const Ended ended = Program("echomap",
                              {"replay",
                               (scratch / "tuesday" / "session.mcap").string(),
                               "--headless",
                               "--out=" + (scratch / "again").string()},
                              scratch / "log")
                          .wait();
  ASSERT_EQ(ended.status, 0) << ended.said;
  for (const char* file : {"map.pgm", "points.csv", "trajectory.tum", "pose_graph.g2o"}) {
    EXPECT_EQ(text_of("again", file), text_of("tuesday", file)) << file;
  }
}

TEST_F(Resume, ARobotThatWasMovedGoesOnInAnotherMap) {
  ASSERT_EQ(explore("monday", {}).status, kUnfinished);
  const Ended ended = explore("tuesday", {"--start=2.6,1.2,100"}, {resume("monday")}, 6);
  EXPECT_EQ(ended.status, kUnfinished) << ended.said;
  EXPECT_THAT(ended.said, HasSubstr("starting a new map, keeping the old one"));
  const auto tuesday = summary("tuesday");
  EXPECT_EQ(tuesday.at("previous_maps").get<int>() + tuesday.at("maps_joined").get<int>(), 1);
}

TEST_F(Resume, WhatWasThereStaysWhereNoRobotAnswers) {
  ASSERT_EQ(explore("run", {}).status, kUnfinished);
  const std::string recording = text_of("run", "session.mcap");
  const auto before = summary("run");
  const Ended ended = Program("echomap",
                              {"explore",
                               "--port=" + (scratch / "nowhere").string(),
                               resume("run"),
                               "--out=" + (scratch / "run").string()},
                              scratch / "log")
                          .wait();
  EXPECT_EQ(ended.status, 3);
  EXPECT_THAT(ended.said, HasSubstr("next: "));
  EXPECT_EQ(text_of("run", "session.mcap"), recording);
  EXPECT_EQ(summary("run"), before);
}

}  // namespace
}  // namespace echomap::test
